// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as polygons on a grid, whose sides know what they are of. Private to core/curves.
#pragma once

#include <clipper.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/box_tree.h"
#include "core/curves/curve.h"

namespace mes {

using GridPoint = ClipperLib::IntPoint;
using GridPath = ClipperLib::Path;
using GridPaths = ClipperLib::Paths;

/// Steps of the grid within which a corner is taken to lie on a side: Clipper rounds each crossing to the grid.
inline constexpr double kOnSide = 3.0;

inline Vec2 as_vec(GridPoint p) {
  return {static_cast<double>(p.X), static_cast<double>(p.Y)};
}

/// Part of a piece, between two values of its parameter.
struct FlatSide {
  GridPoint from;
  GridPoint to;
  std::uint32_t piece = 0;
  double begin = 0.0;
  double end = 0.0;
};

/// A side on which a corner lies.
struct SideAt {
  std::uint32_t side = 0;
  double distance = 0.0;   ///< steps of the grid
  double parameter = 0.0;  ///< of the piece
};

/// Adding comes first, then `build`, then looking: from any thread.
class FlatCurves {
 public:
  explicit FlatCurves(double grid) : grid_(grid) {}

  static bool fits(const PlaneCurve& curve, double grid);
  /// The corners, without repetitions; an open curve that `closes` gets a line to its start. Of an open path the last
  /// corner is the end.
  GridPath add(const PlaneCurve& curve, bool closes);
  void add(const FlatCurves& other);
  void build();

  /// Sides within `reach` steps of the corner.
  std::vector<SideAt> sides_at(GridPoint corner, double reach = kOnSide) const;

  double grid() const { return grid_; }
  /// How far polygons may be apart from their curves, in steps.
  double tolerance() const { return tolerance_; }
  Vec2 place_of(GridPoint p) const { return grid_ * as_vec(p); }
  const FlatSide& side(std::uint32_t i) const { return sides_[i]; }
  const Piece& piece(std::uint32_t i) const { return pieces_[i]; }
  /// Of which curve, in the order of adding, a piece is.
  std::uint32_t curve_of(std::uint32_t piece) const { return curves_[piece]; }
  bool is_first(std::uint32_t piece) const { return piece == 0 || curves_[piece - 1] != curves_[piece]; }
  bool is_last(std::uint32_t piece) const {
    return piece + 1 == curves_.size() || curves_[piece + 1] != curves_[piece];
  }

 private:
  double grid_;
  double tolerance_ = 0.0;
  std::uint32_t curve_count_ = 0;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> curves_;
  std::vector<FlatSide> sides_;
  BoxTree<std::uint32_t> tree_;
};

}  // namespace mes
