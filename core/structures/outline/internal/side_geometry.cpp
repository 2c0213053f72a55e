// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/internal/side_geometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/kernel/point_predicates.h"
#include "core/structures/outline/internal/chords.h"

namespace mes {
namespace {

double radius_of(const OutlineSide& side) {
  return 0.5 * (distance(side.from, *side.center) + distance(side.to, *side.center));
}
/// The bow of a side reaches as far from it, in heights.
constexpr double kBow = 4.0;

}  // namespace

double height_of(const OutlineSide& side) {
  const Vec2 chord = side.to - side.from;
  return side.center ? dot(chord, chord) / (8.0 * radius_of(side)) : 0.0;
}

Vec2 middle_of(const OutlineSide& side) {
  const Vec2 middle = 0.5 * side.from + 0.5 * side.to;
  if (!side.center) return middle;
  const Vec2 way = middle - *side.center;
  const double size = length(way);
  return size > 0.0 ? *side.center + (radius_of(side) / size) * way : middle;
}

double least_height(std::span<const OutlineSide> sides) {
  Box2 extent;
  for (const OutlineSide& side : sides) extent.add(box_of(side));
  return 0x1p-44 *
         std::max({std::abs(extent.low.x), std::abs(extent.low.y), std::abs(extent.high.x), std::abs(extent.high.y)});
}

Box2 box_of(const OutlineSide& side) {
  Box2 box;
  box.add(side.from);
  box.add(side.to);
  if (!side.center) return box;
  const Vec2 margin = kBow * height_of(side) * Vec2{1.0, 1.0};
  return {box.low - margin, box.high + margin};
}

BoxTree<std::uint32_t> tree_of(std::span<const OutlineSide> sides) {
  std::vector<std::uint32_t> numbers(sides.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  BoxTree<std::uint32_t> tree;
  tree.build(
      std::span<const std::uint32_t>(numbers), [sides](std::uint32_t i) { return TreeBounds{box_of(sides[i])}; },
      [](std::uint32_t, std::uint32_t) {});
  return tree;
}

double share_along(Vec2 p, const OutlineSide& side) {
  const Vec2 along = side.to - side.from;
  return dot(p - side.from, along) / dot(along, along);
}

bool can_split(Vec2 p, const OutlineSide& side) {
  const double share = share_along(p, side);
  return p != side.from && p != side.to && share > 0.0 && share < 1.0;
}

bool is_in_bow(Vec2 p, const OutlineSide& side) {
  return side.center && can_split(p, side) && distance_from_chord(p, side.from, side.to) <= kBow * height_of(side);
}

bool cross_inside(const OutlineSide& a, const OutlineSide& b) {
  return orientation(a.from, a.to, b.from) * orientation(a.from, a.to, b.to) < 0 &&
         orientation(b.from, b.to, a.from) * orientation(b.from, b.to, a.to) < 0;
}

Meeting meeting_of(const OutlineSide& a, const OutlineSide& b, double least) {
  const Vec2 along = a.to - a.from;
  const Vec2 other = b.to - b.from;
  constexpr double kLarge = 2.0;
  const auto turn = [](const OutlineSide& side, Vec2 chord) {
    return side.center ? length(chord) / radius_of(side) : 0.0;
  };
  if (std::abs(cross(along, other)) >= kLarge * (turn(a, along) + turn(b, other)) * length(along) * length(other))
    return Meeting::crosses;
  return std::max(height_of(a), height_of(b)) <= least ? Meeting::touches : Meeting::unclear;
}

bool is_on_circle(Vec2 p, const OutlineSide& side, double least) {
  return side.center && std::abs(distance(p, *side.center) - radius_of(side)) <= least;
}

bool are_on_one_circle(const OutlineSide& a, const OutlineSide& b, double least) {
  return a.center && b.center && distance(*a.center, *b.center) <= least &&
         std::abs(radius_of(a) - radius_of(b)) <= least;
}

}  // namespace mes
