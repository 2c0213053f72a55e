// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/object_angle.h"

#include <cmath>
#include <numbers>

namespace mes {
EdgeAngles edge_angles(const EdgeCorners& corners) {
  return {angle_at(corners.p, corners.q, corners.r), angle_at(*corners.s, corners.r, corners.q)};
}

Vec2 place_of_angle(Vec2 q, Vec2 r, double degrees) {
  const double cotangent = std::tan((90.0 - degrees) * (std::numbers::pi / 180.0));
  const Vec2 middle{0.5 * q.x + 0.5 * r.x, 0.5 * q.y + 0.5 * r.y};
  return middle + (0.5 * cotangent) * perpendicular(r - q);
}

}  // namespace mes
