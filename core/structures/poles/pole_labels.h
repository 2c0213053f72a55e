// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which poles are inside.
#pragma once

#include <vector>

#include "core/structures/crust/labels.h"
#include "core/structures/inputs/settings_source.h"
#include "core/structures/poles/poles.h"

namespace mes {

/// The parameter `pole-propagation` selects one of two ways:
///  0. A pole has the label of its triangle.
///  1. Poles at infinity are outside. The two poles of a sample have opposite labels, and polar balls that are
///     neighbours in the regular triangulation and overlap deeply have equal ones. Labels spread from the poles at
///     infinity, along the surest link first (opposite poles by the angle at the sample, overlapping balls by the angle
///     of their circles). Poles that no link reaches have the label of their triangle. Deep overlap is decided exactly,
///     the order of links in doubles, with ties by coordinates.
///
/// Cost: the first way O(changes); the second a regular triangulation of the poles after every change.
/// Source of the second: Amenta, Choi and Kolluri 2001.
class PoleLabels final : public Structure {
 public:
  PoleLabels(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Labels& labels, Poles& poles);

  /// The face must be a pole, that is, `Poles::is_pole` holds.
  bool is_inside(FaceSlot face) const { return is_spread_ ? inside_[face] != 0 : labels_.is_inside(face); }
  bool is_inside_pole(FaceSlot face) const { return poles_.is_pole(face) && is_inside(face); }

  /// Faces that became, remained or ceased to be poles, or whose label changed.
  const ChangeSet<FaceSlot>& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  std::vector<std::string_view> parameters() const override { return {Parameter::pole_propagation.id}; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override;

 private:
  bool wants_spreading() const { return settings_.current().is_on(Parameter::pole_propagation); }
  void spread(JobControl& job);

  SettingsSource& settings_;
  Delaunay& delaunay_;
  VoronoiVertices& vertices_;
  Labels& labels_;
  Poles& poles_;
  bool is_spread_ = false;
  Precision made_with_ = Precision::fast;
  Table<FaceSlot, std::uint8_t> inside_;  // filled if labels are spread
  std::int64_t unreached_ = 0;
  ChangeRecorder<FaceSlot> recorder_;
  ChangeSet<FaceSlot> changes_;
};

}  // namespace mes
