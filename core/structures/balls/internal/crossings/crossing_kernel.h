// SPDX-License-Identifier: GPL-3.0-or-later
// Crossings of circles as points of a triangulation, with exact predicates that seldom need exact numbers. A crossing
// knows the two balls it comes from; its coordinates are rational, or have one square root.
//
// A sign is decided
//
//  1. by what the crossings are: equal, on one circle, or samples, which are doubles;
//  2. in intervals of doubles, of coordinates known to a unit in the last place;
//  3. in two doubles with a bound (`TwoDoubles`);
//  4. in intervals of 40, 80, 160 and 320 decimal digits (`BigInterval`);
//  5. in the field of the rationals and the roots at hand (`RootElement`).
//
// Several crossings on one circle are the rule; their in-circle test is zero, which the first step sees. Only signs
// that are zero by coincidence reach the last step, as in symmetric figures. Threads may share crossings.
#pragma once

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/kernel/kernels.h"
#include "core/kernel/numbers/big_interval.h"
#include "core/kernel/numbers/two_doubles.h"
#include "core/structures/balls/internal/local_frame.h"
#include "core/structures/balls/internal/numbers/union_numbers.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/triangulation/input_slots.h"

namespace mes {

/// Defines a crossing by two balls whose circles meet.
struct CrossingSource {
  enum class Kind : std::uint8_t {
    sample,    ///< a sample that both circles pass through
    mirrored,  ///< such a sample, mirrored at the line of the centres
    touch,     ///< the one point of circles that touch
    root,      ///< to the left or right of the line from the first centre to the second
  };
  Kind kind = Kind::root;
  bool left = false;
  const PipelineBall* ball[2] = {};
  Vec2 sample{};
};

/// Circles through a crossing: balls by their index in the input, ascending.
using CirclesThrough = std::vector<InputSlot>;

/// The known data of a crossing.
struct Crossing {
  using Interval = CGAL::Interval_nt<false>;
  using First = TwoDoubles;
  struct FortyDigits {
    BigInterval<40> x, y;
  };

  CrossingSource source;
  Interval x, y;                             ///< at most four doubles wide, unless the balls are all but degenerate
  First first_x, first_y;                    ///< the same with more digits
  std::shared_ptr<const FortyDigits> forty;  ///< set if these are not enough for the intervals
  const Crossing* same = nullptr;            ///< the representative of crossings known to be equal
  CirclesThrough circles;                    ///< for the representative: circles through any of the equal ones
};

/// Computes the intervals of a crossing from those of its two balls, as `ball_in` gives them; `same` and `circles` are
/// left to the caller.
Crossing crossing_of(const CrossingSource& source, const BallOf<Crossing::First>& a,
                     const BallOf<Crossing::First>& b);

/// A crossing as CGAL's triangulation holds it. Refers to the crossing that it represents.
struct CrossingPoint {
  const Crossing* at = nullptr;
};

/// The operations that CGAL's Delaunay triangulation needs of points, and the pipeline of numbers. Balls are rational.
struct CrossingKernel {
  using FT = ExactKernel::FT;
  using Point_2 = CrossingPoint;
  // CGAL's triangulation names these types but never makes them.
  struct Segment_2 {};
  struct Triangle_2 {};

  struct Compare_x_2 {
    CGAL::Comparison_result operator()(CrossingPoint p, CrossingPoint q) const;
  };
  struct Compare_y_2 {
    CGAL::Comparison_result operator()(CrossingPoint p, CrossingPoint q) const;
  };
  struct Orientation_2 {
    CGAL::Orientation operator()(CrossingPoint p, CrossingPoint q, CrossingPoint r) const;
  };
  struct Side_of_oriented_circle_2 {
    CGAL::Oriented_side operator()(CrossingPoint p, CrossingPoint q, CrossingPoint r, CrossingPoint s) const;
  };
  /// Order along one of two unspecified directions at a right angle. The other direction decides ties, so that both
  /// orders are those of a plane that is turned by a right angle.
  struct Less_along {
    bool operator()(CrossingPoint p, CrossingPoint q, bool by_second) const;
  };
  struct Construct_point_2 {
    CrossingPoint operator()(CrossingPoint p) const { return p; }
  };
  Construct_point_2 construct_point_2_object() const { return {}; }
  Compare_x_2 compare_x_2_object() const { return {}; }
  Compare_y_2 compare_y_2_object() const { return {}; }
  Orientation_2 orientation_2_object() const { return {}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
};

/// Sign of the signed distance of the first centre from the line pq, less that of the second.
int compare_distances_to_line(CrossingPoint p, CrossingPoint q, const PipelineBall& a, const PipelineBall& b);

/// Each coordinate is rounded once to the nearest double. One that is midway between two doubles, up to some 300
/// digits, is rounded towards zero.
PlacedPoint place_of(CrossingPoint p, const LocalFrame& frame);
/// The centre of the circle through the three, which are not collinear; rounded in the same way.
PlacedPoint place_of_circumcenter(CrossingPoint p, CrossingPoint q, CrossingPoint r, const LocalFrame& frame);
/// Vector from the centre of the ball to the crossing; rounded in the same way.
Vec2 rounded_vector(const PipelineBall& ball, CrossingPoint p);

}  // namespace mes
