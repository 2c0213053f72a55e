// SPDX-License-Identifier: GPL-3.0-or-later
// Path data of SVG. Private to core/io.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

struct SvgPath {
  std::vector<PlaneCurve> curves;    ///< a curve for each subpath that has a piece
  std::optional<std::size_t> fault;  ///< position of the first invalid data; everything before is read
};

/// Reads every command, relative and absolute. Stops at a fault, like renderers. Cost: linear in the text. Any thread.
/// Throws `Cancelled` if there is a job, whose progress stays unchanged.
SvgPath read_svg_path(std::string_view data, const JobControl* job = nullptr);

/// Reads the points of a polyline or polygon up to the first fault; less than two make no curve. Otherwise as above.
SvgPath read_svg_points(std::string_view points, bool is_closed, const JobControl* job = nullptr);

}  // namespace mes
