// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/object_angle.h"

#include <cmath>
#include <numbers>

namespace mes {

AngleLimit::AngleLimit(double degrees)
    : degrees_(degrees),
      cosine_(std::cos(degrees * (std::numbers::pi / 180.0))),
      sine_(std::sin(degrees * (std::numbers::pi / 180.0))) {}

CornerBits AngleLimit::corner_by_angle(Vec2 p, Vec2 q, Vec2 r) const {
  const double angle = angle_at(p, q, r);
  const double product = dot(q - p, r - p);
  constexpr double kLeast = 1e-280;  // below, products may have lost their sign
  const bool is_not_obtuse = std::abs(product) > kLeast ? product > 0.0 : angle <= 90.0;
  return static_cast<CornerBits>((folded(angle) >= degrees_ ? kAngleReaches : 0U) |
                                 (is_not_obtuse ? kNotObtuse : 0U));
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
