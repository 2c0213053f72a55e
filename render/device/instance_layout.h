// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of one instance in a buffer: the bits of its coordinates in drawing space, as doubles.
//
// A layout is a list of columns, each a vertex attribute of two or four 32-bit words: one or two doubles. The locations
// of attributes count from 0 in this order. The scalar of an instance is in a buffer of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/draw/primitives.h"

namespace mes::render {

struct InstanceLayout {
  std::uint8_t points = 0;   ///< columns of two doubles
  std::uint8_t numbers = 0;  ///< columns of one double, after the points
  constexpr std::size_t doubles() const { return std::size_t{2} * points + numbers; }
  constexpr std::size_t bytes() const { return sizeof(double) * doubles(); }
};

constexpr InstanceLayout layout_of(PrimitiveKind kind) {
  constexpr std::array<InstanceLayout, kPrimitiveKinds> layouts{{
      {.points = 1, .numbers = 0},  // point: position
      {.points = 1, .numbers = 1},  // disk: centre, radius
      {.points = 1, .numbers = 1},  // circle: centre, radius
      {.points = 2, .numbers = 0},  // segment: both ends
      {.points = 2, .numbers = 0},  // ray: start, unit direction
      {.points = 2, .numbers = 0},  // line: a point, unit direction
      {.points = 3, .numbers = 0},  // triangle: corners
      {.points = 3, .numbers = 2},  // arc: centre, both ends; radius, and 0: at most half a turn, 1: more, 2: whole
      {.points = 3, .numbers = 0},  // parabola: one end, control point, other end
  }};
  return layouts[static_cast<std::size_t>(kind)];
}

}  // namespace mes::render
