// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of a family grown by one amount: their dual complex, their union and its boundary.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/change_set.h"
#include "core/structures/balls/internal/growth/ball_filtration.h"

namespace mes {

/// Either end of an edge: row 2 e + i is end i of edge e.
using GrownEndSlot = Slot<struct GrownEndTag>;
using GrownClassSlot = Slot<struct GrownClassTag>;

/// Guarantees:
///  1. `holds` is exact: true for what enters at a growth of `alpha-radius` or before, ties included.
///  2. `arc` gives each arc of the boundary of the union of the grown balls once, to the left of the edge at whose
///     crossing it begins; a ball that meets no other has a whole circle instead (`is_alone`). The set of arcs is
///     exact, even for balls about nearly one centre. Their ends are rounded; the angle that they turn through is not
///     computed from these.
///  3. A persistence pair is alive if it is born at that growth or before, and has not died by then.
///
/// Cost: an update takes O(simplices that enter or leave between the old growth and the new one), plus O(n) for disks
/// and boundary. Rows are those of the filtration.
class GrownComplex : public Structure {
 public:
  const BallFiltration& filtration() const { return filtration_; }
  double growth() const { return growth_; }
  bool holds(GrownCornerSlot corner) const { return filtration_.corners()[corner].rank < come_; }
  bool holds(GrownEdgeSlot edge) const { return filtration_.edges()[edge].rank < come_; }
  bool holds(GrownTriangleSlot triangle) const { return filtration_.triangles()[triangle].rank < come_; }
  bool is_alive(const BallFiltration::Class& one) const { return one.birth < come_ && come_ <= one.death; }
  /// True if the corner is held, and no edge at it is.
  bool is_alone(GrownCornerSlot corner) const { return holds(corner) && !has_edge_[corner]; }
  /// The grown disk, rounded.
  Disk disk(GrownCornerSlot corner) const;
  /// The arc that begins at the crossing left of the edge, seen from this end, and goes around it. May have length 0.
  std::optional<BoundaryArc> arc(GrownEndSlot row) const;
  /// The arc as it is drawn, if it can be seen.
  std::optional<Arc> drawn(GrownEndSlot row) const;

  const ChangeSet<GrownCornerSlot>& corner_changes() const { return corner_changes_; }
  const ChangeSet<GrownEdgeSlot>& edge_changes() const { return edge_changes_; }
  const ChangeSet<GrownTriangleSlot>& triangle_changes() const { return triangle_changes_; }
  const ChangeSet<GrownEndSlot>& end_changes() const { return end_changes_; }
  const ChangeSet<GrownClassSlot>& class_changes() const { return class_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override {
    return corner_changes_.size() + edge_changes_.size() + triangle_changes_.size();
  }
  std::vector<std::string_view> parameters() const override { return {Parameter::alpha_radius.id}; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 protected:
  GrownComplex(std::string_view id, SettingsSource& settings, BallFiltration& filtration);

 private:
  void explain_corner(GrownCornerSlot corner, Explanation& out) const;
  void explain_edge(GrownEdgeSlot edge, Explanation& out) const;
  void explain_triangle(GrownTriangleSlot triangle, Explanation& out) const;
  void explain_end(GrownEndSlot end, Explanation& out) const;
  void explain_class(const BallFiltration::Class& one, Explanation& out) const;
  double wish() const { return settings_.current()[Parameter::alpha_radius]; }
  void find_ways();
  void set_growth();
  /// For row 2 e + i: the crossing of the circles about the ends of a held edge, to its left seen from end i.
  Vec2 crossing(GrownEndSlot end) const;
  /// Half the distance of the two crossings, in the frame.
  double half_chord(GrownEdgeSlot edge) const;
  /// The angle at an end of a held edge between the edge and the direction of either crossing.
  double half_angle(GrownEndSlot end) const;
  GrownEndSlot end_at(GrownCornerSlot corner, GrownEdgeSlot edge) const {
    return GrownEndSlot(2 * edge.index() + (filtration_.edges()[edge].v[0] == corner ? 0U : 1U));
  }
  /// Direction of the edge, away from the end.
  Vec2 direction(GrownEndSlot end) const;
  struct Spoke {
    GrownEndSlot end;
    double turn = 0.0;  ///< a whole turn if the spoke is the edge itself
  };
  /// The first held edge counter-clockwise about an end of an edge, and the angle to it. Rounded numbers decide no
  /// angle: inside a triangle it is below half a turn, and outside of the hull it is not.
  Spoke next_held(GrownEndSlot from) const;
  bool is_open(GrownTriangleSlot triangle) const { return triangle == kNoSlot || !holds(triangle); }

  const SettingsSource& settings_;
  const BallFiltration& filtration_;
  double growth_ = 0.0;
  std::uint32_t come_ = 0;                 // ranks below it have entered
  Table<GrownCornerSlot, bool> has_edge_;  // an edge that is held
  /// For a corner of the hull, the edge with the outside to its right. If all centres are collinear, both edges.
  Table<GrownCornerSlot, std::array<GrownEdgeSlot, 2>> hull_edge_;
  ChangeSet<GrownCornerSlot> corner_changes_;
  ChangeSet<GrownEdgeSlot> edge_changes_;
  ChangeSet<GrownTriangleSlot> triangle_changes_;
  ChangeSet<GrownEndSlot> end_changes_;
  ChangeSet<GrownClassSlot> class_changes_;
};

class AGrownComplex final : public GrownComplex {
 public:
  AGrownComplex(SettingsSource& settings, ABallFiltration& filtration)
      : GrownComplex("a-grown-complex", settings, filtration) {}
};

class BGrownComplex final : public GrownComplex {
 public:
  BGrownComplex(SettingsSource& settings, BBallFiltration& filtration)
      : GrownComplex("b-grown-complex", settings, filtration) {}
};

}  // namespace mes
