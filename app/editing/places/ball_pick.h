// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the sample or ball near the pointer. A ball is picked at its centre or its circle; its inside belongs to the
// elements in it.
#pragma once

#include <vector>

#include "app/editing/places/place_index.h"
#include "core/base/geometry/box2.h"
#include "core/document/document.h"

namespace mes {

struct BallPick {
  BallSlot slot;
  double distance = 0.0;  ///< to the centre or the circle, whichever is nearer
};

/// The ball whose centre or circle is nearest to `p` and at most `radius` away; ties go to the higher row, which is
/// drawn above. Cost: O(balls), some 15 ns each: under 2 ms at 10^5 balls.
BallPick nearest_ball(const Document& document, Vec2 p, double radius);

/// A sample, a ball, or nothing.
struct PickedThing {
  SampleSlot sample;
  BallSlot ball;
  bool is_any() const { return sample != kNoSlot || ball != kNoSlot; }
};
struct PickedKinds {
  bool samples = true;
  bool balls = true;
};
/// The sample or ball of these kinds that a click at `p` takes: the nearer one, and the sample if both are as near.
/// `index` is that of the document's samples.
PickedThing thing_at(const Document& document, const SampleIndex& index, Vec2 p, double radius,
                     PickedKinds kinds = {});

/// Rows of the balls with their centre in the closed box, increasing. O(balls).
std::vector<BallSlot> balls_in_box(const Document& document, const Box2& box);

}  // namespace mes
