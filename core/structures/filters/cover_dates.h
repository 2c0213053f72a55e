// SPDX-License-Identifier: GPL-3.0-or-later
// The factor at which an inner ball is swallowed when all inner balls grow by it.
#pragma once

#include <vector>

#include "core/base/box2.h"
#include "core/graph/structure.h"
#include "core/structures/axis/inner_balls.h"

namespace mes {

/// What it guarantees, with c the centre and r the radius of a ball as doubles:
///  1. `date(i)` is the least of |c_i - c_j| / (r_j - r_i) over all balls j with r_j > r_i: at this factor the grown ball j
///     holds the grown ball i. Infinite for the largest balls, which are never swallowed; elsewhere 1 or more, as no inner
///     ball lies inside another; what rounding brings below 1 is 1.
///  2. It is the least of the same doubles that looking at all pairs gives, bit for bit.
///
/// Not to be confused with the scale axis, which is of the union of grown balls.
///
/// Rows: nodes, faces that stand for their ball (`InnerBalls::ball`). Cost: rebuild O(n log n) typically, O(n^2) at worst: a
/// search for each ball in a tree of boxes, which begins with what swallowed the ball before it and with its neighbours.
/// Each box knows its largest radius and a plane above its balls, as points (x, y, radius): along an axis radii change
/// evenly, so the plane is near to them where the largest radius is not. An edit asks for a rebuild, as a new ball may
/// swallow any other.
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

 private:
  struct Ball {
    Vec2 center{};
    double radius = 0.0;
    FaceSlot face{};
  };
  /// Balls from `first` on, up to that of the next node.
  struct Node {
    Box2 box{};
    double most = 0.0;  ///< radius
    /// No ball in it is larger than `height` + `slope` * (its centre - that of the box). Rounding is seen to.
    double height = 0.0;
    Vec2 slope{};
    std::uint32_t first = 0, last = 0;
    std::uint32_t child = 0;  ///< the first of two; 0 = none
  };
  bool is_node(FaceSlot face) const { return balls_.is_ball(face) && balls_.ball(face) == face; }
  void build(std::uint32_t node);
  void put_plane_above(Node& node) const;
  /// `guess`: position of a ball that may swallow it early; becomes that of the one that does, if found in the tree.
  double search(const Ball& ball, std::uint32_t& guess) const;

  const Delaunay& delaunay_;
  const InnerBalls& balls_;
  std::vector<Ball> sorted_;
  std::vector<Node> tree_;
  Table<FaceSlot, double> date_;  ///< below 0: no node
};

}  // namespace mes
