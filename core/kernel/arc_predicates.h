// SPDX-License-Identifier: GPL-3.0-or-later
// Decides exactly, for the given doubles, whether the circumdisk of one Delaunay triangle meets an arc of the
// circumcircle of another.
//
// Let f be a Delaunay triangle with corners s, p, q counter-clockwise and h another one with a different
// circumcircle. No site lies inside the disk of h, so the part of f's circle that h covers lies on one of the three
// arcs between consecutive corners: the one that its middle, in the direction of h's centre, lies on. Hence the
// closed disk of h meets the open arc from p to q that does not pass s exactly if
//     c_h - c_f points into the open cone from p - c_f counter-clockwise to q - c_f, and
//     the disks meet: D = |c_h - c_f|^2 - w_f - w_h satisfies D <= 0 or D^2 <= 4 w_f w_h   (w = squared radius).
// All of it is rational in the coordinates.
#pragma once

#include <cstdint>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Corners of a triangle, counter-clockwise.
struct Corners {
  Vec2 a, b, c;
};

/// The arc from `p` to `q` of the circumcircle of the counter-clockwise triangle s, p, q that does not pass s,
/// without its ends.
struct OuterArc {
  Vec2 s, p, q;
};

enum class Meets : std::uint8_t { no, yes, unsure };

/// A number and a bound of its error.
struct Bounded {
  double value = 0.0;
  double error = 0.0;
};

/// Rules out most disks quickly: those whose centre lies in a direction outside the arc. One filter serves one arc.
class ArcFilter {
 public:
  explicit ArcFilter(const OuterArc& arc);
  /// True if the disk certainly misses the arc; false decides nothing.
  bool misses(const Corners& disk) const;

 private:
  Vec2 start_;
  Bounded from_start_[2];   ///< vector from the arc's start to the centre of its circle
  Bounded to_start_[2];     ///< vector from the centre to the arc's start
  Bounded to_end_[2];       ///< vector from the centre to the arc's end
  bool is_narrow_ = false;  ///< the arc is certainly less than half a circle
  bool is_wide_ = false;    ///< the arc is certainly more than half a circle
};

/// Uses interval arithmetic; takes about 0.3 us.
Meets meets_arc_quickly(const OuterArc& arc, const Corners& disk);

/// The same for the open half plane to the left of u -> v, which is the disk of a face at infinity. Neither end of the
/// arc may lie in it.
Meets meets_arc_quickly(const OuterArc& arc, Vec2 u, Vec2 v);

/// Exact: tries intervals first, then rationals.
bool meets_arc(const OuterArc& arc, const Corners& disk);

}  // namespace mes
