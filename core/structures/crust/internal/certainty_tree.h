// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning tree of the whole triangulation, and the tree of faces beside it, under edits.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/base/jobs/prefetch.h"
#include "core/structures/crust/internal/certainty_order.h"
#include "core/structures/crust/internal/link_cut_forest.h"

namespace mes {

/// Every Delaunay edge is in one of two trees. The minimum spanning tree of the sites, in the order of certainty, has
/// the doubtful ones. The others, the sure ones, are crossed by the tree of the faces, in which everything at infinity
/// is one face. Labels handed on from infinity through the tree of faces agree with `ConflictJoin`: only edges of the
/// tree of sites can contradict the crust.
///
/// Guarantee: the trees depend on the positions of the sites alone, whatever the history.
///
/// Cost: rebuild O(n log n), see `spanning_tree`; update O(log n), amortised, for each edge that was added, removed or
/// ranked differently. About 300 bytes per site. How: a removed edge is replaced by the most doubtful edge on the path
/// between its two faces; an inserted edge replaces the surest edge on the path between its two sites, if that is surer
/// than itself. Source: Eppstein, Italiano, Tamassia, Tarjan, Westbrook and Yung, "Maintenance of a minimum spanning
/// forest in a dynamic plane graph", 1992.
class CertaintyTree {
 public:
  CertaintyTree(const Delaunay& delaunay, const OneStepCrust& crust, const CertaintyOrder& order);
  CertaintyTree(const CertaintyTree&) = delete;
  CertaintyTree& operator=(const CertaintyTree&) = delete;

  /// True if the edge is in the tree of faces; otherwise it is in that of the sites.
  bool is_between_faces(EdgeSlot edge) const { return place_[edge] >= Place::faces; }
  void expect(EdgeSlot edge) const { prefetch(place_.address(edge)); }

  /// Only records which edge is in which tree. Takes the spanning tree (spanning_tree.h) and the keys of all edges.
  void rebuild(const Table<EdgeSlot, std::uint8_t>& is_in_tree, Table<EdgeSlot, double> keys);
  /// Builds the other data that `update` needs, which is the larger part of the work.
  void make_forests(JobControl& job);
  /// True if `make_forests` has been called since `rebuild`.
  bool has_forests() const { return has_forests_; }
  /// Applies the change sets of the triangulation and the crust.
  void update(JobControl& job);
  /// Each pair are neighbours in the tree of faces. Finds the one of the two that an odd number of these pairs
  /// separates from infinity. Requires the forests. O(log n) for each pair, amortised.
  void find_odd_sides(const std::vector<std::pair<FaceSlot, FaceSlot>>& pairs, std::vector<FaceSlot>& out);
  /// Walls for a walk through the tree of faces; each can be marked as met. They must be lowered before the next
  /// update.
  void raise(std::span<const EdgeSlot> walls) {
    for (const EdgeSlot edge : walls) place_[edge] = Place::wall;
  }
  void lower(std::span<const EdgeSlot> walls) {
    for (const EdgeSlot edge : walls) place_[edge] = Place::faces;
  }
  bool is_wall(EdgeSlot edge) const { return place_[edge] >= Place::wall; }
  void meet(EdgeSlot wall) { place_[wall] = Place::met_wall; }
  bool is_met(EdgeSlot wall) const { return place_[wall] == Place::met_wall; }
  /// Edges that the last update put into the tree of faces.
  const std::vector<EdgeSlot>& new_between_faces() const { return new_between_faces_; }

 private:
  enum class Place : std::uint8_t { none, sites, faces, wall, met_wall };  // the last two are between faces
  /// Vertices of the two forests. Face 0 is everything at infinity.
  using Vertex = std::uint32_t;
  struct Ends {
    Vertex sites[2]{};
    Vertex faces[2]{};
  };
  struct Surer {
    const CertaintyTree* tree;
    bool operator()(EdgeSlot a, EdgeSlot b) const { return tree->is_surer(a, b); }
  };
  struct MoreDoubtful {
    const CertaintyTree* tree;
    bool operator()(EdgeSlot a, EdgeSlot b) const { return tree->is_surer(b, a); }
  };

  bool is_surer(EdgeSlot a, EdgeSlot b) const { return order_.is_surer({key_[a], a}, {key_[b], b}); }
  Vertex vertex_of(FaceSlot face) const { return delaunay_.face(face).is_infinite() ? 0 : face.index() + 1; }
  Ends ends_of(EdgeSlot edge) const;
  void make_room();
  void put_between_sites(EdgeSlot edge);
  void put_between_faces(EdgeSlot edge);
  void take_out(EdgeSlot edge);
  void insert(EdgeSlot edge);

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  const CertaintyOrder& order_;
  bool has_forests_ = false;
  Table<EdgeSlot, double> key_;
  Table<EdgeSlot, Ends> ends_;
  Table<EdgeSlot, Place> place_;
  LinkCutForest<EdgeSlot, Surer> sites_;
  LinkCutForest<EdgeSlot, MoreDoubtful> faces_;

  // Work space.
  std::vector<EdgeSlot> going_;
  std::vector<EdgeSlot> coming_;
  std::vector<EdgeSlot> new_between_faces_;
  SlotMarks<EdgeSlot> marks_;
};

}  // namespace mes
