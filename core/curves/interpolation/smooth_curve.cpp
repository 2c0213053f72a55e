// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/interpolation/smooth_curve.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace mes {
namespace {

/// The derivative at `p` of the parabola through three points, with knots spaced by the square roots of distances.
Vec2 tangent_at(Vec2 before, Vec2 p, Vec2 after, double first, double second) {
  const Vec2 back = 1.0 / first * (p - before);
  const Vec2 on = 1.0 / second * (after - p);
  return 1.0 / (first + second) * (second * back + first * on);
}

}  // namespace

PlaneCurve smooth_curve(std::span<const Vec2> points, bool is_closed, double corner_angle) {
  std::vector<Vec2> at;
  for (const Vec2 p : points)
    if (at.empty() || at.back() != p) at.push_back(p);
  if (is_closed && at.size() > 1 && at.front() == at.back()) at.pop_back();
  PlaneCurve out(at.front());
  const std::size_t count = at.size();
  if (count < 2) return out;
  is_closed = is_closed && count > 2;

  const std::size_t pieces = is_closed ? count : count - 1;
  std::vector<double> knots(pieces);
  for (std::size_t i = 0; i < pieces; ++i) knots[i] = std::sqrt(distance(at[i], at[(i + 1) % count]));
  std::vector<std::optional<Vec2>> tangents(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_closed && (i == 0 || i + 1 == count)) continue;
    const std::size_t before = (i + count - 1) % count;
    const Vec2 back = at[i] - at[before];
    const Vec2 on = at[(i + 1) % count] - at[i];
    if (std::abs(std::atan2(cross(back, on), dot(back, on))) > corner_angle) continue;
    tangents[i] = tangent_at(at[before], at[i], at[(i + 1) % count], knots[before], knots[i]);
  }
  for (std::size_t i = 0; i < pieces; ++i) {
    const std::size_t next = (i + 1) % count;
    const Vec2 from = at[i];
    const Vec2 to = at[next];
    if (!tangents[i] && !tangents[next]) {
      out.line_to(to);
      continue;
    }
    const double third = knots[i] / 3.0;
    if (tangents[i] && tangents[next]) {
      out.cubic_to(from + third * *tangents[i], to - third * *tangents[next], to);
      continue;
    }
    // A parabola leads to a corner: one control point, in the direction of the other end.
    out.quadratic_to(tangents[i] ? from + 1.5 * third * *tangents[i] : to - 1.5 * third * *tangents[next], to);
  }
  if (is_closed) out.close();
  return out;
}

}  // namespace mes
