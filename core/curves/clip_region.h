// SPDX-License-Identifier: GPL-3.0-or-later
// Regions of the plane that curves enclose, and clipping of other curves to them.
//
// Guarantees:
//  1. A curve that no boundary cuts is returned unchanged, to the last bit.
//  2. A clipped curve consists of parts of the given curves (lines, Bézier curves and arcs), not of polygons. The parts
//     meet at the intersections of both curves, up to rounding.
//  3. A clipped area is closed: where it is cut, a part of the boundary of the region closes it.
//
// How: Clipper computes exactly with polygons that are within 1e-5 of the extent of their curves, on a grid of 2^-36 of
// the drawing. A region of more than a thousand pieces gets coarser polygons, down to 3e-3, so that they have hardly more
// sides. The sides of its result are mapped back to the pieces that they lie on, and Newton's method recomputes
// the crossings of these. Where it fails, as along curves that touch, a side stays straight. Parts that are thinner
// than the distance between polygons and curves are dropped.
//
// Smallest use:
//     const ClipRegion disk = ClipRegion::of(std::vector{circle}, FillRule::nonzero, clip_grid(100.0));
//     const ClippedCurves seen = disk.clipped({square}, Ink::nonzero_area);
//
// Cost: O(n log n) for n sides of curve and region if they intersect; O(log n) if bounding boxes decide. Threads: any.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/curves/curve.h"

namespace mes {

enum class FillRule : std::uint8_t { nonzero, even_odd };

/// Drawing style of the curves: the areas that they enclose, or lines.
enum class Ink : std::uint8_t { nonzero_area, even_odd_area, line };

/// Grid step for drawings of about this extent: a power of two.
double clip_grid(double extent);

struct ClippedCurves {
  enum class Seen : std::uint8_t { whole, part, nothing };
  Seen seen = Seen::whole;
  std::vector<PlaneCurve> curves{};  ///< no names; if everything is seen, the curves that were given
};

/// A value type. Combined regions must have the same grid. Curves must fit.
class ClipRegion {
 public:
  /// The whole plane.
  ClipRegion() = default;
  /// The region that the curves enclose; open curves are closed by a line. Empty if the curves enclose nothing.
  /// `companions` is the number of like regions that it will be united with.
  static ClipRegion of(std::span<const PlaneCurve> curves, FillRule rule, double grid, std::size_t companions = 0);
  static ClipRegion united(std::span<const ClipRegion> regions, double grid);
  static ClipRegion common(const ClipRegion& a, const ClipRegion& b);
  /// Whether these curves can be clipped, or clip others: their coordinates fit on the grid, and their pieces do not
  /// cross each other by the million. O(pieces log pieces).
  static bool fits(std::span<const PlaneCurve> curves, double grid);

  bool is_plane() const { return !body_; }
  /// Estimates the cost of clipping a curve in this box: counts the sides of the region near the box, and the sides
  /// that are looked at for each of these. Counting ends at about `most`.
  std::size_t cost_near(const Box2& box, std::size_t most) const;
  /// Clips the curves. A curve that is cut loses its name.
  ClippedCurves clipped(std::vector<PlaneCurve> curves, Ink ink) const;

 private:
  struct Body;
  explicit ClipRegion(std::shared_ptr<const Body> body) : body_(std::move(body)) {}
  std::shared_ptr<const Body> body_;
};

}  // namespace mes
