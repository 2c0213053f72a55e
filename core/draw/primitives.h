// SPDX-License-Identifier: GPL-3.0-or-later
// The primitives of layers. One instance is `doubles_per(kind)` coordinates followed by one scalar:
//
//   point     x y            | s        segment   x1 y1 x2 y2          | s
//   disk      x y r          | s        ray       x y dx dy            | s   from (x, y) towards (dx, dy)
//   circle    x y r          | s        line      x y dx dy            | s   through (x, y), both ways
//                                       triangle  x1 y1 x2 y2 x3 y3    | s
//   parabola  x1 y1 xc yc x2 y2    | s    arc       x y r x1 y1 x2 y2    | s
//
// An arc runs counter-clockwise along the circle (x, y) r from its point (x1, y1) to (x2, y2); equal ends mean the
// whole circle. It stores ends, not angles: a double angle places an end no better than the radius times its last bit.
// A parabola is an arc of one, as a quadratic Bézier curve from (x1, y1) to (x2, y2) with the control point (xc, yc).
// Coordinates are finite and in document units. Directions of rays and lines are not zero and need not have unit
// length. The scalar is for colour maps; layers without one write 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mes {

enum class PrimitiveKind : std::uint8_t { point, disk, circle, segment, ray, line, triangle, arc, parabola };
inline constexpr std::size_t kPrimitiveKinds = 9;
inline constexpr std::array<PrimitiveKind, kPrimitiveKinds> kAllPrimitiveKinds{
    PrimitiveKind::point, PrimitiveKind::disk,     PrimitiveKind::circle, PrimitiveKind::segment, PrimitiveKind::ray,
    PrimitiveKind::line,  PrimitiveKind::triangle, PrimitiveKind::arc,    PrimitiveKind::parabola};

/// Number of coordinates of one instance, without the scalar.
constexpr std::size_t doubles_per(PrimitiveKind kind) {
  constexpr std::array<std::size_t, kPrimitiveKinds> counts{2, 3, 3, 4, 4, 4, 6, 7, 6};
  return counts[static_cast<std::size_t>(kind)];
}

/// Number of doubles of one instance in a patch: coordinates and scalar.
constexpr std::size_t stride_of(PrimitiveKind kind) {
  return doubles_per(kind) + 1;
}

/// Name in singular and lower case: "point", "disk", ...
constexpr std::string_view name_of(PrimitiveKind kind) {
  constexpr std::array<std::string_view, kPrimitiveKinds> names{"point", "disk",     "circle", "segment", "ray",
                                                                "line",  "triangle", "arc",    "parabola"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace mes
