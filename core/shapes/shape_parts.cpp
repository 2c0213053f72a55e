// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/internal/shape_parts.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace mes {

PlaneCurve ellipse_curve(Vec2 center, double a, double b, bool is_hole) {
  const Vec2 start = center + Vec2{a, 0.0};
  PlaneCurve out(start);
  out.arc_to({center, {a, 0.0}, {0.0, b}, 0.0, is_hole ? -kTurn : kTurn}, start);
  out.close();
  return out;
}

PlaneCurve polygon_curve(std::span<const Vec2> corners) {
  PlaneCurve out(corners.front());
  for (const Vec2 corner : corners.subspan(1)) out.line_to(corner);
  out.close();
  return out;
}

Expected<PlaneCurve> curve_of_function(const PointOf& at, double from, double to, std::size_t pieces,
                                       bool may_close) {
  const double step = (to - from) / static_cast<double>(pieces);
  const double small = 1e-4 * step;
  const auto place = [&](std::size_t i) { return i == pieces ? to : from + static_cast<double>(i) * step; };
  std::vector<Vec2> ends;
  double extent = 0.0;
  for (std::size_t i = 0; i <= pieces; ++i) {
    ends.push_back(at(place(i)));
    if (!is_finite(ends.back()))
      return std::unexpected(
          Error{ErrorCode::bad_input, fmt::format("the formula gives no finite number at t = {:.6g}", place(i))});
    extent = std::max(extent, distance(ends.front(), ends.back()));
  }
  constexpr double kRounding = 1e-9;
  if (may_close && distance(ends.front(), ends.back()) <= kRounding * extent) ends.back() = ends.front();
  // Second-order derivatives from inside the piece only, so that a corner between pieces stays a corner.
  const auto derivative = [&](double t, Vec2 here, double h) {
    const Vec2 out = (0.5 / h) * (4.0 * at(t + h) - at(t + 2.0 * h) - 3.0 * here);
    return is_finite(out) ? out : Vec2{};
  };
  PlaneCurve out(ends.front());
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vec2 first = derivative(place(i), at(place(i)), small);
    const Vec2 last = derivative(place(i + 1), at(place(i + 1)), -small);
    out.cubic_to(ends[i] + (step / 3.0) * first, ends[i + 1] - (step / 3.0) * last, ends[i + 1]);
  }
  if (may_close && ends.back() == ends.front()) out.close();
  return out;
}

}  // namespace mes
