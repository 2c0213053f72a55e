// SPDX-License-Identifier: GPL-3.0-or-later
// Inner Voronoi balls: the circumdisks of inside triangles, with equal ones known as one.
#pragma once

#include <unordered_map>
#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/labels.h"

namespace mes {

/// What it guarantees:
///  1. A face is a ball exactly when it is finite and inside.
///  2. Two faces have the same `ball` exactly when their circumcircles are equal as real circles (cocircular sites);
///  the
///     decision is exact. Such faces always have the same label.
///
/// Rows are those of the Delaunay faces; `ball(face)` is one face of the group. Cost: O(faces); updates O(changed
/// faces + sizes of changed groups).
class InnerBalls final : public Structure {
 public:
  InnerBalls(Delaunay& delaunay, OneStepCrust& crust, Labels& labels);

  bool is_ball(Slot face) const { return labels_.is_inside(face) && delaunay_.is_finite_face(face); }
  /// The face that stands for all faces with this circumcircle.
  Slot ball(Slot face) const {
    if (group_of_.empty()) return face;
    const auto found = group_of_.find(face);
    return found == group_of_.end() ? face : groups_.at(found->second).front();
  }
  /// Faces with the same circumcircle, for a face for which there are several; otherwise null.
  const std::vector<Slot>* group(Slot face) const {
    const auto found = group_of_.find(face);
    return found == group_of_.end() ? nullptr : &groups_.at(found->second);
  }

  /// Faces that became, are still or stopped being balls, or whose group changed.
  const ChangeSet& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  StatList statistics() const override;

 private:
  bool has_cocircular_edge(Slot face) const;
  void gather_group(Slot face);

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  Labels& labels_;
  // Groups of two or more faces; without cocircular samples both are empty.
  std::unordered_map<Slot, Slot> group_of_;
  std::unordered_map<Slot, std::vector<Slot>> groups_;
  Slot next_group_ = 0;
  ChangeRecorder recorder_;
  ChangeSet changes_;
  std::vector<Slot> work_;
};

}  // namespace mes
