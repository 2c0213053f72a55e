// SPDX-License-Identifier: GPL-3.0-or-later
// An affine map of the plane. Plain data.
#pragma once

#include <cmath>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Maps (x, y) to (a x + c y + e, b x + d y + f): the six numbers in the order of `matrix(...)` in SVG.
struct Affine {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

  static constexpr Affine translation(double x, double y) { return {1.0, 0.0, 0.0, 1.0, x, y}; }
  static constexpr Affine scaling(double x, double y) { return {x, 0.0, 0.0, y, 0.0, 0.0}; }
  /// Counter-clockwise if y points up.
  static Affine rotation(double radians) {
    const double cosine = std::cos(radians);
    const double sine = std::sin(radians);
    return {cosine, sine, -sine, cosine, 0.0, 0.0};
  }

  constexpr Vec2 of_point(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// Maps a difference of points: applies the linear part only.
  constexpr Vec2 of_vector(Vec2 v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  /// Composition: applies `inner` first, then this map.
  constexpr Affine operator*(const Affine& inner) const {
    const Vec2 first = of_vector({inner.a, inner.b});
    const Vec2 second = of_vector({inner.c, inner.d});
    const Vec2 moved = of_point({inner.e, inner.f});
    return {first.x, first.y, second.x, second.y, moved.x, moved.y};
  }
  friend constexpr bool operator==(const Affine&, const Affine&) = default;
};

}  // namespace mes
