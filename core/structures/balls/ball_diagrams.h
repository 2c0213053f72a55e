// SPDX-License-Identifier: GPL-3.0-or-later
// Two diagrams of a union of balls, computed only where a layer shows them: the regular triangulation with the power
// diagram of the balls, and the Voronoi diagram of the v-points.
#pragma once

#include <optional>
#include <vector>

#include "core/structures/balls/ball_union.h"

namespace mes {

/// Regular triangulation of the balls of a union and its dual, the power diagram. Decided in the number type of the
/// settings; `exact_roots` needs no roots here. Hidden balls have no cell. No local update.
class PowerDiagram : public Structure {
 public:
  const Table<PowerEdgeSlot, PowerEdge>& edges() const { return edges_; }
  const BallFamily& family() const { return *family_; }
  const ChangeSet<PowerEdgeSlot>& changes() const { return no_changes<PowerEdgeSlot>(); }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  std::vector<std::string_view> parameters() const override {
    return scale_ ? std::vector<std::string_view>{scale_->id} : std::vector<std::string_view>();
  }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  /// Explains the cell of a ball.
  void explain_cell(FamilySlot ball, Explanation& out) const;
  /// If there is no `scale`, the balls keep their radii.
  PowerDiagram(std::string_view id, std::vector<Structure*> inputs, const SettingsSource& settings,
               std::unique_ptr<BallFamily> family, std::optional<Parameter> scale = std::nullopt);
  BallFamily& own_family() { return *family_; }

 private:
  double scale() const { return scale_ ? settings_.current()[*scale_] : 1.0; }

  const SettingsSource& settings_;
  std::unique_ptr<BallFamily> family_;
  std::optional<Parameter> scale_;
  Precision made_with_ = Precision::fast;
  Table<PowerEdgeSlot, PowerEdge> edges_;
};

/// Delaunay triangulation and Voronoi diagram of the v-points, with their parts in the axis. The union's own where its
/// pipeline made one; after the shortcut, whose v-points are samples, made here. No local update.
class VDiagram : public Structure {
 public:
  /// Has `v_points`, `v_faces` and `v_edges`.
  const UnionTables& tables() const { return union_.rung() == UnionRung::shortcut ? own_ : union_.tables(); }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  VDiagram(std::string_view id, std::vector<Structure*> inputs, const BallUnion& balls);
  /// For the shortcut: the positions of the v-points on the circles.
  virtual KnownVPoints known_v_points(const Table<InputSlot, PipelineBall>& balls) const;

 private:
  const BallUnion& union_;
  UnionTables own_;
};

class APowerDiagram final : public PowerDiagram {
 public:
  APowerDiagram(SettingsSource& settings, Delaunay& delaunay, Labels& labels, InnerBalls& balls);
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;
};

/// Power diagram of all finite Voronoi balls, inside and outside.
class VoronoiBallDiagram final : public PowerDiagram {
 public:
  VoronoiBallDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices);
};

class BPowerDiagram final : public PowerDiagram {
 public:
  BPowerDiagram(SettingsSource& settings, UserBalls& balls);
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;
};

class BVDiagram final : public VDiagram {
 public:
  explicit BVDiagram(BUnion& b_union);
};

class AVDiagram final : public VDiagram {
 public:
  AVDiagram(Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls, AUnion& a_union);

 private:
  KnownVPoints known_v_points(const Table<InputSlot, PipelineBall>& balls) const override;
  bool is_diagonal(FaceSlot face, int i) const;
  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  const Labels& labels_;
  const InnerBalls& balls_;
  const AUnion& union_;
};

}  // namespace mes
