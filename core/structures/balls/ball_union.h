// SPDX-License-Identifier: GPL-3.0-or-later
// The union of a family of balls: dual complex, v-points, medial axis.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/graph/structure.h"
#include "core/structures/balls/ball_family.h"
#include "core/structures/balls/internal/shortcut/sample_union.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/inputs/settings_source.h"
#include "core/structures/inputs/user_balls.h"

namespace mes {

/// The way in which a union was computed.
enum class UnionRung : std::uint8_t {
  shortcut,  ///< from shared samples, certified: exact, no arithmetic
  naive,     ///< the pipeline in plain doubles, in a process of its own
  doubles,   ///< the pipeline, exact predicates on doubles, constructed points rounded
  rational,  ///< the pipeline in rationals: every crossing is a sample or the image of one
  mixed,     ///< the pipeline in rationals, and crossings in fields with roots
  roots,     ///< the pipeline in algebraic numbers
};
std::string_view name_of(UnionRung rung);

/// Guarantees:
///  1. With `exact` and `exact_roots` the tables are those of the balls as real disks: for Voronoi balls the
///     circumdisks of the samples, not their rounded images. Positions are rounded at the very end.
///  2. `fast` gives the same for balls of samples, by the shortcut where `AxisCertificate` holds, else as `exact` does;
///     and for up to a thousand other balls. For more, the result is that of rounded numbers, unless it is in doubt:
///     where dual complex and axis contradict each other, or v-points are nearer to each other than rounding tells
///     apart. If the parameter `union-shortcut` is off, it is always that of rounded numbers, which may differ in kind;
///     `findings` reports this where it shows.
///  3. `naive` may give anything or fail, but ends.
///  4. Closed convention: balls that touch are joined. Balls of radius zero are left out.
///  5. Balls are scaled about their centres before anything else: where decisions are exact, by exactly the double that
///     the parameter holds. Scaled Voronoi balls touch no samples, so the shortcut is for scale 1.
///
/// Cost: the shortcut O(n), updates O(changes), without arithmetic; `doubles` about three times the regular
/// triangulation; `exact` two to five times as much as `doubles` for 10^4 balls, up to twenty times for 10^5.
/// Source: Edelsbrunner 1995 (dual complex), Attali and Montanvert 1997 (axis); the theorem of the demo paper.
class BallUnion : public Structure {
 public:
  const BallFamily& family() const { return *family_; }
  const UnionTables& tables() const { return tables_; }
  const UnionChanges& changes() const { return changes_; }
  UnionRung rung() const { return rung_; }
  /// The reason for this rung instead of a cheaper one.
  const std::string& why() const { return why_; }
  /// Dual edges and faces of the balls as real disks, whatever the number type of the settings.
  UnionTables exact_dual_complex(JobControl& job) const;
  bool is_exact() const { return rung_ != UnionRung::naive && rung_ != UnionRung::doubles; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  std::vector<std::string_view> parameters() const override { return {Parameter::union_shortcut.id, scale_.id}; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override;
  void find(std::vector<Finding>& out) const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  /// Explains the role of one of its balls in the union.
  void explain_place(FamilySlot row, Explanation& out) const;
  /// Explains its radius, if balls are scaled.
  void explain_scale(FamilySlot row, Explanation& out) const;
  /// `certificate` and `shortcut` are given only for the inner Voronoi balls.
  BallUnion(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
            const Parameter& scale, std::unique_ptr<BallFamily> family, const AxisCertificate* certificate = nullptr,
            std::unique_ptr<SampleUnion> shortcut = nullptr);
  /// Called with the result of the pipeline, before anything else reads it.
  virtual void refine(UnionTables&) {}
  /// Used instead of `rebuild`: the balls are those of another union, which outlives this one. O(size of its tables).
  void take_over(const BallUnion& other);
  /// Used instead of `update` after `take_over`: takes the other union's changes. O(changes); false: call `take_over`.
  bool follow(const BallUnion& other);

 private:
  struct Choice {
    Precision precision = Precision::fast;
    bool use_shortcut = true;
    double scale = 1.0;
    friend bool operator==(const Choice&, const Choice&) = default;
  };
  Choice choice() const;
  UnionMeasures measures() const;
  bool is_shortcut_valid() const;
  void run_pipeline(Precision precision, JobControl& job);
  UnionTables run_pipeline(Precision precision, const PipelineInput& input, JobControl& job);

  const SettingsSource& settings_;
  Parameter scale_;
  std::unique_ptr<BallFamily> family_;
  const AxisCertificate* certificate_;
  std::unique_ptr<SampleUnion> shortcut_;
  const BallUnion* taken_from_ = nullptr;  ///< null if the tables are its own
  Choice made_with_;
  UnionRung rung_ = UnionRung::doubles;
  std::string why_;
  std::size_t ignored_ = 0;  ///< balls of radius zero, and those beyond doubles
  UnionTables tables_;
  UnionChanges changes_;
};

/// The inner Voronoi balls as a family. Rows: Delaunay faces.
std::unique_ptr<BallFamily> inner_voronoi_balls(const Delaunay& delaunay, const InnerBalls& balls);

/// The inner Voronoi balls. Rows of balls: Delaunay faces.
class AUnion final : public BallUnion {
 public:
  AUnion(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls,
         MedialAxis& axis, AxisCertificate& certificate);
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;
};

/// The user's balls. Rows: the document's ball slots.
class BUnion final : public BallUnion {
 public:
  BUnion(SettingsSource& settings, UserBalls& balls);
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;
};
std::unique_ptr<BallFamily> user_ball_family(const UserBalls& balls);

}  // namespace mes
