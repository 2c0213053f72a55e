// SPDX-License-Identifier: GPL-3.0-or-later
// Proof that the one-step axis is the medial axis of the union of the inner balls, or the places where the proof fails.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/box_tree.h"
#include "core/graph/structure.h"
#include "core/kernel/arc_predicates.h"
#include "core/structures/axis/inner_balls.h"

namespace mes {

/// Border edges are Delaunay edges between an inside and an outside face. Each is an arc of its inner ball's circle,
/// the part beyond the edge. Guarantees:
///  1. `is_certified()` is true exactly if (a) every sample that touches an inner ball has two border edges, and (b) no
///     other inner ball meets the open arc of a border edge, touching included. Decided exactly.
///  2. Then these arcs are the boundary of the union, its vertices are samples, and with Q_p the convex hull of the
///     centres of the inner balls that touch sample p:
///       - the dual complex of the union (closed convention) is the union of all Q_p;
///       - the v-points are the samples touched by at least two distinct balls;
///       - the medial axis of the union is the set of Voronoi edges between inside faces.
///     docs/union_of_balls.md has the argument.
///
/// Why it is local: the cap of a border edge is the part of its ball's disk beyond the edge. If an inner ball meets an
/// arc, then one does whose cap lies where that of the arc does: on the way from its triangle to the point on the arc,
/// the disks go on to hold the point, up to the last border edge before it. So the boxes of caps, which are small in dense
/// samples, are kept in trees, and an arc is tested against the balls of the caps near it.
///
/// Where every border edge passes the crust test, (b) holds (docs/union_of_balls.md) and nothing is searched; arcs of edges
/// that pass are only tested against caps of edges that fail. The trees are built once a border edge fails the test, or
/// before the first edit that may bring such an edge (`get_ready_to_update`).
///
/// Cost: rebuild O(n), and O(n log n + near caps) where arcs are searched; update O(changed faces + caps near them), plus one
/// rebuild if the first border edge that fails the crust test appears before `get_ready_to_update`, or with each edit if an
/// arc is near too many caps. Threads: arcs are searched on all cores.
class AxisCertificate final : public Structure {
 public:
  AxisCertificate(Delaunay& delaunay, Labels& labels, InnerBalls& balls);

  bool is_certified() const { return bad_edge_count() == 0 && bad_sites_ == 0; }
  /// True if another inner ball meets the arc of this border edge.
  bool is_bad_edge(EdgeSlot edge) const {
    return edge_.has(edge) && (edge_[edge] & (doubtful_edges_ != 0 ? kBad | kTooLong : kBad)) != 0;
  }
  /// True if the site touches inner balls but has no border edge, or more than two.
  bool is_bad_site(SiteSlot site) const { return bad_site_.has(site) && bad_site_[site] != 0; }
  std::size_t bad_edge_count() const { return bad_edges_ + (doubtful_edges_ != 0 ? too_long_edges_ : 0); }
  std::size_t bad_site_count() const { return bad_sites_; }

  bool is_border(EdgeSlot edge) const {
    const EdgeRow& row = delaunay_.edge(edge);
    return row.f[0] != kNoSlot && labels_.is_inside(row.f[0]) != labels_.is_inside(row.f[1]);
  }
  /// Edges whose verdict was recomputed.
  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void get_ready_to_update(JobControl& job) override;
  void clear_changes() override {
    edge_changes_.clear();
    site_changes_.clear();
  }
  std::size_t touched() const override { return edge_changes_.size() + site_changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override { return "intervals, then rationals"; }
  void find(std::vector<Finding>& out) const override;
  bool is_judge() const override { return true; }
  /// False if there are no inner balls: there is nothing to prove then.
  bool has_verdict() const override { return border_edges_ != 0; }

 private:
  static constexpr std::uint8_t kBorder = 1;
  static constexpr std::uint8_t kBad = 2;
  static constexpr std::uint8_t kDoubtful = 4;  ///< fails the crust test
  static constexpr std::uint8_t kTooLong = 8;   ///< its arc is near more caps than the search looks at

  /// Judge an edge or a site of which nothing is known yet.
  void judge_edge(EdgeSlot edge);
  void judge_site(SiteSlot site);
  void find_borders();
  /// A border edge with the box of its cap, rounded outwards.
  struct Cap {
    EdgeSlot edge{};
    FaceSlot face{};  ///< inner
    float low_x = 0, low_y = 0, high_x = 0, high_y = 0;
    Box2 box() const { return {{low_x, low_y}, {high_x, high_y}}; }
  };
  using CapTree = BoxTree<Cap>;
  Cap cap_of(EdgeSlot edge) const;
  static TreeBounds bounds_of(const Cap& cap) { return {.box = cap.box()}; }
  auto take_place() {
    return [this](const Cap& cap, std::uint32_t place) { place_[cap.edge] = place; };
  }
  void search_all(JobControl& job);
  void build_caps(CapTree& caps, std::uint8_t flags);
  CapTree& caps_of(EdgeSlot edge) { return (edge_[edge] & kDoubtful) != 0 ? doubtful_caps_ : crust_caps_; }
  void forget_searches();
  void forget_edge(EdgeSlot edge);
  struct Verdict {
    std::uint8_t flag = 0;  ///< `kBad`, `kTooLong` or 0
    EdgeSlot met{};         ///< if bad: a border edge whose inner ball meets the arc
  };
  Verdict verdict_on_arc(EdgeSlot edge) const;
  void take(EdgeSlot edge, const Verdict& verdict);
  void forget_verdict(EdgeSlot edge);
  FaceSlot inner_face(EdgeSlot edge) const;
  Corners corners_of(FaceSlot face) const;
  /// Corners of its inner face, that opposite to the edge first.
  Corners corners_beside(EdgeSlot edge) const;
  /// Holds the cap, whatever is rounded. O(1).
  Box2 box_of_cap(EdgeSlot edge) const;

  Delaunay& delaunay_;
  Labels& labels_;
  InnerBalls& balls_;
  Table<EdgeSlot, std::uint8_t> edge_;
  Table<SiteSlot, std::uint8_t> bad_site_;
  std::size_t border_edges_ = 0;
  std::size_t bad_edges_ = 0;
  std::size_t doubtful_edges_ = 0;
  std::size_t too_long_edges_ = 0;
  bool is_searched_ = false;  ///< every arc has been searched, as far as needed
  std::size_t bad_sites_ = 0;
  // If arcs have been searched: the caps of border edges that pass the crust test, and of those that fail it.
  CapTree crust_caps_;
  CapTree doubtful_caps_;
  Table<EdgeSlot, std::uint32_t> place_;           // of border edges in their tree
  std::unordered_map<EdgeSlot, EdgeSlot> met_by_;  // for each bad edge
  std::set<std::pair<EdgeSlot, EdgeSlot>> meets_;  // the same, from the other end
  ChangeRecorder<EdgeSlot> edge_recorder_;
  ChangeRecorder<SiteSlot> site_recorder_;
  ChangeSet<EdgeSlot> edge_changes_;
  ChangeSet<SiteSlot> site_changes_;
  // Work space.
  SlotMarks<SiteSlot> judged_sites_;
  SlotMarks<EdgeSlot> judged_edges_;
};

}  // namespace mes
