// SPDX-License-Identifier: GPL-3.0-or-later
// Does the circumdisk of one Delaunay triangle meet an arc of the circumcircle of another? Exact for the given
// doubles.
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

#include "core/base/vec2.h"

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

/// Says quickly of most disks that the direction of their centre does not point into the arc. Made once for an arc.
class ArcFilter {
 public:
  explicit ArcFilter(const OuterArc& arc);
  /// The disk does not meet the arc; false says nothing.
  bool misses(const Corners& disk) const;

 private:
  Vec2 start_;
  Bounded from_start_[2];   ///< to the centre
  Bounded to_start_[2];     ///< from there
  Bounded to_end_[2];       ///< from there, too
  bool is_narrow_ = false;  ///< certainly less than half a circle
  bool is_wide_ = false;    ///< certainly more
};

/// By interval arithmetic; some 0.3 us.
Meets meets_arc_quickly(const OuterArc& arc, const Corners& disk);

/// The same for the open half plane to the left of u -> v, the disk of a face at infinity. No end of the arc may lie
/// in it.
Meets meets_arc_quickly(const OuterArc& arc, Vec2 u, Vec2 v);

/// Exact; by intervals first.
bool meets_arc(const OuterArc& arc, const Corners& disk);

}  // namespace mes
