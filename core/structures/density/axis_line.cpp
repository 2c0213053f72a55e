// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/axis_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mes {
namespace {

/// A rounded cotangent is off by some 3 (1 + cot^2) / |cot| units in the last place; above this one, by more than
/// `kHeightError`.
constexpr double kSteepest = 2.0 * kSteep;

}  // namespace

// Heights are half the edge times the cotangent of the opposite angle, as in `Delaunay::dual_length`: computed from
// differences of samples, not from centres, which may be far away.
AxisLine axis_line(const Delaunay& delaunay, EdgeSlot edge, double unit) {
  const auto place_of = [&](SiteSlot site) {
    const Vec2 at = delaunay.site_position(site);
    return Vec2{at.x * unit, at.y * unit};
  };
  const EdgeRow& row = delaunay.edge(edge);
  const Vec2 ends[2] = {place_of(row.v[0]), place_of(row.v[1])};
  // Neither the order of the ends nor the corner of the apex follows a pattern: both are found without a branch.
  const bool is_less = ends[1].x < ends[0].x;
  const bool is_as_far = ends[1].x <= ends[0].x;
  const auto first = static_cast<std::size_t>(is_less | (is_as_far & (ends[1].y < ends[0].y)));
  AxisLine out;
  out.edge = edge;
  out.q = ends[first];
  const Vec2 r = ends[1 - first];
  const Vec2 d = r - out.q;
  const double length = std::sqrt(dot(d, d));
  out.along = {d.x / length, d.y / length};
  out.half = 0.5 * length;
  const auto height = [&](FaceSlot face) {
    const FaceRow& corners = delaunay.face(face);
    const SiteSlot apex = corners.v[(corners.e[1] == edge ? 1U : 0U) | (corners.e[2] == edge ? 2U : 0U)];
    if (apex == kInfiniteSite) return std::numeric_limits<double>::infinity();
    const Vec2 at = place_of(apex);
    const Vec2 u = out.q - at;
    const Vec2 v = r - at;
    const double cotangent = dot(u, v) / std::abs(cross(u, v));
    out.is_steep = out.is_steep || !(std::abs(cotangent) < kSteepest);
    return out.half * cotangent;
  };
  // One triangle lies on the left of q -> r, the other on the right; where one is missing, the bisector goes on.
  const double left = height(row.f[first]);
  const double right = height(row.f[1 - first]);
  out.high = std::max(left, -right);
  out.low = std::min(left, -right);
  return out;
}

TreeBounds AxisLine::bounds() const {
  const Vec2 middle = q + half * along;
  const Vec2 up = perpendicular(along);
  const auto at = [](double from, double step, double height) {
    return step == 0.0 ? from : from + step * height;  // the height may be infinite
  };
  TreeBounds out;
  for (const double height : {low, high}) out.box.add(Vec2{at(middle.x, up.x, height), at(middle.y, up.y, height)});
  return out;
}

}  // namespace mes
