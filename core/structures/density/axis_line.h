// SPDX-License-Identifier: GPL-3.0-or-later
// One edge of the axis, on either side of the curve, and the distances of points from it.
#pragma once

#include <cstdint>

#include "core/base/geometry/box_tree.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// An edge of the axis on the bisector of q and r: the points at heights `low` to `high` over the middle of qr, to the
/// left of q -> r. Either may be infinite.
struct alignas(64) AxisLine {
  Vec2 q{};
  Vec2 along{};  ///< unit vector from q to r
  double half = 0.0;
  double low = 0.0;
  double high = 0.0;
  EdgeSlot edge{};
  /// One end is the centre of a nearly flat triangle, more than `kSteep` times `half` away, at an unknown distance.
  bool is_steep = false;

  double squared_distance(Vec2 p) const {
    const Vec2 u = p - q;
    const double aside = dot(u, along) - half;
    const double height = cross(along, u);
    const double rest = height - (height < low ? low : (height > high ? high : height));
    return aside * aside + rest * rest;
  }
  /// Squared distance of the edge from q and r; no sample is nearer to it.
  double squared_reach() const {
    const double rest = low > 0.0 ? low : (high < 0.0 ? high : 0.0);
    return half * half + rest * rest;
  }
  TreeBounds bounds() const;
};

/// The end of an edge may be wrong by this fraction of its distance from q, unless the edge is steep.
inline constexpr double kHeightError = 0x1p-10;
inline constexpr double kSteep = 0x1p40;

/// The dual of `edge`, which lies between two triangles or at the hull. Coordinates are multiplied by `unit`, after
/// which the squares of their differences are normal doubles.
AxisLine axis_line(const Delaunay& delaunay, EdgeSlot edge, double unit);

}  // namespace mes
