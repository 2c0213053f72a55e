// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/axis_center_lines.h"
#include "core/structures/filters/cover_axis.h"
#include "core/structures/filters/cover_dates.h"
#include "core/structures/filters/lambda_axis.h"
#include "core/structures/inputs/center_line_ends.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_filter_structures(Registry& registry) {
  registry.add_structure<LambdaAxis, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis>();
  registry.add_structure<AngleAxis, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis>();
  registry.add_structure<AxisCenterLines, SettingsSource, Samples, CenterLineEnds, OneStepCrust, InnerBalls,
                         LambdaAxis, AngleAxis>();
  registry.add_structure<CoverDates, Delaunay, InnerBalls>();
  registry
      .add_structure<CoverAxis, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis, CoverDates>();
}

}  // namespace mes
