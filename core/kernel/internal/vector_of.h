// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of the plane over any ring, for predicates that evaluate one formula in several number types.
#pragma once

#include "core/base/geometry/vec2.h"

namespace mes {

template <class Number>
struct VectorOf {
  Number x, y;
};

/// Exact where the subtraction of Number is exact.
template <class Number>
VectorOf<Number> vector_between(Vec2 from, Vec2 to) {
  return {Number{to.x} - Number{from.x}, Number{to.y} - Number{from.y}};
}

template <class Number>
Number cross_of(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return u.x * v.y - u.y * v.x;
}

template <class Number>
Number dot_of(const VectorOf<Number>& u, const VectorOf<Number>& v) {
  return u.x * v.x + u.y * v.y;
}

}  // namespace mes
