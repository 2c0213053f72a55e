// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which points a closed stroke encloses.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Whether a closed polygon surrounds the point, by the even-odd rule; the last corner is joined to the first. Points
/// on the polygon may count either way. Fewer than three corners enclose nothing. Cost: O(corners).
inline bool encloses(std::span<const Vec2> polygon, Vec2 p) {
  bool out = false;
  if (polygon.size() < 3) return out;
  Vec2 a = polygon.back();
  for (const Vec2 b : polygon) {
    // The edge crosses the horizontal line through the point, on its right.
    if ((a.y > p.y) != (b.y > p.y) && p.x - a.x < (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) out = !out;
    a = b;
  }
  return out;
}

}  // namespace mes
