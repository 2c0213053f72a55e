// SPDX-License-Identifier: GPL-3.0-or-later
// Encodes an instance of a patch in the form stored in the buffer.
//
// Guarantees:
//  1. Coordinates become `(p - origin) * scale`, computed in double and not rounded further.
//  2. Segments, rays and lines that leave the buffer's range of +-kDrawingLimit are cut to it along their own line, so
//     their visible part does not move. Disks, circles, arcs and parabolas that large are invisible: doubles do not determine
//     where their rim is.
//  3. An instance with a number that is not finite is invisible.
#pragma once

#include <algorithm>
#include <span>

#include "core/draw/patch.h"
#include "core/draw/primitives.h"

namespace mes::render {

/// The range of coordinates, in sizes of the drawing. Squares of differences within it are finite as floats.
inline constexpr double kDrawingLimit = 0x1p60;

/// Bounds of a set of instances, for choosing programs. They only grow until the set is replaced.
struct InstanceExtent {
  double coordinate = 0.0;  ///< largest absolute value of all coordinates
  double radius = 0.0;
  double length = 0.0;  ///< largest length of an arc; of parabolas, four times the largest distance from a chord
  void add(const InstanceExtent& other) {
    coordinate = std::max(coordinate, other.coordinate);
    radius = std::max(radius, other.radius);
    length = std::max(length, other.length);
  }
};

/// `in` holds `stride_of(kind)` doubles; `out` has the size `layout_of(kind).doubles()`. Enlarges `extent` by the
/// instance.
void encode_instance(PrimitiveKind kind, const DrawingFrame& frame, std::span<const double> in, std::span<double> out,
                     InstanceExtent& extent);

}  // namespace mes::render
