// SPDX-License-Identifier: GPL-3.0-or-later
// An axis-aligned box. The default box is empty; adding it to another box changes nothing.
#pragma once

#include <algorithm>
#include <limits>

#include "core/base/geometry/vec2.h"

namespace mes {

struct Box2 {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(low.x <= high.x && low.y <= high.y); }
  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void add(const Box2& other) {
    if (other.is_empty()) return;
    add(other.low);
    add(other.high);
  }
  bool contains(Vec2 p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
  /// Halves before adding, so that boxes near the largest double have a finite centre.
  Vec2 center() const { return {0.5 * low.x + 0.5 * high.x, 0.5 * low.y + 0.5 * high.y}; }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  friend bool operator==(const Box2&, const Box2&) = default;
};

/// Touching counts. False if one is empty.
inline bool overlap(const Box2& a, const Box2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

}  // namespace mes
