// SPDX-License-Identifier: GPL-3.0-or-later
// Sides of outlines beside each other: where they are near, how they meet, and how their curves do. Private to
// core/structures/outline.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/geometry/box_tree.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/outline/outline_sides.h"

namespace mes {

/// How far the circle of a side leaves it; 0 for a straight one.
double height_of(const OutlineSide& side);
/// The middle of the arc that the side stands for.
Vec2 middle_of(const OutlineSide& side);
/// Chords that leave their curves by less are those of the curve to rounding: 2^-44 of the largest coordinate.
double least_height(std::span<const OutlineSide> sides);

/// The box holds the side and its bow.
Box2 box_of(const OutlineSide& side);
/// A tree of the boxes.
BoxTree<std::uint32_t> tree_of(std::span<const OutlineSide> sides);
/// Calls `use(i, j)` for each two sides whose boxes meet, until it returns false.
void for_each_meeting(std::span<const OutlineSide> sides, JobControl& job, auto use) {
  const BoxTree<std::uint32_t> tree = tree_of(sides);
  bool goes_on = true;
  for (std::uint32_t i = 0; i < sides.size() && goes_on; ++i) {
    constexpr std::uint32_t kRatherOften = 64;  // a side may cross all others
    if (i % kRatherOften == 0) job.checkpoint();
    const Box2 own = box_of(sides[i]);
    tree.visit_where([&](const Box2& box, double) { return goes_on && overlap(own, box); },
                     [&](std::uint32_t j) {
                       if (j > i && goes_on && overlap(own, box_of(sides[j]))) goes_on = use(i, j);
                     });
  }
}

/// The foot of a point on the line through a side: 0 at its first end, 1 at its second.
double share_along(Vec2 p, const OutlineSide& side);
/// True if the point can split the side, which it need not lie on.
bool can_split(Vec2 p, const OutlineSide& side);
/// Whether a point is so near the side that the axis between them depends on which chords the curve has.
bool is_in_bow(Vec2 p, const OutlineSide& side);

/// Whether two sides cross at a point which is an end of neither. Exact.
bool cross_inside(const OutlineSide& a, const OutlineSide& b);

/// How two curves meet whose chords cross: it is unclear while chords alone may cross.
enum class Meeting : std::uint8_t { crosses, touches, unclear };

/// How the curves of two sides meet that cross inside. They cross where the angle between the sides is much larger than
/// those by which the curves turn along them. Curves whose chords leave them by no more than `least` touch.
Meeting meeting_of(const OutlineSide& a, const OutlineSide& b, double least);

/// Whether a point is on the circle of the side, to `least`.
bool is_on_circle(Vec2 p, const OutlineSide& side, double least);
/// Whether two sides stand for arcs of one circle, to `least`.
bool are_on_one_circle(const OutlineSide& a, const OutlineSide& b, double least);

}  // namespace mes
