// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/builtins/builtins.h"

#include "core/evolutions/evolution.h"
#include "core/io/format_spec.h"
#include "core/layers/layers.h"
#include "core/shapes/shape.h"
#include "core/structures/alpha/structures.h"
#include "core/structures/axis/structures.h"
#include "core/structures/balls/structures.h"
#include "core/structures/certificate/structures.h"
#include "core/structures/crust/structures.h"
#include "core/structures/delaunay/structures.h"
#include "core/structures/density/structures.h"
#include "core/structures/filters/structures.h"
#include "core/structures/inputs/structures.h"
#include "core/structures/outline/structures.h"
#include "core/structures/poles/structures.h"

namespace mes {

void add_builtins(Registry& registry) {
  add_input_structures(registry);
  add_delaunay_structures(registry);
  add_crust_structures(registry);
  add_axis_structures(registry);
  add_filter_structures(registry);
  add_density_structures(registry);
  add_alpha_structures(registry);
  add_certificate_structures(registry);
  add_ball_structures(registry);
  add_pole_structures(registry);
  add_outline_structures(registry);
  add_layers(registry);
  add_evolutions(registry);
  add_formats(registry.formats());
  for (const ShapeDescriptor& shape : shapes())
    registry.shapes().add(shape.id, std::make_shared<const ShapeDescriptor>(shape));
}

const Registry& builtins() {
  static const Registry registry = [] {
    Registry out;
    add_builtins(out);
    return out;
  }();
  return registry;
}

}  // namespace mes
