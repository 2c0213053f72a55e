// SPDX-License-Identifier: GPL-3.0-or-later
// A repeatedly divided rectangle: outlines that share borders, where corners of some lie within sides of others.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/rng.h"
#include "core/curves/curve.h"

namespace mes::test {

struct Parcels {
  std::vector<Box2> boxes;           ///< before the rotation
  std::vector<PlaneCurve> outlines;  ///< rotated by the angle, coordinates rounded to `decimals` decimals
};

inline PlaneCurve closed_polygon(const std::vector<Vec2>& corners) {
  PlaneCurve out(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i) out.line_to(corners[i]);
  out.close();
  return out;
}

inline Vec2 turned(Vec2 p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

/// `count` rectangles in one of 100 x 60, none narrower than 4. An outline has only its own corners, not those of
/// others on its sides. Some outlines are clockwise.
inline Parcels parcels(std::size_t count, double angle, int decimals, std::uint64_t seed) {
  Rng rng(seed);
  Parcels out;
  out.boxes.push_back({{0.0, 0.0}, {100.0, 60.0}});
  constexpr double kNarrow = 4.0;
  for (int tries = 0; out.boxes.size() < count && tries < 10'000; ++tries) {
    const std::size_t i = rng.below(out.boxes.size());
    const Box2 box = out.boxes[i];
    const bool across = box.width() > box.height();
    const double size = across ? box.width() : box.height();
    if (size < 2.0 * kNarrow) continue;
    const double at = (across ? box.low.x : box.low.y) + rng.uniform(kNarrow, size - kNarrow);
    Box2 other = box;
    (across ? out.boxes[i].high.x : out.boxes[i].high.y) = at;
    (across ? other.low.x : other.low.y) = at;
    out.boxes.push_back(other);
  }
  const double scale = std::pow(10.0, decimals);
  for (const Box2& box : out.boxes) {
    std::vector<Vec2> corners{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    if (rng.below(3) == 0) std::swap(corners[1], corners[3]);
    for (Vec2& p : corners) {
      p = turned(p, angle);
      p = {std::round(p.x * scale) / scale, std::round(p.y * scale) / scale};
    }
    out.outlines.push_back(closed_polygon(corners));
  }
  return out;
}

}  // namespace mes::test
