// SPDX-License-Identifier: GPL-3.0-or-later
// Balls along the medial axis of a union, and along the boundary of its dual complex, as dense as a parameter requires.
#pragma once

#include <array>
#include <vector>

#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/internal/sampling/ball_halving.h"
#include "core/structures/balls/internal/sampling/sampled_balls.h"

namespace mes {

/// Guarantees:
///  1. `medial` holds the ball of each node of the axis once, and balls of points in between. A ball of the axis is the
///     largest in the union about its centre: its radius is the distance to the v-points of its piece.
///  2. `convex` holds the balls that singular or regular dual edges join, and between them circles through both
///     crossings of the two (their pencil), none thinner than a tenth of the smaller ball.
///  3. A piece or edge is halved until the circles at both ends of each part cross at `medial-sampling-angle` or more
///     (their radii at the crossing enclose 180 degrees less that), or the part is shorter than 1e-4 of the union's
///     diameter, or it has been halved twenty times.
///  4. There are at most `kMostBallsBetween` inside pieces, and as many inside edges. If there would be more,
///     neighbours may cross at 120 degrees where the dents between them are no deeper than a *tolerance*: the least
///     that suffices, or the largest of `wider_tolerance` if none does. `findings` reports it. At 120 degrees or less
///     there are as many as needed.
///
/// For display and for growing: radii and decisions are those of doubles. The samples of a piece depend on that piece
/// only, so updates of the union are followed locally. A rebuild is needed when the diameter doubles, and for every
/// change while there is a tolerance.
/// Cost: O(recomputed samples), and O(n) when the ball farthest out on one side changes.
class BallSampling : public Structure {
 public:
  const SampledBalls& medial() const { return medial_.balls; }
  const SampledBalls& convex() const { return convex_.balls; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return medial().changes().size() + convex().changes().size(); }
  std::vector<std::string_view> parameters() const override { return {Parameter::medial_sampling_angle.id}; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void find(std::vector<Finding>& out) const override;

 protected:
  BallSampling(std::string_view id, SettingsSource& settings, BallUnion& balls,
               std::size_t most_between = kMostBallsBetween);
  /// Calls `visit(row)` for the rows of `medial` about a node of the axis, and inside a piece of it. Of several nodes
  /// with one position and radius, one has the row.
  template <class Visit>
  void for_each_about(AxisNodeSlot node, Visit visit) const {
    medial_.balls.for_each_of(owner_of(node), visit);
  }
  template <class Visit>
  void for_each_inside(AxisPieceSlot piece, Visit visit) const {
    medial_.balls.for_each_of(owner_of_link(piece), visit);
  }
  /// The circles that must cross at the angle along the axis are scaled by this factor; at most 1.
  virtual double shrinking() const { return 1.0; }
  /// True for growing and shrinking: there are no convex balls, the structure fails if no tolerance suffices, and parts
  /// shorter than 1e-4 of the diameter are still halved as long as their circles are apart.
  virtual bool is_for_growing() const { return false; }
  const BallHalving& halving() const { return halving_; }

 private:
  /// A piece of the axis, or a dual edge.
  using LinkSlot = Slot<struct LinkTag>;
  /// One of the two samplings: balls of nodes, and of the links between them.
  struct Sampling {
    SampledBalls balls;
    std::size_t between = 0;                            ///< number of balls inside links
    Table<LinkSlot, std::array<AxisNodeSlot, 2>> ends;  ///< kNoSlot if the link is dead
    Table<AxisNodeSlot, std::uint32_t> degree;          ///< number of links at a node
  };
  /// The extent of the balls: each side of their box, and the ball there.
  struct Reach {
    std::array<double, 4> side{};
    std::array<FamilySlot, 4> ball{};
  };
  // Owners of sampled balls: nodes have even numbers, links odd ones.
  static OwnerSlot owner_of(AxisNodeSlot node) { return OwnerSlot(std::size_t{2} * node.index()); }
  template <class Link>
  static OwnerSlot owner_of_link(Link link) {
    return OwnerSlot(std::size_t{2} * link.index() + 1);
  }
  double angle() const { return settings_.current()[Parameter::medial_sampling_angle]; }
  void measure();
  void add_to_reach(FamilySlot ball);
  double diameter() const;
  double diameter_of_shape() const;
  double shortest() const;
  bool has_too_many(const Sampling& sampling) const { return is_bounded_ && sampling.between > most_between_; }
  /// Makes all balls; false if there are too many inside links.
  bool fill(JobControl& job);
  void set_ends(Sampling& sampling, LinkSlot link, const std::array<AxisNodeSlot, 2>& ends);
  void remake_piece(AxisPieceSlot row);
  void remake_edge(DualEdgeSlot row);
  void remake_ball(FamilySlot ball);
  void add_vertices_of_axis();

  const SettingsSource& settings_;
  const BallUnion& union_;
  std::size_t most_between_;
  bool is_bounded_ = true;  ///< false if no tolerance suffices, or none is of use
  double made_with_ = 0.0;
  double shortest_ = 0.0;
  BallHalving halving_;
  Reach reach_;
  Sampling medial_;  // links: pieces of the axis; nodes: balls, after them faces of the v-points
  Sampling convex_;  // links: dual edges; nodes: balls
  bool is_recording_ = false;
  SlotMarks<FamilySlot> marks_;
  std::vector<FamilySlot> touched_balls_;
};

class ABallSampling final : public BallSampling {
 public:
  ABallSampling(SettingsSource& settings, AUnion& balls, std::size_t most_between = kMostBallsBetween)
      : BallSampling("a-ball-sampling", settings, balls, most_between) {}
};

class BBallSampling final : public BallSampling {
 public:
  BBallSampling(SettingsSource& settings, BUnion& balls) : BallSampling("b-ball-sampling", settings, balls) {}
};

}  // namespace mes
