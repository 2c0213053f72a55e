// SPDX-License-Identifier: GPL-3.0-or-later
// Inside or outside: a label for every Delaunay face, by parity across crust edges.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/crust/internal/certainty_order.h"
#include "core/structures/crust/internal/certainty_tree.h"
#include "core/structures/crust/internal/conflict_join.h"
#include "core/structures/crust/internal/open_strokes.h"
#include "core/structures/crust/internal/side_search.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Guarantees:
///  1. Faces at infinity are outside. Across an edge the label changes exactly if it is a wall, except at conflict
///     edges. Walls are the crust edges, but for borders that regions share (one_step_crust.h).
///  2. There are conflict edges only if some sample has an odd number of walls. They follow a canonical rule that
///     depends on the samples and the borders alone, never on history: they are the edges of open strokes
///     (internal/open_strokes.h) and the join of the other odd samples in the minimum spanning tree in the order of
///     certainty (internal/certainty_order.h, internal/conflict_join.h).
///  3. An edit changes labels only of faces that it made, unless conflicts moved or a gap opened or closed.
///
/// Cost: rebuild O(n), O(n log n) where a good part of the samples is odd. Update O(new faces + faces whose label
/// changes), and O(log n) for each changed edge in the latter case. How: new faces take tentative labels from their
/// neighbours. Where two faces then disagree with the edge between them, one side of the disagreement is turned over:
/// the smaller, found by searching all sides in lock-step, or the one that the tree of faces selects. Odd samples
/// are joined in clusters (`ConflictJoin`), and labels follow from the conflicts. Where clusters would fill a good part
/// of the plane, as in noise, labels are handed on along the tree of faces (`CertaintyTree`), and conflicts follow from
/// them. Both ways give the same labels. Source: even-odd parity; the locality lemma of docs/geometry.md.
class Labels final : public Structure {
 public:
  Labels(Delaunay& delaunay, OneStepCrust& crust);

  bool is_inside(FaceSlot face) const { return inside_[face] != 0; }
  bool is_conflict(EdgeSlot edge) const { return conflict_.has(edge) && (conflict_[edge] & kIsConflict) != 0; }
  std::size_t conflict_count() const { return conflict_count_; }

  /// Faces that are new or have a new label.
  const ChangeSet<FaceSlot>& face_changes() const { return face_changes_; }
  /// Edges that changed, whose conflict bit changed, or whose faces have new labels.
  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void get_ready_to_update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return face_changes_.size() + edge_changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void find(std::vector<Finding>& out) const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  /// The tree is rebuilt when an edit changes more than one in this many edges.
  static constexpr std::size_t kFewEdges = 16;
  /// Samples are noise when more than one in this many sites is odd, clusters are large, ...
  static constexpr std::size_t kFewSites = 4;
  /// ... and there are so many odd sites that threads pay.
  static constexpr std::size_t kManyOddSites = 4096;
  static constexpr std::uint8_t kIsConflict = 1;
  /// In labels and conflicts, while change sets are made: the row is already in its change set.
  static constexpr std::uint8_t kIsListed = 2;

  // The next four are about edge `i` of a face, opposite its corner `i`.
  bool is_wall(FaceSlot face, int i) const {
    return ((static_cast<unsigned>(crust_.wall_bits_of_face(face)) >> static_cast<unsigned>(i)) & 1U) != 0;
  }
  /// True if the label must change across the edge.
  bool is_border(FaceSlot face, int i) const {
    if (is_idle_) return is_wall(face, i);
    const EdgeSlot edge = delaunay_.face(face).e[i];
    if (edge == kNoSlot) return false;
    return is_wall(face, i) != (tree_ ? strokes_.has_edge(edge) : is_conflict(edge));
  }
  /// True if the label of one face follows from that of the other.
  bool is_passage(FaceSlot face, int i) const {
    if (!tree_) return true;
    const EdgeSlot edge = delaunay_.face(face).e[i];
    return edge == kNoSlot || tree_->is_between_faces(edge);
  }
  bool is_violated(FaceSlot face, int i) const {
    const FaceSlot other = delaunay_.face(face).n[i];
    return is_passage(face, i) && (inside_[face] != inside_[other]) != is_border(face, i);
  }

  void choose_way(Table<EdgeSlot, std::uint8_t> is_in_tree, JobControl& job);
  void label_all(JobControl& job);
  void label_all_anew(JobControl& job);
  void find_touched_sites();
  bool follow_conflicts(JobControl& job);
  void label_new_faces();
  bool repair(JobControl& job);
  bool turn_along_tree(JobControl& job);
  void list_turned();
  void list_changes();
  void set_conflict(EdgeSlot edge, bool is_conflict);
  /// Decides by the trees or clusters, or by the labels that follow from them.
  bool is_in_conflict(EdgeSlot edge) const;
  void read_all_conflicts();
  void read_conflict(EdgeSlot edge);

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  CertaintyOrder order_;
  OpenStrokes strokes_;
  ConflictJoin join_;
  std::unique_ptr<CertaintyTree> tree_;  ///< null while clusters are used
  std::size_t odd_when_tree_grew_ = 0;
  bool is_idle_ = true;  ///< no site is odd, and there is nothing to forget
  Table<FaceSlot, std::uint8_t> inside_;
  Table<EdgeSlot, std::uint8_t> conflict_;  ///< empty until there is an odd site
  std::size_t conflict_count_ = 0;

  ChangeRecorder<FaceSlot> face_recorder_;
  ChangeRecorder<EdgeSlot> edge_recorder_;
  ChangeSet<FaceSlot> face_changes_;
  ChangeSet<EdgeSlot> edge_changes_;

  // Work space.
  SideSearch side_search_;
  SlotMarks<FaceSlot> face_marks_;
  SlotMarks<SiteSlot> touched_marks_;
  std::vector<SiteSlot> touched_;
  std::vector<FaceSlot> queue_;
  std::vector<EdgeSlot> conflict_edges_;
  std::vector<FaceSlot> turned_;
  std::vector<EdgeSlot> turned_edges_;  ///< edges of these faces, unless the triangulation's changes include them
  std::vector<EdgeSlot> edge_room_;
  struct Reached {
    FaceSlot face;
    EdgeSlot by;
  };
  std::vector<Reached> front_;
  std::vector<EdgeSlot> walls_;  ///< violated edges of `violations_`, where labels are turned along the tree
  std::vector<std::pair<FaceSlot, FaceSlot>> violations_;
};

}  // namespace mes
