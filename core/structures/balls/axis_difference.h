// SPDX-License-Identifier: GPL-3.0-or-later
// The difference between the one-step axis and the axis of the union of the inner balls.
#pragma once

#include <vector>

#include "core/structures/axis/medial_axis.h"
#include "core/structures/balls/ball_union.h"

namespace mes {

/// The two are compared as graphs: a piece of either axis is common if it joins the same two balls in both. Where the
/// union follows from the certified shortcut there is no difference, and an edit costs nothing here; otherwise it is
/// recomputed with the union.
class AxisDifference final : public Structure {
 public:
  struct Piece {
    Vec2 a{}, b{};
    bool only_one_step = false;
  };
  using PieceSlot = Slot<struct DifferencePieceTag>;
  AxisDifference(Delaunay& delaunay, OneStepCrust& crust, InnerBalls& balls, MedialAxis& axis, AUnion& a_union);

  const Table<PieceSlot, Piece>& pieces() const { return pieces_; }
  const ChangeSet<PieceSlot>& changes() const { return no_changes<PieceSlot>(); }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  const InnerBalls& balls_;
  const MedialAxis& axis_;
  const AUnion& union_;
  Table<PieceSlot, Piece> pieces_;
};

}  // namespace mes
