// SPDX-License-Identifier: GPL-3.0-or-later
// The part of lines and circles that is visible on a page, however long or large they are.
//
// Everything is in points on the page, y downwards. Cost: O(1) each. Threads: any.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/geometry/vec2.h"
#include "render/figure/figure.h"

namespace mes::figure {

/// A closed interval of parameters along a line; empty if low > high.
struct Stretch {
  double low = 0.0;
  double high = 0.0;
  bool is_empty() const { return !(low <= high); }
};

/// The parameters t of `within` for which start + t * direction lies in the box (Liang and Barsky, "A new concept and
/// method for line clipping", 1984).
Stretch stretch_in(const Box2& box, Vec2 start, Vec2 direction, Stretch within);

/// False if no point at a distance in [inner, outer] from the centre lies in the box.
bool ring_meets(const Box2& box, Vec2 center, double inner, double outer);

/// A circle so much larger than the box that its part in the box is nearly straight: a curve replaces it, with an error
/// below a hundred-thousandth of the box's diagonal.
class HugeCircle {
 public:
  /// The radius is at least `kLeast` diagonals of the box.
  static constexpr double kLeast = 4.0;
  HugeCircle(const Box2& box, Vec2 center, double radius);

  /// Its rim at the box; nothing if it does not meet the box.
  std::optional<Shape> rim() const;
  /// The part of its disk that covers the box; nothing if it does not reach the box.
  std::optional<Shape> disk() const;
  /// The pieces of an arc, counter-clockwise on screen, that meet the box: at most two.
  std::vector<Shape> arc(Vec2 from, Vec2 to) const;

 private:
  Vec2 at(double angle) const;
  Shape piece(double low, double high) const;

  Vec2 center_;
  double radius_;
  double reach_;     // half size of the box
  Vec2 outward_;     // from the centre to the middle of the box
  double distance_;  // signed distance of the rim from the middle of the box: positive if it is inside the disk
  Vec2 nearest_;     // nearest point of the rim to the middle of the box
  double half_;      // visible angle of the box on each side of it
};

}  // namespace mes::figure
