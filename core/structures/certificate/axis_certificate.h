// SPDX-License-Identifier: GPL-3.0-or-later
// Proof that the one-step axis is the medial axis of the union of the inner balls, or the places where the proof fails.
#pragma once

#include <unordered_map>
#include <vector>

#include "core/base/change_set.h"
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
/// Why it is local: the Delaunay disks that contain a point form a connected region of faces. If an inner ball meets
/// the arc beyond pq at x, the faces whose open disk contains x are connected to it, and include the outside face at
/// pq. So the search starts at that face, passes through outside faces that meet the arc, and looks at their
/// neighbours. In a dense sample these are faces at p or q.
///
/// Where every border edge passes the crust test, (b) holds (docs/union_of_balls.md) and nothing is searched. Searches
/// are made once a border edge fails the test, or before the first edit that may bring such an edge
/// (`get_ready_to_update`).
///
/// Cost: rebuild O(n), plus about 1 us per border edge for dense samples where arcs are searched; update O(changed
/// faces), plus one rebuild if the first border edge that fails the crust test appears before `get_ready_to_update`.
/// Threads: all arcs are searched on all cores.
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
  static constexpr std::uint8_t kTooLong = 8;   ///< its arc has more faces than the search visits

  /// Judge an edge or a site of which nothing is known yet.
  void judge_edge(EdgeSlot edge);
  void judge_site(SiteSlot site);
  void find_borders();
  void search_all(JobControl& job);
  void search(EdgeSlot edge);
  void forget_searches();
  void forget_edge(EdgeSlot edge);
  /// Work space of searches; one per thread.
  struct Search {
    SlotMarks<FaceSlot> seen{};
    std::vector<FaceSlot> queue{};
    std::vector<FaceSlot> far{};  ///< faces that decided and do not touch an end of the edge; if updates will follow
  };
  /// Returns `kBad`, `kTooLong` or 0.
  std::uint8_t verdict_on_arc(EdgeSlot edge, Search& search) const;
  Corners corners_of(FaceSlot face) const;

  Delaunay& delaunay_;
  Labels& labels_;
  InnerBalls& balls_;
  Table<EdgeSlot, std::uint8_t> edge_;
  Table<SiteSlot, std::uint8_t> bad_site_;
  std::size_t border_edges_ = 0;
  std::size_t bad_edges_ = 0;
  std::size_t doubtful_edges_ = 0;
  std::size_t too_long_edges_ = 0;
  bool is_searched_ = false;  ///< every arc has been searched
  std::size_t bad_sites_ = 0;
  // Searches that went beyond the faces at the ends of their edge watch the far faces they saw. A far face may be
  // watched by thousands of edges, so its watches form a list that each can leave in O(1).
  using WatchSlot = Slot<struct WatchTag>;
  struct Watch {
    EdgeSlot edge{};
    FaceSlot face{};
    WatchSlot before{};  ///< previous watch of the same face
    WatchSlot after{};
  };
  void watch(EdgeSlot edge, FaceSlot face);
  Table<WatchSlot, Watch> watches_;
  std::vector<WatchSlot> free_watches_;
  std::unordered_map<EdgeSlot, std::vector<WatchSlot>> watches_of_edge_;
  std::unordered_map<FaceSlot, WatchSlot> first_watch_;
  ChangeRecorder<EdgeSlot> edge_recorder_;
  ChangeRecorder<SiteSlot> site_recorder_;
  ChangeSet<EdgeSlot> edge_changes_;
  ChangeSet<SiteSlot> site_changes_;
  // Work space.
  Search search_;
  SlotMarks<SiteSlot> judged_sites_;
  SlotMarks<EdgeSlot> judged_edges_;
};

}  // namespace mes
