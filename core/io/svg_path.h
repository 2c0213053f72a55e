// SPDX-License-Identifier: GPL-3.0-or-later
// The data of paths of SVG. Private to core/io.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/job_control.h"
#include "core/curves/curve.h"

namespace mes {

struct SvgPath {
  std::vector<PlaneCurve> curves;    ///< a curve for each subpath that has a piece
  std::optional<std::size_t> fault;  ///< where the data stop making sense; what comes before is read
};

/// Every command, relative and absolute. Stops at a fault, as those who draw do. Cost: linear in the text. Any thread.
/// Throws `Cancelled` if there is a job, whose progress is left alone.
SvgPath read_svg_path(std::string_view data, const JobControl* job = nullptr);

/// The points of a polyline, or of a polygon, up to the first fault: no curve for less than two. The rest as above.
SvgPath read_svg_points(std::string_view points, bool is_closed, const JobControl* job = nullptr);

}  // namespace mes
