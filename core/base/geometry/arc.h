// SPDX-License-Identifier: GPL-3.0-or-later
// A circular arc, counter-clockwise from one point to another. Plain data.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"

namespace mes {

/// The ends lie on the circle up to rounding. Equal ends mean the whole circle.
struct Arc {
  Vec2 center{};
  double radius = 0.0;
  Vec2 from{}, to{};
  friend bool operator==(const Arc&, const Arc&) = default;
};

/// The angle that the arc spans, in [0, 2 pi]; exactly 2 pi for a whole circle.
inline double sweep_of(const Arc& arc) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (arc.from == arc.to) return kTurn;
  const Vec2 a = arc.from - arc.center;
  const Vec2 b = arc.to - arc.center;
  const double size = std::max(length(a), length(b));
  const Vec2 start{a.x / size, a.y / size};
  // Uses the chord instead of `b`: the difference of close ends is exact, and a short arc keeps its sign.
  const Vec2 chord{(arc.to.x - arc.from.x) / size, (arc.to.y - arc.from.y) / size};
  const double angle = std::atan2(cross(start, chord), dot(start, {b.x / size, b.y / size}));
  return angle >= 0.0 ? angle : angle + kTurn;
}

/// The box of both ends and of the extreme points (right, up, left, down) of the circle that lie on the arc.
inline Box2 bounding_box_of(const Arc& arc) {
  const Box2 circle = bounding_box_of(Disk{arc.center, arc.radius});
  const double sweep = sweep_of(arc);
  if (arc.from == arc.to) return circle;
  const Vec2 a = arc.from - arc.center;
  const Vec2 b = arc.to - arc.center;
  const auto holds = [&](Vec2 direction) {
    const bool after_from = cross(a, direction) >= 0.0;
    const bool before_to = cross(direction, b) >= 0.0;
    return sweep <= std::numbers::pi ? after_from && before_to : after_from || before_to;
  };
  Box2 box;
  box.add(arc.from);
  box.add(arc.to);
  if (holds({1.0, 0.0})) box.high.x = std::max(box.high.x, circle.high.x);
  if (holds({0.0, 1.0})) box.high.y = std::max(box.high.y, circle.high.y);
  if (holds({-1.0, 0.0})) box.low.x = std::min(box.low.x, circle.low.x);
  if (holds({0.0, -1.0})) box.low.y = std::min(box.low.y, circle.low.y);
  return box;
}

}  // namespace mes
