// SPDX-License-Identifier: GPL-3.0-or-later
// Points, balls, their ids, exact predicates, and the primitives that layers draw. Plain values without invariants.
//
// Guarantees:
//  1. The types are trivially copyable and have no significant padding: a `Point` is two doubles, a `Ball` three.
//  2. Within a workbench, an id names the same sample or ball through undo and redo, and is never reused.
//     `Workbench::load` and `open` assign new ids.
//
// Coordinates are doubles in the unit of the document. Accepted numbers are 0 and those from 2^-500 to 2^500 in
// magnitude; the largest of a document may be 2^100 times the smallest.
//
// Smallest use:
//     const mesecina::Ball ball{{0.0, 1.0}, 0.5};
//     const double top = ball.center.y + ball.radius;
//     const bool is_left = mesecina::orientation({0.0, 0.0}, {1.0, 0.0}, ball.center) > 0;
//
// Threads: plain values.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <mesecina/version.h>

namespace mesecina {
inline namespace v1 {

struct Point {
  double x = 0.0;
  double y = 0.0;
  friend constexpr bool operator==(const Point&, const Point&) = default;
};

/// A closed disk of the plane. The radius is not negative.
struct Ball {
  Point center{};
  double radius = 0.0;
  friend constexpr bool operator==(const Ball&, const Ball&) = default;
};

/// Identifiers of samples and of balls do not convert into each other.
struct SampleId {
  std::uint32_t value = 0xffffffffU;
  friend constexpr auto operator<=>(const SampleId&, const SampleId&) = default;
};
struct BallId {
  std::uint32_t value = 0xffffffffU;
  friend constexpr auto operator<=>(const BallId&, const BallId&) = default;
};

/// New positions for `Workbench::move` and `Workbench::change_balls`.
struct MovedSample {
  SampleId id{};
  Point to{};
};
struct ChangedBall {
  BallId id{};
  Ball to{};
};

// Exact predicates return the sign of a quantity, -1, 0 or 1, without any rounding. Numbers must be finite. O(1).

/// 1: a, b, c turn counter-clockwise; 0: they are collinear.
MESECINA_API int orientation(Point a, Point b, Point c);
/// 1: d lies inside the circle through a, b, c; 0: on it; if a, b, c turn clockwise, the other sign.
MESECINA_API int side_of_circle(Point a, Point b, Point c, Point d);
/// 1: c lies inside the circle with the diameter ab; 0: on it.
MESECINA_API int side_of_diametral_circle(Point a, Point b, Point c);
/// 1: the power of d to the orthogonal circle of a, b, c is less than its squared radius, so that their triangle is not
/// regular; if the centres of a, b, c turn clockwise, the other sign.
MESECINA_API int side_of_power_circle(const Ball& a, const Ball& b, const Ball& c, const Ball& d);
/// The sign of |ab| - |cd|.
MESECINA_API int compare_distances(Point a, Point b, Point c, Point d);
/// The sign of the difference of the circumradii of a, b, c and d, e, f. Collinear points have a circle that is larger
/// than any other.
MESECINA_API int compare_circumradii(Point a, Point b, Point c, Point d, Point e, Point f);

/// A known curve through the samples, for data whose order is known.
struct Contour {
  bool is_closed = true;
  std::vector<std::uint32_t> points{};  ///< indices into `Data::samples`
  friend bool operator==(const Contour&, const Contour&) = default;
};

/// A set of samples and balls, as in a file.
struct Data {
  std::vector<Point> samples{};
  std::vector<Contour> contours{};
  std::vector<Ball> balls{};
  friend bool operator==(const Data&, const Data&) = default;
};

/// The kinds of primitives that a layer draws. An instance is `doubles_per(kind)` coordinates followed by one scalar:
///
///   point     x y                segment   x1 y1 x2 y2
///   disk      x y r              ray       x y dx dy            from (x, y) towards (dx, dy)
///   circle    x y r              line      x y dx dy            through (x, y), both ways
///   triangle  x1 y1 x2 y2 x3 y3  arc       x y r x1 y1 x2 y2
///   parabola  x1 y1 xc yc x2 y2
///
/// An arc runs counter-clockwise along the circle (x, y) r from (x1, y1) to (x2, y2); equal ends are the whole circle.
/// A parabola is an arc of one: a quadratic Bézier curve from (x1, y1) to (x2, y2) with the control point (xc, yc).
/// All coordinates are finite. Directions are not zero, and need not have length 1. Layers without a scalar give 0.
enum class PrimitiveKind : std::uint8_t {
  point = 0,
  disk = 1,
  circle = 2,
  segment = 3,
  ray = 4,
  line = 5,
  triangle = 6,
  arc = 7,
  parabola = 8,
};

constexpr std::size_t doubles_per(PrimitiveKind kind) noexcept {
  constexpr std::size_t kCounts[] = {2, 3, 3, 4, 4, 4, 6, 7, 6};
  return kCounts[static_cast<std::size_t>(kind)];
}
/// Doubles of one instance: its coordinates and its scalar.
constexpr std::size_t stride_of(PrimitiveKind kind) noexcept {
  return doubles_per(kind) + 1;
}
/// "point", "disk", ...
constexpr std::string_view name_of(PrimitiveKind kind) noexcept {
  constexpr std::string_view kNames[] = {"point", "disk",     "circle", "segment", "ray",
                                         "line",  "triangle", "arc",    "parabola"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// The instances of one kind of one layer, in place. Valid until the first run after an edit, a change of settings, or
/// the end of the layer's display.
struct Instances {
  PrimitiveKind kind = PrimitiveKind::point;
  std::span<const double> values{};  ///< `stride_of(kind)` doubles for each instance

  std::size_t size() const { return values.size() / stride_of(kind); }
  bool empty() const { return values.empty(); }
  /// Coordinates of one instance, followed by its scalar.
  std::span<const double> operator[](std::size_t i) const {
    return values.subspan(i * stride_of(kind), stride_of(kind));
  }
};

}  // namespace v1
}  // namespace mesecina
