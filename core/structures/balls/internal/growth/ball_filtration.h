// SPDX-License-Identifier: GPL-3.0-or-later
// Additive growth of the balls of a family, for all amounts at once: when each ball, edge and triangle of the dual
// complex enters, and which components and holes are born and die.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/graph/structure.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/internal/growth/ball_births.h"
#include "core/structures/balls/local_balls.h"

namespace mes {

/// The growth at which each rank enters. It does not change, so it may be read from any thread.
struct GrowthRanks {
  LocalBalls balls;
  std::vector<BallBirths::Level> levels;  ///< by rank, like `growth`
  std::vector<double> growth;             ///< rounded up; guarantee 3 below

  /// Number of ranks that have entered at this growth, exactly. `a` is not negative.
  std::uint32_t within(double a) const { return levels_within(balls.input(), levels, a); }
};

/// Grown by a, a ball of radius r has the radius sqrt(r^2 + a^2), so that all power cells stay as they are; grown by a
/// negative a it has sqrt(r^2 - a^2), and is missing where that is not a number. The dual complexes of the grown balls
/// are nested: they are the alpha complexes of weighted points. They have the homotopy type of the union, and at a = 0
/// they are the dual complex of the family's own union. If all radii are 0, they are those of `AlphaFiltration`, in the
/// same order; its radius is a growth here, which is rounded less closely.
///
/// Guarantees:
///  1. Simplices that enter at the same growth, as a real number, have the same *rank*; other ranks are in the order of
///     growth. This is exact for the balls as they are: disks with their doubles, circumdisks of samples with centre
///     and radius as rationals, radii times the family's scale; whatever the number type of the settings.
///  2. The edges and triangles at which pairs are born and die are a function of the balls. Pairs without a lifetime
///     are left out. A component is born at the ball that enters first.
///  3. `growth` of a rank is a double that is not smaller than the true growth, and larger by less than a part in
///     10^11. At a parameter of this value, the rank has entered. It is for texts and scales; `ranks_within` tells
///     exactly which ranks have entered.
///  4. Balls without a power cell, duplicates, and balls beyond the doubles are left out; those of radius 0 are not.
///
/// Cost: O(n log n), mostly of intervals, plus a rational number for each growth that equals another or nearly so.
/// Every update recomputes all. Threads: those of the graph.
/// Source: Edelsbrunner 1995; Edelsbrunner, Letscher and Zomorodian 2002.
class BallFiltration : public Structure {
 public:
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  const BallFamily& family() const { return *family_; }
  const Table<GrownCornerSlot, BallBirths::Corner>& corners() const { return births_.corners; }
  const Table<GrownEdgeSlot, BallBirths::Edge>& edges() const { return births_.edges; }
  const Table<GrownTriangleSlot, BallBirths::Triangle>& triangles() const { return births_.triangles; }
  FamilySlot ball(GrownCornerSlot corner) const { return ranks_->balls.balls[births_.corners[corner].ball].row; }
  /// The disk before it grows, rounded.
  const Disk& disk(GrownCornerSlot corner) const { return ranks_->balls.balls[births_.corners[corner].ball].drawn; }

  std::size_t rank_count() const { return ranks_->growth.size(); }
  double growth(std::uint32_t rank) const { return ranks_->growth[rank]; }
  /// Number of ranks that have entered at this growth, exactly. `a` is not negative.
  std::uint32_t ranks_within(double a) const { return ranks_->within(a); }
  /// All balls before they grow, in their frame; a corner names its own.
  PipelineInput balls() const { return ranks_->balls.input(); }
  /// The current ranks, to be kept.
  std::shared_ptr<const GrowthRanks> ranks() const { return ranks_; }

  /// A component of the union of the grown balls, or a hole in it.
  struct Class {
    bool is_hole = false;
    std::uint32_t birth = 0;       ///< rank of its birth
    std::uint32_t death = kNever;  ///< rank of its death; `kNever` if it stays
    GrownCornerSlot corner{};      ///< for a component: where it is born
    GrownEdgeSlot edge{};          ///< joins the component to an older one, or closes the hole; kNoSlot if it stays
    GrownTriangleSlot triangle{};  ///< for a hole: the triangle that fills it
  };
  const std::vector<Class>& classes() const { return classes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  std::vector<std::string_view> parameters() const override { return {scale_.id}; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override { return "intervals, rationals"; }

 protected:
  BallFiltration(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
                 std::unique_ptr<BallFamily> family, const Parameter& scale);

 private:
  void find_classes();

  const SettingsSource& settings_;
  std::unique_ptr<BallFamily> family_;
  Parameter scale_;
  BallBirths births_;  // without its levels
  std::shared_ptr<const GrowthRanks> ranks_ = std::make_shared<const GrowthRanks>();
  std::vector<Class> classes_;
};

/// Filtration of the inner Voronoi balls.
class ABallFiltration final : public BallFiltration {
 public:
  ABallFiltration(SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls);
};

/// Filtration of the user's balls.
class BBallFiltration final : public BallFiltration {
 public:
  BBallFiltration(SettingsSource& settings, UserBalls& balls);
};

}  // namespace mes
