// SPDX-License-Identifier: GPL-3.0-or-later
// The factor at which an inner ball is swallowed when all inner balls grow by it.
#pragma once

#include "core/graph/structure.h"
#include "core/structures/axis/inner_balls.h"

namespace mes {

/// Guarantees, with c the centre and r the radius of a ball as doubles:
///  1. `date(i)` is the least of |c_i - c_j| / (r_j - r_i) over all balls j with r_j > r_i: at this factor the grown
///     ball j holds the grown ball i. It is infinite for the largest balls, which are never swallowed; for others it is
///     1 or more, as no inner ball lies inside another. Values that rounding brings below 1 are set to 1.
///  2. It equals, bit for bit, the least of these doubles over all pairs.
///
/// Not to be confused with the scale axis, which belongs to the union of grown balls.
///
/// Rows: nodes, that is, faces that stand for their ball (`InnerBalls::ball`). Cost: rebuild O(n log n) typically,
/// O(n^2) at worst (internal/cover_search.h). Every edit causes a rebuild, as a new ball may swallow any other.
class CoverDates final : public Structure {
 public:
  CoverDates(Delaunay& delaunay, InnerBalls& balls);

  bool has_date(FaceSlot face) const { return date_.has(face) && date_[face] >= 0.0; }
  double date(FaceSlot face) const { return date_[face]; }
  const ChangeSet<FaceSlot>& changes() const { return no_changes<FaceSlot>(); }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  bool is_node(FaceSlot face) const { return balls_.is_ball(face) && balls_.ball(face) == face; }

  const Delaunay& delaunay_;
  const InnerBalls& balls_;
  Table<FaceSlot, double> date_;  ///< below 0 if the face is no node
};

}  // namespace mes
