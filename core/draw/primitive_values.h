// SPDX-License-Identifier: GPL-3.0-or-later
// Conversions from layer instances to geometry.
#pragma once

#include "core/base/geometry/arc.h"
#include "core/base/geometry/parabola_arc.h"
#include "core/draw/primitives.h"

namespace mes {

/// True for a segment instance whose ends are equal.
constexpr bool is_zero_length(const double* segment) {
  return segment[0] == segment[2] && segment[1] == segment[3];
}

/// Converts an arc instance.
constexpr Arc arc_of(const double* values) {
  return {{values[0], values[1]}, values[2], {values[3], values[4]}, {values[5], values[6]}};
}

/// Converts a parabola instance.
constexpr ParabolaArc parabola_of(const double* values) {
  return {{values[0], values[1]}, {values[2], values[3]}, {values[4], values[5]}};
}

}  // namespace mes
