// SPDX-License-Identifier: GPL-3.0-or-later
// How far the axis that the samples give is from the axis of the outline.
#pragma once

#include <optional>
#include <vector>

#include "core/structures/axis/medial_axis.h"
#include "core/structures/outline/outline_axis.h"

namespace mes {

/// Pieces of the one-step medial axis with their distance from the axis of the outline, and the other way round. The
/// larger of the two largest distances is the Hausdorff distance of the two sets. Pieces of the medial axis that are
/// far away are spurious; pieces of the axis of the outline that are far away were missed.
///
/// Guarantees:
///  1. The distance of a piece is the largest of all its points, up to a factor of 1 + 2^-10 and rounding.
///  2. Nothing is compared if one of the two is empty.
///
/// Arcs are measured as chains of chords (`OutlineAxis::pieces`).
///
/// Cost: a change of either axis measures everything again, O(n log n) on all cores.
class AxisDeviation final : public Structure {
 public:
  struct Piece {
    Vec2 from{}, to{};
    double distance = 0.0;  ///< largest distance of its points from the other axis
    bool is_of_outline = false;
  };
  using PieceSlot = Slot<struct DeviationPieceTag>;
  AxisDeviation(Delaunay& delaunay, MedialAxis& axis, OutlineAxis& outline);

  const Table<PieceSlot, Piece>& pieces() const { return pieces_; }
  const ChangeSet<PieceSlot>& changes() const { return no_changes<PieceSlot>(); }
  /// Largest distance of a point of the one axis from the other: of the medial axis from that of the outline if
  /// `is_of_outline` is false. 0 without pieces.
  double largest(bool is_of_outline) const;

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  const Delaunay& delaunay_;
  const MedialAxis& axis_;
  const OutlineAxis& outline_;
  Table<PieceSlot, Piece> pieces_;
};

}  // namespace mes
