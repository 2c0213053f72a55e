// SPDX-License-Identifier: GPL-3.0-or-later
// The list of evolutions, in the order of the menu. A new one needs a file that defines its function, and two lines
// here.
#include <memory>
#include <utility>

#include "core/evolutions/evolution.h"
#include "core/graph/registry.h"

namespace mes {

Evolution smooth_evolution();
Evolution subdivide_evolution();
Evolution noise_evolution();
Evolution a_growing_evolution();
Evolution a_shrinking_evolution();
Evolution p_growing_evolution();
Evolution p_shrinking_evolution();
Evolution b_growing_evolution();
Evolution b_shrinking_evolution();
Evolution scale_axis_growing_evolution();
Evolution scale_axis_shrinking_evolution();
Evolution scale_skeleton_evolution();
Evolution alpha_growing_evolution();
Evolution alpha_shrinking_evolution();

void add_evolutions(Registry& registry) {
  for (const auto make : {smooth_evolution, subdivide_evolution, noise_evolution, a_growing_evolution,
                          a_shrinking_evolution, p_growing_evolution, p_shrinking_evolution, b_growing_evolution,
                          b_shrinking_evolution, scale_axis_growing_evolution, scale_axis_shrinking_evolution,
                          scale_skeleton_evolution, alpha_growing_evolution, alpha_shrinking_evolution}) {
    auto evolution = std::make_shared<const Evolution>(make());
    registry.evolutions().add(evolution->descriptor.id, evolution);
  }
}

}  // namespace mes
