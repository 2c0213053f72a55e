// SPDX-License-Identifier: GPL-3.0-or-later
// Balls in the number type of a kernel, and the conversion of positions back to doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/base/geometry/vec2.h"
#include "core/base/power_of_two.h"
#include "core/kernel/ball_signs.h"
#include "core/kernel/kernels.h"
#include "core/kernel/rounding.h"
#include "core/structures/balls/internal/local_frame.h"
#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// Like `ball_in`, before scaling.
template <class Number>
BallOf<Number> plain_ball_in(const PipelineBall& ball) {
  if constexpr (std::is_same_v<Number, double>) {
    const Vec2 c = ball.disk.center;
    if (ball.origin == BallOrigin::disk) return {c.x, c.y, ball.disk.radius * ball.disk.radius};
    const Vec2 d = ball.corner[0] - c;
    return {c.x, c.y, dot(d, d)};
  } else {
    if (ball.origin != BallOrigin::circumdisk) {
      const Number x(ball.disk.center.x), y(ball.disk.center.y);
      if (ball.origin == BallOrigin::disk) {
        const Number r(ball.disk.radius);
        return {x, y, r * r};
      }
      const Number dx = Number(ball.corner[0].x) - x, dy = Number(ball.corner[0].y) - y;
      return {x, y, dx * dx + dy * dy};
    }
    const Number ax(ball.corner[0].x), ay(ball.corner[0].y);
    const Number ux = Number(ball.corner[1].x) - ax, uy = Number(ball.corner[1].y) - ay;
    const Number vx = Number(ball.corner[2].x) - ax, vy = Number(ball.corner[2].y) - ay;
    const Number uu = ux * ux + uy * uy;
    const Number vv = vx * vx + vy * vy;
    const Number twice = Number(2) * (ux * vy - uy * vx);
    const Number dx = (vy * uu - uy * vv) / twice;
    const Number dy = (ux * vv - vx * uu) / twice;
    return {ax + dx, ay + dy, dx * dx + dy * dy};
  }
}

/// Squared radius and centre in the field of the kernel: computed from samples exactly if the field is exact.
template <class Number>
BallOf<Number> ball_in(const PipelineBall& ball) {
  BallOf<Number> out = plain_ball_in<Number>(ball);
  if (ball.scale == 1.0) return out;
  if constexpr (std::is_same_v<Number, double>) {
    // Uses the radius that is drawn: a disk of that radius is the same ball.
    out.w = ball.origin == BallOrigin::disk ? ball.radius() * ball.radius() : out.w * (ball.scale * ball.scale);
  } else {
    const Number scale(ball.scale);
    out.w = out.w * (scale * scale);
  }
  return out;
}

/// A coordinate of the frame in the document, rounded once; `local` is the coordinate rounded in the frame.
template <class Number>
double coordinate_in_document(const Number& exact, double local, double origin, int exponent) {
  if constexpr (!std::is_same_v<Number, double>) {
    if (origin != 0.0) return rounded(Number(exact * Number(std::ldexp(1.0, exponent)) + Number(origin)));
  }
  return origin + times_power_of_two(local, exponent);
}

/// A point in both systems of coordinates.
struct PlacedPoint {
  Vec2 local;
  Vec2 document;
};
template <class Number>
PlacedPoint placed(const Number& x, const Number& y, const LocalFrame& frame) {
  const Vec2 local{rounded(x), rounded(y)};
  return {local,
          {coordinate_in_document(x, local.x, frame.origin.x, frame.exponent),
           coordinate_in_document(y, local.y, frame.origin.y, frame.exponent)}};
}

/// Rounds a point of CGAL.
template <class Point>
PlacedPoint place_of(const Point& p, const LocalFrame& frame) {
  return placed(p.x(), p.y(), frame);
}
/// Rounds the centre of the circle through three points of CGAL, which are not collinear.
template <class Point>
PlacedPoint place_of_circumcenter(const Point& p, const Point& q, const Point& r, const LocalFrame& frame) {
  const auto center = CGAL::circumcenter(p, q, r);
  return placed(center.x(), center.y(), frame);
}

}  // namespace mes
