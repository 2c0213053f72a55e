// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from features of an outline, and points that are equally far from them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/base/geometry/vec2.h"
#include "core/structures/outline/outline_graph.h"

namespace mes {

/// A feature as it lies around places that it is nearest to: a point, the line through a straight side, or the circle
/// of a round one. Positions count from an origin, so that rounding does not depend on where the plane has its own.
struct NearFeature {
  Vec2 at{};                     ///< a point of it
  Vec2 normal{};                 ///< unit vector across a straight side; zero otherwise
  std::optional<Vec2> center{};  ///< of a round side

  static NearFeature of(const OutlineFeature& feature, Vec2 origin) {
    const Vec2 from = feature.from - origin;
    if (feature.center) return {from, {}, *feature.center - origin};
    if (feature.is_point()) return {from, {}, {}};
    const Vec2 to = feature.to - origin;
    const Vec2 along = feature.to - feature.from;
    return {dot(from, from) < dot(to, to) ? from : to, (1.0 / length(along)) * perpendicular(along), {}};
  }

  bool is_line() const { return normal != Vec2{}; }
  /// Negative on one side of a line and inside a circle.
  double signed_distance(Vec2 p) const {
    if (is_line()) return dot(normal, p - at);
    if (!center) return length(p - at);
    return dot(p - at, (p - *center) + (at - *center)) / (length(p - *center) + length(at - *center));
  }
  double distance(Vec2 p) const { return std::abs(signed_distance(p)); }
  /// The gradient of the distance; `inside` says on which side of a line or circle a place on it is. Zero at a point and
  /// at the centre of a circle.
  Vec2 gradient(Vec2 p, bool inside) const {
    if (is_line()) return inside ? -normal : normal;
    const Vec2 way = center ? p - *center : p - at;
    const double size = length(way);
    if (!(size > 0.0)) return {};
    return ((center && inside ? -1.0 : 1.0) / size) * way;
  }
  Vec2 gradient(Vec2 p) const { return gradient(p, signed_distance(p) < 0.0); }
};

using NearFeatures = std::array<NearFeature, 3>;

/// The point at one distance from three features, which lie around it counter-clockwise; lines have other points at one
/// distance from all, around which their order is another one. By Newton's method; nothing if rounding would move it far.
std::optional<OutlineNode> equally_far(const NearFeatures& near, Vec2 about);

/// The point that is equally far from two of the features, nearest to `about`. By Newton's method.
std::optional<OutlineNode> equally_far_from_two(const NearFeatures& near, std::size_t one, std::size_t other,
                                                Vec2 about);

/// The point at one distance from a point, a side that ends there, and the third feature: on the normal of the side in
/// the point, on the side of `about`. By Newton's method if the third feature is round.
std::optional<OutlineNode> equally_far_above_end(const NearFeatures& near, std::size_t point, std::size_t side,
                                                 Vec2 about);

}  // namespace mes
