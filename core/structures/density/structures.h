// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/density/curve_sampling.h"
#include "core/structures/density/feature_size.h"
#include "core/structures/inputs/curve_source_input.h"
#include "core/structures/inputs/samples.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_density_structures(Registry& registry) {
  registry.add_structure<CurveSampling, CurveSourceInput, Samples, Delaunay, OneStepCrust>();
  registry.add_structure<FeatureSize, Delaunay, OneStepCrust, CurveSampling>();
}

}  // namespace mes
