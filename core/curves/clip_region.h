// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the plane that curves enclose, and what of other curves lies in them.
//
// What it guarantees:
//  1. A curve that no boundary cuts comes back as it was, to the last bit.
//  2. Where boundaries cut, what is left are parts of the curves that were given: of lines, Bézier curves and arcs, not of
//     polygons. They meet where both curves are, up to rounding.
//  3. What is left goes all around: where an area is cut, a part of the boundary of the region closes it.
//
// How: Clipper decides, exactly, for polygons that are within 1e-5 of the extent of their curves, on a grid of 2^-36 of the
// drawing; sides of its result are taken back to the pieces that they lie on, and crossings are found again between these
// by Newton's method. Where that fails, as along curves that touch, a side stays straight. Parts thinner than the
// polygons are apart from their curves do not count.
//
// Smallest use:
//     const ClipRegion disk = ClipRegion::of(std::vector{circle}, FillRule::nonzero, clip_grid(100.0));
//     const ClippedCurves seen = disk.clipped({square}, Ink::nonzero_area);
//
// Cost: O(n log n) for n sides of curve and region where they cut; O(log n) where their boxes tell. Threads: any.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/box2.h"
#include "core/curves/curve.h"

namespace mes {

enum class FillRule : std::uint8_t { nonzero, even_odd };

/// What of curves is seen: the areas that they enclose, or themselves.
enum class Ink : std::uint8_t { nonzero_area, even_odd_area, line };

/// The step of the grid for drawings of about this extent: a power of two.
double clip_grid(double extent);

struct ClippedCurves {
  enum class Seen : std::uint8_t { whole, part, nothing };
  Seen seen = Seen::whole;
  std::vector<PlaneCurve> curves{};  ///< without names; where all is seen, the curves that were given
};

/// A value. Regions that are combined have one grid. Coordinates beyond 2^55 steps of the grid are an error of the caller.
class ClipRegion {
 public:
  /// The whole plane.
  ClipRegion() = default;
  /// What curves enclose, open ones closed by a line; nothing for what encloses nothing.
  static ClipRegion of(std::span<const PlaneCurve> curves, FillRule rule, double grid);
  static ClipRegion united(std::span<const ClipRegion> regions, double grid);
  static ClipRegion common(const ClipRegion& a, const ClipRegion& b);
  /// Whether coordinates of these curves fit on the grid.
  static bool fits(std::span<const PlaneCurve> curves, double grid);

  bool is_plane() const { return !body_; }
  /// Takes in the names of `curves`, which fit on the grid, but not in what is cut.
  ClippedCurves clipped(std::vector<PlaneCurve> curves, Ink ink) const;

 private:
  struct Body;
  explicit ClipRegion(std::shared_ptr<const Body> body) : body_(std::move(body)) {}
  std::shared_ptr<const Body> body_;
};

/// The least box around a piece or a curve. Empty for no curves. O(pieces).
Box2 bounds_of(const Piece& piece);
Box2 bounds_of(std::span<const PlaneCurve> curves);

}  // namespace mes
