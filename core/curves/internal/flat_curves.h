// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as polygons on a grid, whose sides remember the pieces that they come from. Private to core/curves.
#pragma once

#include <clipper.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/geometry/box_tree.h"
#include "core/curves/curve.h"

namespace mes {

using ClipperPoint = ClipperLib::IntPoint;
using GridPath = ClipperLib::Path;
using GridPaths = ClipperLib::Paths;

/// A corner within this many grid steps of a side counts as on it: Clipper rounds each crossing to the grid.
inline constexpr double kOnSide = 3.0;

inline Vec2 as_vec(ClipperPoint p) {
  return {static_cast<double>(p.X), static_cast<double>(p.Y)};
}

/// Drops parts that are nowhere wider than about `width`.
void drop_slivers(GridPaths& paths, double width);

/// A straight side that stands for part of a piece, between two parameters.
struct FlatSide {
  ClipperPoint from;
  ClipperPoint to;
  std::uint32_t piece = 0;
  double begin = 0.0;
  double end = 0.0;
};

/// A side on which a corner lies.
struct SideAt {
  std::uint32_t side = 0;
  double distance = 0.0;   ///< in grid steps
  double parameter = 0.0;  ///< on the piece
};

/// Usage: call `add` for all curves, then `build`; queries may then run on any thread.
class FlatCurves {
 public:
  /// Largest distance between polygons and their curves, relative to the extent of each curve.
  static constexpr double kFlatness = 1e-5;

  explicit FlatCurves(double grid, double flatness = kFlatness) : grid_(grid), flatness_(flatness) {}

  static bool fits(const PlaneCurve& curve, double grid);
  /// Adds a curve and returns its corners, without repetitions. If `closes`, an open curve gets a line to its start;
  /// otherwise the last corner of its path is its end.
  GridPath add(const PlaneCurve& curve, bool closes);
  void add(const FlatCurves& other);
  void build();

  /// Sides within `reach` grid steps of the corner.
  std::vector<SideAt> sides_at(ClipperPoint corner, double reach = kOnSide) const;
  /// How many sides `sides_at` looks at.
  std::size_t looks_at(ClipperPoint corner) const;

  double grid() const { return grid_; }
  /// Largest distance between polygons and their curves, in grid steps.
  double tolerance() const { return tolerance_; }
  Vec2 place_of(ClipperPoint p) const { return grid_ * as_vec(p); }
  const FlatSide& side(std::uint32_t i) const { return sides_[i]; }
  const Piece& piece(std::uint32_t i) const { return pieces_[i]; }
  /// Index of the curve of a piece, in the order of adding.
  std::uint32_t curve_of(std::uint32_t piece) const { return curves_[piece]; }
  bool is_first(std::uint32_t piece) const { return piece == 0 || curves_[piece - 1] != curves_[piece]; }
  bool is_last(std::uint32_t piece) const {
    return piece + 1 == curves_.size() || curves_[piece + 1] != curves_[piece];
  }

 private:
  double grid_;
  double flatness_;
  double tolerance_ = 0.0;
  std::uint32_t curve_count_ = 0;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> curves_;
  std::vector<FlatSide> sides_;
  BoxTree<std::uint32_t> tree_;
};

}  // namespace mes
