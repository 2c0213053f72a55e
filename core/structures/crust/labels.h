// SPDX-License-Identifier: GPL-3.0-or-later
// Inside or outside: a label for every Delaunay face, by parity across crust edges.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/crust/internal/conflict_join.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// What it guarantees:
///  1. Faces at infinity are outside. Across an edge the label changes exactly if it is crust, except at conflict
///     edges.
///  2. There are conflict edges only if some sample has odd crust degree, and then those of a canonical rule that
///     depends on the samples alone (internal/conflict_join.h), never on history.
///  3. An edit changes labels only of faces it made, unless conflicts moved or a gap opened or closed.
///
/// Cost: rebuild O(n). Update O(new faces + faces whose label changes). How: new faces take tentative labels from
/// their neighbours; where two faces then disagree with the edge between them, the smaller side of the disagreement,
/// found by searching all sides in lock-step, is turned over. Source: even-odd parity; the locality lemma of
/// docs/architecture.md.
class Labels final : public Structure {
 public:
  Labels(Delaunay& delaunay, OneStepCrust& crust);

  bool is_inside(FaceSlot face) const { return inside_[face] != 0; }
  bool is_conflict(EdgeSlot edge) const { return join_.is_conflict(edge); }
  std::size_t conflict_count() const { return join_.conflict_count(); }

  /// Faces that are new or have a new label.
  const ChangeSet<FaceSlot>& face_changes() const { return face_changes_; }
  /// Edges that changed, whose conflict bit changed, or whose faces have new labels.
  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return face_changes_.size() + edge_changes_.size(); }
  StatList statistics() const override;
  void find(std::vector<Finding>& out) const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  /// The label must change across the face's edge i.
  bool is_border(FaceSlot face, int i) const {
    const unsigned bits = crust_.crust_bits_of_face(face);
    const bool crust = ((bits >> static_cast<unsigned>(i)) & 1U) != 0;
    return crust != (join_.conflict_count() != 0 && has_conflict(face, i));
  }
  bool has_conflict(FaceSlot face, int i) const {
    const EdgeSlot edge = delaunay_.face(face).e[i];
    return edge != kNoSlot && join_.is_conflict(edge);
  }
  bool is_violated(FaceSlot face, int i) const {
    const FaceSlot other = delaunay_.face(face).n[i];
    return (inside_[face] != inside_[other]) != is_border(face, i);
  }
  void label_new_faces();
  bool repair(JobControl& job);

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  ConflictJoin join_;
  Table<FaceSlot, std::uint8_t> inside_;

  ChangeRecorder<FaceSlot> face_recorder_;
  ChangeRecorder<EdgeSlot> edge_recorder_;
  ChangeSet<FaceSlot> face_changes_;
  ChangeSet<EdgeSlot> edge_changes_;

  // Work space.
  struct Violation {
    FaceSlot face;
    FaceSlot other;
  };
  SlotMarks<FaceSlot> unlabelled_;
  std::vector<FaceSlot> queue_;
  std::vector<EdgeSlot> conflict_edges_;
  std::vector<FaceSlot> turned_;
  std::vector<Violation> violations_;
};

}  // namespace mes
