// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/object_angle.h"

#include <cmath>
#include <numbers>

namespace mes {

AngleLimit::AngleLimit(double degrees)
    : degrees_(degrees),
      cosine_(std::cos(degrees * (std::numbers::pi / 180.0))),
      sine_(std::sin(degrees * (std::numbers::pi / 180.0))) {}

bool AngleLimit::is_reached_at(Vec2 p, Vec2 q, Vec2 r) const {
  const Vec2 u = q - p;
  const Vec2 v = r - p;
  // The tangent of the folded angle is |det| / |dot|. Where rounding may decide, or products leave the range of
  // doubles, the angle itself does.
  const double more = std::abs(cross(u, v)) * cosine_ - std::abs(dot(u, v)) * sine_;
  const double size = dot(u, u) * dot(v, v);  // squared
  if (size > 0x1p-900 && size < 0x1p900 && more * more > 1e-24 * size) return more > 0.0;
  return folded(angle_at(p, q, r)) >= degrees_;
}

EdgeAngles edge_angles(const EdgeCorners& corners) {
  return {angle_at(corners.p, corners.q, corners.r), angle_at(*corners.s, corners.r, corners.q)};
}

Vec2 place_of_angle(Vec2 q, Vec2 r, double degrees) {
  const double cotangent = std::tan((90.0 - degrees) * (std::numbers::pi / 180.0));
  const Vec2 middle{0.5 * q.x + 0.5 * r.x, 0.5 * q.y + 0.5 * r.y};
  return middle + (0.5 * cotangent) * perpendicular(r - q);
}

}  // namespace mes
