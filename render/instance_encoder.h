// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an instance of a patch into what lies in the buffer.
//
// What it guarantees:
//  1. Coordinates become `(p - origin) * scale`, computed in double and not rounded further.
//  2. What leaves the buffer's range of +-kDrawingLimit is cut to it along its own line (segments, rays, lines), so
//     that the part anybody can see stays where it is. Disks, circles and arcs that large show nothing: doubles do
//     not say any more where their rim is.
//  3. A number that is not finite gives an instance that shows nothing.
#pragma once

#include <algorithm>
#include <span>

#include "core/draw/patch.h"
#include "core/draw/primitives.h"

namespace mes::render {

/// Coordinates beyond this many drawings away are cut; squares of their differences still fit a float.
inline constexpr double kDrawingLimit = 0x1p60;

/// What the culling of programs wants to know about a set of instances. Only ever grows, until the set is replaced.
struct InstanceExtent {
  double coordinate = 0.0;  ///< largest absolute value
  double radius = 0.0;
  double length = 0.0;  ///< of arcs
  void add(const InstanceExtent& other) {
    coordinate = std::max(coordinate, other.coordinate);
    radius = std::max(radius, other.radius);
    length = std::max(length, other.length);
  }
};

/// `in` holds `stride_of(kind)` doubles, `out` has room for `layout_of(kind).doubles()`.
void encode_instance(PrimitiveKind kind, const DrawingFrame& frame, std::span<const double> in, std::span<double> out,
                     InstanceExtent& extent);

}  // namespace mes::render
