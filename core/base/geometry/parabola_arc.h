// SPDX-License-Identifier: GPL-3.0-or-later
// An arc of a parabola as a quadratic Bézier curve, which is exact. Plain data.
//
// Slopes are those against the tangent at the vertex of the parabola. Slope and Bézier parameter are linear functions
// of each other.
//
// Cost: O(1), and O(corners) for `corners_of` and `distance_to`. Threads: any.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/vec2.h"

namespace mes {

/// The curve (1 - t)^2 from + 2 t (1 - t) control + t^2 to, with t from 0 to 1. The tangents at both ends meet in the
/// control point. It is a straight piece if the control point lies between the ends.
struct ParabolaArc {
  Vec2 from{}, control{}, to{};
  friend bool operator==(const ParabolaArc&, const ParabolaArc&) = default;
};

inline Vec2 point_at(const ParabolaArc& arc, double t) {
  const Vec2 first = arc.from + t * (arc.control - arc.from);
  const Vec2 second = arc.control + t * (arc.to - arc.control);
  return first + t * (second - first);
}

/// The part with parameters from `low` to `high`.
inline ParabolaArc part_of(const ParabolaArc& arc, double low, double high) {
  if (low == 0.0 && high == 1.0) return arc;
  const Vec2 first = arc.from + low * (arc.control - arc.from);
  const Vec2 second = arc.control + low * (arc.to - arc.control);
  return {point_at(arc, low), first + high * (second - first), point_at(arc, high)};
}

/// Calls `use` for slopes between those of the ends, in order. A chord from one to the next, on a parabola of any size,
/// leaves it by at most 1/1024 of the distance from the focus there.
template <class Use>
void for_each_slope_between(double first, double last, Use use) {
  // With slope sinh(u), a chord over a step s of u leaves the arc by at most s^2 / 4 of that distance.
  constexpr double kStep = 1.0 / 16.0;
  const double u = std::asinh(first);
  const double v = std::asinh(last);
  const auto steps = static_cast<int>(std::ceil(std::abs(v - u) / kStep));
  for (int i = 1; i < steps; ++i) use(std::sinh(u + (v - u) * i / steps));
}

/// The slopes at both ends.
struct ParabolaSlopes {
  double first = 0.0;
  double last = 0.0;
  double width = 0.0;  ///< extent of the arc along the tangent at the vertex
  bool is_curved() const { return std::isfinite(first) && std::isfinite(last) && first != last; }
};

inline ParabolaSlopes slopes_of(const ParabolaArc& arc) {
  const Vec2 start = 2.0 * (arc.control - arc.from);
  const Vec2 bend = (arc.to - arc.control) - (arc.control - arc.from);
  const double across = std::abs(cross(start, bend));
  const double first = dot(start, bend) / across;
  return {first, first + 2.0 * dot(bend, bend) / across, across / length(bend)};
}

/// Corners of a chain of chords, from end to end (`for_each_slope_between`).
inline std::vector<Vec2> corners_of(const ParabolaArc& arc) {
  std::vector<Vec2> out{arc.from};
  if (const ParabolaSlopes slopes = slopes_of(arc); slopes.is_curved())
    for_each_slope_between(slopes.first, slopes.last, [&](double slope) {
      out.push_back(point_at(arc, (slope - slopes.first) / (slopes.last - slopes.first)));
    });
  out.push_back(arc.to);
  return out;
}

inline double length_of(const ParabolaArc& arc) {
  const ParabolaSlopes slopes = slopes_of(arc);
  const double chord = distance(arc.from, arc.to);
  if (!slopes.is_curved()) return chord;
  // The integral of the root of 1 + slope^2, with slopes sinh(u) and sinh(v). The difference of u and v is that of the
  // chord if the arc is nearly straight, so it is not computed as a difference.
  const auto [a, b, width] = slopes;
  const double rise = b - a;
  const double root_a = std::hypot(1.0, a);
  const double root_b = std::hypot(1.0, b);
  const double turn =
      a * b > 0.0 ? std::asinh(rise * ((a + b) / (b * root_a + a * root_b))) : std::asinh(b) - std::asinh(a);
  const double sum = std::asinh(a) + std::asinh(b);
  const double out = 0.5 * width * (std::cosh(sum) * (std::sinh(turn) / rise) + turn / rise);
  return std::isfinite(out) ? out : chord;
}

inline Box2 bounding_box_of(const ParabolaArc& arc) {
  Box2 box;
  box.add(arc.from);
  box.add(arc.to);
  const auto extreme = [](double from, double control, double to) {
    return (from - control) / ((from - control) + (to - control));
  };
  for (const double t : {extreme(arc.from.x, arc.control.x, arc.to.x), extreme(arc.from.y, arc.control.y, arc.to.y)})
    if (t > 0.0 && t < 1.0) box.add(point_at(arc, t));
  return box;
}

inline double distance_to(const ParabolaArc& arc, Vec2 p) {
  // Begins at the nearest chord. Newton's method then finds where the curve is perpendicular to the way there.
  constexpr int kSteps = 4;
  const ParabolaSlopes slopes = slopes_of(arc);
  double best = distance(arc.from, p);
  double nearest = 0.0;
  double before = 0.0;
  const auto look_up_to = [&](double t) {
    const Vec2 a = point_at(arc, before);
    const Vec2 way = point_at(arc, t) - a;
    const double squared = dot(way, way);
    const double part = squared > 0.0 ? std::clamp(dot(p - a, way) / squared, 0.0, 1.0) : 0.0;
    if (const double reach = distance(a + part * way, p); reach < best) {
      best = reach;
      nearest = before + part * (t - before);
    }
    before = t;
  };
  if (slopes.is_curved())
    for_each_slope_between(slopes.first, slopes.last,
                           [&](double slope) { look_up_to((slope - slopes.first) / (slopes.last - slopes.first)); });
  look_up_to(1.0);
  const Vec2 bend = (arc.to - arc.control) - (arc.control - arc.from);
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 from_p = point_at(arc, nearest) - p;
    const Vec2 along = 2.0 * ((arc.control - arc.from) + nearest * bend);
    const double steepness = dot(along, along) + 2.0 * dot(from_p, bend);
    if (!(steepness > 0.0)) break;
    nearest = std::clamp(nearest - dot(from_p, along) / steepness, 0.0, 1.0);
  }
  return distance(point_at(arc, nearest), p);
}

}  // namespace mes
