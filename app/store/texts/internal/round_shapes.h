// SPDX-License-Identifier: GPL-3.0-or-later
// Round shapes for formats that know only straight sides.
#pragma once

#include <vector>

#include "core/base/geometry/arc.h"

namespace mes {

/// Sides per turn: the polygon stays within a thousandth of the radius of the circle.
inline constexpr int kSidesOfTurn = 96;

/// Corners along the arc, from end to end, counter-clockwise; for a whole turn the first one is repeated.
inline std::vector<Vec2> corners_of(const Arc& arc) {
  const double sweep = sweep_of(arc);
  const int sides = std::max(1, static_cast<int>(std::ceil(sweep / (2.0 * std::numbers::pi) * kSidesOfTurn)));
  const Vec2 start = arc.from - arc.center;
  const double angle = std::atan2(start.y, start.x);
  std::vector<Vec2> out{arc.from};
  for (int i = 1; i < sides; ++i) {
    const double at = angle + sweep * i / sides;
    out.push_back(arc.center + arc.radius * Vec2{std::cos(at), std::sin(at)});
  }
  out.push_back(arc.to);
  return out;
}
inline std::vector<Vec2> corners_of(const Disk& disk) {
  const Vec2 start = disk.center + Vec2{disk.radius, 0.0};
  return corners_of(Arc{disk.center, disk.radius, start, start});
}

}  // namespace mes
