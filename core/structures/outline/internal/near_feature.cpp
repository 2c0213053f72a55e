// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/internal/near_feature.h"

#include <algorithm>
#include <limits>

namespace mes {
namespace {

constexpr int kMostNewtonSteps = 4;
/// Where the area between unit vectors is less, rounding moves a point too far.
constexpr double kFlatCorner = 1e-6;

/// Rounding of the distances of three features from a place near a circle of this radius that touches them.
double rounding_of_distances(const NearFeatures& near, Vec2 at, double radius) {
  double reach = radius;
  const auto reach_to = [&reach](Vec2 p) { reach = std::max(reach, std::abs(p.x) + std::abs(p.y)); };
  reach_to(at);
  for (const NearFeature& feature : near) {
    reach_to(feature.at);
    if (feature.center) reach_to(*feature.center);
  }
  return 64.0 * std::numeric_limits<double>::epsilon() * reach;
}

}  // namespace

std::optional<OutlineNode> equally_far_above_end(const NearFeatures& near, std::size_t point, std::size_t side,
                                                 Vec2 about) {
  if (!is_finite(about)) return std::nullopt;
  const Vec2 p = near[point].at;
  const NearFeature& third = near[3 - point - side];
  const Vec2 normal = near[side].gradient(p, false);
  const Vec2 up = dot(normal, about - p) < 0.0 ? -normal : normal;
  double height = 0.0;
  if (third.center) {
    height = dot(about - p, up);
    for (int step = 0; step < kMostNewtonSteps; ++step) {
      const Vec2 at = p + height * up;
      height += (third.distance(at) - height) / (1.0 - dot(up, third.gradient(at)));
    }
  } else if (third.is_line()) {
    const Vec2 m = third.gradient(p);
    height = third.distance(p) / (1.0 - dot(up, m));
  } else {
    const Vec2 q = third.at - p;
    height = 0.5 * dot(q, q) / dot(up, q);
  }
  const OutlineNode node{p + height * up, height};
  const double error = std::abs(third.distance(node.center) - height);
  if (!(height > 0.0) || !(error <= rounding_of_distances(near, node.center, height))) return std::nullopt;
  return node;
}

std::optional<OutlineNode> equally_far(const NearFeatures& near, Vec2 at) {
  for (int step = 0; is_finite(at); ++step) {
    const std::array d{near[0].distance(at), near[1].distance(at), near[2].distance(at)};
    const Vec2 first = near[1].gradient(at) - near[0].gradient(at);
    const Vec2 second = near[2].gradient(at) - near[0].gradient(at);
    const double area = cross(first, second);
    if (!(area > kFlatCorner * length(first) * length(second))) return std::nullopt;
    const Vec2 by = {((d[0] - d[1]) * second.y - (d[0] - d[2]) * first.y) / area,
                     ((d[0] - d[2]) * first.x - (d[0] - d[1]) * second.x) / area};
    const double radius = (d[0] + d[1] + d[2]) / 3.0;
    if (length(by) <= rounding_of_distances(near, at, radius)) return OutlineNode{at + by, radius};
    if (step == kMostNewtonSteps) return std::nullopt;
    at = at + by;
  }
  return std::nullopt;
}

std::optional<OutlineNode> equally_far_from_two(const NearFeatures& near, std::size_t a, std::size_t b, Vec2 at) {
  for (int step = 0; is_finite(at); ++step) {
    const double first = near[a].distance(at);
    const double second = near[b].distance(at);
    const Vec2 way = near[a].gradient(at) - near[b].gradient(at);
    if (!(dot(way, way) > kFlatCorner)) return std::nullopt;
    const Vec2 by = ((second - first) / dot(way, way)) * way;
    const double radius = 0.5 * (first + second);
    if (length(by) <= rounding_of_distances(near, at, radius)) return OutlineNode{at + by, radius};
    if (step == kMostNewtonSteps) return std::nullopt;
    at = at + by;
  }
  return std::nullopt;
}

}  // namespace mes
