// SPDX-License-Identifier: GPL-3.0-or-later
// Regular triangulation and power diagram of the polar balls, and the power crust in it.
#pragma once

#include <memory>
#include <vector>

#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/poles/internal/polar_balls.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {

/// Each pole at infinity, or very far away, takes part as a large ball through its sample (`PolarBalls`).
class PolarDiagram final : public PowerDiagram {
 public:
  PolarDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles);

  /// True for a ball that represents a pole at infinity or very far away.
  bool is_far(FamilySlot ball) const { return polar_balls_.is_far(ball); }
  FaceSlot pole_of(FamilySlot ball) const { return polar_balls_.pole_of(ball); }
  void rebuild(JobControl& job) override;

 private:
  PolarDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles,
               std::unique_ptr<PolarBalls> family);
  PolarBalls& polar_balls_;
};

/// Edges of the polar power diagram between the cell of an inside pole and that of an outside one. Either two of them
/// meet at a vertex of the diagram or none, so they form closed curves. Every sample lies on the crust, as it touches a
/// polar ball on either side and no ball holds it.
///
/// Rows: edges of `PolarDiagram`. O(n); no local update. Source: Amenta, Choi and Kolluri 2001.
class PowerCrust final : public Structure {
 public:
  PowerCrust(PoleLabels& labels, PolarDiagram& diagram);

  bool is_crust(PowerEdgeSlot edge) const { return is_crust_[edge] != 0; }
  const PolarDiagram& diagram() const { return diagram_; }
  const ChangeSet<PowerEdgeSlot>& changes() const { return no_changes<PowerEdgeSlot>(); }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  PoleLabels& labels_;
  PolarDiagram& diagram_;
  Table<PowerEdgeSlot, std::uint8_t> is_crust_;
};

}  // namespace mes
