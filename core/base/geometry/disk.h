// SPDX-License-Identifier: GPL-3.0-or-later
// A disk in the plane, the ball of the two-dimensional literature. Plain data; the radius is not negative.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/vec2.h"

namespace mes {

struct Disk {
  Vec2 center{};
  double radius = 0.0;
  friend bool operator==(const Disk&, const Disk&) = default;
};

inline bool is_finite(const Disk& disk) {
  return is_finite(disk.center) && std::isfinite(disk.radius);
}

/// Finite for a finite disk: coordinates beyond the largest double are clamped to it.
inline Box2 bounding_box_of(const Disk& disk) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return {{std::max(-kMost, disk.center.x - disk.radius), std::max(-kMost, disk.center.y - disk.radius)},
          {std::min(kMost, disk.center.x + disk.radius), std::min(kMost, disk.center.y + disk.radius)}};
}

}  // namespace mes
