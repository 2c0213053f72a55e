// SPDX-License-Identifier: GPL-3.0-or-later
// An evolution of a parameter: the lunes of the beta-skeleton grow, and the skeleton loses edges from step to step.
//
// It moves beta-skeleton-beta, so it is loaded after beta_skeleton.cpp. From the Gabriel graph (beta 1) it goes through the
// relative neighbourhood graph (beta 2); for beta > 2 the skeleton of a connected set may fall apart (D. Kirkpatrick,
// J. Radke, A framework for computational morphology, in Computational Geometry, 1985).
//
//   mesecina shape.poff --with beta_skeleton.cpp --with beta_skeleton_growing.cpp
#include <mesecina/experiment.h>

using namespace mesecina;

MESECINA_EXPERIMENT(experiment) {
  experiment.add_evolution({.id = "beta-skeleton-growing",
                            .name = "Beta grows",
                            .description = "The beta-skeleton loses edges as its lunes grow",
                            .parameters = {{.id = "beta-skeleton-growing-step",
                                            .description = "What a step adds to beta",
                                            .low = 0.01,
                                            .high = 1.0,
                                            .default_value = 0.1}},
                            .moved_parameter = "beta-skeleton-beta"},
                           [](double first, std::uint64_t step, std::span<const double> values) {
                             return first + static_cast<double>(step) * values[0];
                           });
}
