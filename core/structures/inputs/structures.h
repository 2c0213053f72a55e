// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/inputs/center_line_ends.h"
#include "core/structures/inputs/contours.h"
#include "core/structures/inputs/curve_source_input.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/scaled_user_balls.h"
#include "core/structures/inputs/settings_source.h"
#include "core/structures/inputs/shared_borders.h"
#include "core/structures/inputs/user_balls.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_input_structures(Registry& registry) {
  for (const Parameter& parameter : computation_parameters()) registry.add_parameter(parameter);
  registry.add_structure<Samples>();
  registry.add_structure<SettingsSource>();
  registry.add_structure<UserBalls>();
  registry.add_structure<CurveSourceInput>();
  registry.add_structure<CenterLineEnds>();
  registry.add_structure<ScaledUserBalls, SettingsSource, UserBalls>();
  registry.add_structure<Contours, Samples>();
  registry.add_structure<SharedBorders, Samples>();
}

}  // namespace mes
