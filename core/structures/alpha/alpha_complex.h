// SPDX-License-Identifier: GPL-3.0-or-later
// The alpha complex at one radius, and the union of the disks of that radius.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/arc.h"
#include "core/structures/alpha/alpha_filtration.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

/// Either end of an edge: row 2 e + i is end i of edge e.
using EdgeEndSlot = Slot<struct EdgeEndTag>;
using ClassSlot = Slot<struct ClassTag>;

/// Guarantees:
///  1. `holds` is exact: true for what enters at `alpha-radius` or before, ties included.
///  2. `arc` gives each arc of the boundary of the union of the disks once, to the left of the edge at whose crossing it
///     begins; a disk that meets no other has a whole circle instead (`is_alone`). Arcs are rounded.
///  3. A persistence pair is alive if it is born at the radius or before, and has not died by then.
///
/// Cost: an update takes O(simplices that enter or leave between the old radius and the new one), plus O(n) where disks
/// are shown. Rows are those of `Delaunay`, and of `AlphaFiltration::classes`.
class AlphaComplex final : public Structure {
 public:
  AlphaComplex(SettingsSource& settings, Delaunay& delaunay, AlphaFiltration& filtration);

  double radius() const { return radius_; }
  bool holds(EdgeSlot edge) const { return filtration_.rank(edge) <= last_; }
  /// The face must be finite.
  bool holds(FaceSlot face) const { return filtration_.rank(face) <= last_; }
  bool is_alive(const AlphaFiltration::Class& one) const { return one.birth <= last_ && last_ < one.death; }
  /// True if no edge at the site is held.
  bool is_alone(SiteSlot site) const { return is_alone_[site] != 0; }
  /// The arc that begins at the crossing to the left of the edge, seen from this end, and runs around the end.
  std::optional<Arc> arc(EdgeEndSlot row) const;

  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }
  const ChangeSet<FaceSlot>& face_changes() const { return face_changes_; }
  /// All sites, after the radius has changed.
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }
  /// All ends of edges that are or were held, after the radius has changed.
  const ChangeSet<EdgeEndSlot>& end_changes() const { return end_changes_; }
  const ChangeSet<ClassSlot>& class_changes() const { return class_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return edge_changes_.size() + face_changes_.size() + site_changes_.size(); }
  std::vector<std::string_view> parameters() const override { return {Parameter::alpha_radius.id}; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  void explain_end(EdgeEndSlot row, Explanation& out) const;
  void explain_class(const AlphaFiltration::Class& one, Explanation& out) const;
  double wish() const { return settings_.current()[Parameter::alpha_radius]; }
  void set_radius();
  /// Turns counter-clockwise around `site` from a held edge that has the face `left` to its left, and returns the far
  /// end of the next held edge; if `edge` is the only one, its own far end. Takes O(edges at the site) for all held
  /// edges of the site together.
  SiteSlot next_held(SiteSlot site, EdgeSlot edge, FaceSlot left) const;
  /// The crossing of the circles around the ends of an edge that lies to its left, seen from `site`.
  Vec2 crossing(SiteSlot site, SiteSlot other) const;
  bool is_open(FaceSlot face) const { return face == kNoSlot || delaunay_.face(face).is_infinite() || !holds(face); }

  const SettingsSource& settings_;
  const Delaunay& delaunay_;
  const AlphaFiltration& filtration_;
  double radius_ = 0.0;
  std::uint32_t last_ = 0;
  Table<SiteSlot, std::uint8_t> is_alone_;
  ChangeSet<EdgeSlot> edge_changes_;
  ChangeSet<FaceSlot> face_changes_;
  ChangeSet<SiteSlot> site_changes_;
  ChangeSet<EdgeEndSlot> end_changes_;
  ChangeSet<ClassSlot> class_changes_;
};

}  // namespace mes
