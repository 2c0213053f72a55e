// SPDX-License-Identifier: GPL-3.0-or-later
// Where labels must contradict the crust: the canonical repair of samples of odd crust degree.
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/job_control.h"
#include "core/structures/crust/internal/tree_pairs.h"
#include "core/structures/crust/one_step_crust.h"

namespace mes {

/// Labels that change across crust edges and nowhere else exist only if every site has even crust degree. Otherwise
/// some edges must be *conflicts*: their two sides are labelled against their crust bit. Which, depends on the
/// samples alone:
///
///  1. Order all edges: first those that *mend*, by length: crust edges between two odd sites of degree three or
///     more, and other edges between two sites of degree one; then all others by certainty |cot(alpha + beta)|; ties
///     by the lexicographic order of their ends. Take the minimum spanning tree of the triangulation in this order.
///  2. Adding the edges of the tree one by one pairs the odd sites (`TreePairs`). A pair is *near* if the component
///     in which it finds together has at most `kNear` sites, otherwise *far*.
///  3. A pair is an *open stroke* if the way between its sites in the tree has more than two edges, each has one
///     curve edge, and the walk along the curve from one, through sites of two curve edges, leads to the other and
///     meets fewer than `kStrokeSites` times as many sites as the component has. The curve is the crust for near
///     pairs, and for far pairs the crust as the near ones have repaired it.
///  4. Every pair contradicts edges: an open stroke all its own, any other pair its way in the tree. The conflicts
///     are the edges contradicted an odd number of times.
///
/// Were it not for strokes, the conflicts would be the edges of the tree that separate an odd number of odd sites
/// from the rest. The dual of the complement of that tree is the maximum-certainty spanning tree of the faces, so
/// this is the same as handing labels on from the outside along the most certain edges first. In other words: among
/// all repairs, doubtful edges give way before sure ones. Mending edges come first because of corners: at a sharp
/// corner the test accepts rungs between its two legs, and by certainty alone the legs may give way instead, which
/// cuts the corner off and makes a hole of it. Taking out the shortest rungs leaves every site at degree two.
///
/// Strokes are taken out because nothing closes them: between the two ends of a wave or a spiral the tree runs along
/// and across the stroke itself, and inside spills over it wherever it does. What encloses nothing has no inside. But
/// a component that is small against the stroke tells of a gap in a closed curve, with dirt in it perhaps, and the
/// ends of an arc have an edge in common: both are closed.
///
/// Why it is local. Grow the tree from an odd site, most doubtful edge first (Prim). Each time the next edge is surer
/// than all so far, what has grown is a component of Kruskal's algorithm at that level. As soon as such a component
/// holds an even number of odd sites, its pairs depend on nothing outside it. These *clusters* are nested or
/// disjoint; the outermost ones are kept, and an edit touches only the clusters that share a site with it. A walk is
/// taken again when a site that it met is touched.
///
/// Cost: O(sites in the clusters touched, times log, and the walks touched). Near a corner a cluster has a handful of
/// sites; two odd sites far apart, such as the ends of an open stroke, make one cluster of all that is more doubtful
/// than the way between them, and an edit of a stroke walks along all of it. Where clusters grow to a good part of
/// the plane, as among random points, growing them one by one would visit the same sites again and again; then the
/// whole tree is made at once by Kruskal's algorithm, O(n log n).
class ConflictJoin {
 public:
  explicit ConflictJoin(const Delaunay& delaunay, const OneStepCrust& crust) : delaunay_(delaunay), crust_(crust) {}

  bool is_conflict(EdgeSlot edge) const { return state_.has(edge) && (state_[edge] & kConflict) != 0; }
  std::size_t conflict_count() const { return conflict_count_; }
  std::size_t stroke_count() const;
  std::size_t cluster_count() const { return clusters_.size(); }
  std::size_t largest_cluster() const;

  void rebuild(JobControl& job);
  /// Follows the crust's and the triangulation's change sets. `changed_edges` receives live edges whose conflict bit
  /// changed.
  void update(JobControl& job, std::vector<EdgeSlot>& changed_edges);

 private:
  /// 8 to 32 do about as well on outlines: less, and the defects of a jittery stroke keep it from being one; more,
  /// and a stroke that has just been begun is not seen as one.
  static constexpr std::size_t kNear = 16;
  /// 8 to 32 do about as well: less, and spirals pass for closed curves with a gap; more, and such curves for
  /// strokes.
  static constexpr std::size_t kStrokeSites = 16;
  static constexpr std::uint8_t kConflict = 1;
  static constexpr std::uint8_t kContradictedByNear = 2;

  using PairSlot = Slot<struct PairTag>;
  using ClusterId = Id<struct ClusterTag>;
  struct Pair {
    SiteSlot a, b;
    std::size_t component = 0;     ///< sites of the component in which they found each other
    std::vector<EdgeSlot> path;    ///< the way between them in the tree, in no order
    std::vector<SiteSlot> walk;    ///< sites met along the curve from `a`, without that where it stopped
    SiteSlot stop;                 ///< site with other than two edges that ended the walk
    std::vector<EdgeSlot> stroke;  ///< edges of the open stroke that the pair is; empty when it is none
    bool is_settled = false;
    bool is_alive = true;
    bool is_near() const { return component <= kNear; }
    const std::vector<EdgeSlot>& contradicted() const { return stroke.empty() ? path : stroke; }
  };
  struct Cluster {
    std::vector<SiteSlot> sites;
    std::vector<PairSlot> pairs;
  };
  /// Which pairs' walks a site has part in.
  struct Walks {
    /// A stretch of curve is walked from its two ends at most.
    Table<SiteSlot, std::array<PairSlot, 2>> through;
    std::unordered_multimap<SiteSlot, PairSlot> stopped;
  };
  /// An edge and what decides its place in the order.
  struct Rank {
    double key;
    EdgeSlot edge;
    bool mends;
  };
  struct Candidate : Rank {
    SiteSlot site;  ///< the end that is reached through the edge
    TreeSlot from;  ///< the other end, in the growing cluster
  };

  bool mends_both_ends(EdgeSlot edge) const;
  Rank rank_of(EdgeSlot edge) const { return {ambiguity_key(crust_.corners(edge)), edge, mends_both_ends(edge)}; }
  bool is_surer(const Rank& a, const Rank& b) const;
  void push_edges_of(SiteSlot site, TreeSlot position);
  void grow(SiteSlot seed, JobControl& job);
  /// All clusters at once; replaces what there is.
  void join_all(JobControl& job);
  bool is_too_much() const { return grown_sites_ > 64 + delaunay_.site_count() / 4; }
  /// Makes a cluster of `sites` and of the tree `edges_` between them.
  void add_cluster(std::vector<SiteSlot> sites);
  void dissolve(ClusterId id);

  void contradict(EdgeSlot edge, bool is_near);
  void contradict_all(const Pair& pair);
  void walk_from(Pair& pair, PairSlot number);
  void settle(PairSlot number);
  void unsettle(PairSlot number);
  /// Unsettles the pairs whose walks met the site or stopped at it.
  void unsettle_walks(Walks& walks, SiteSlot site);
  Walks& walks_of(const Pair& pair) { return pair.is_near() ? near_walks_ : far_walks_; }
  void settle_all(JobControl& job);
  void clear();
  void make_room();
  void begin();

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  Table<EdgeSlot, std::uint8_t> state_;
  std::size_t conflict_count_ = 0;
  std::unordered_map<ClusterId, Cluster> clusters_;
  ClusterId next_cluster_{0};
  Table<SiteSlot, ClusterId> cluster_of_;  ///< sized when the first odd site appears
  Table<PairSlot, Pair> pairs_;
  std::vector<PairSlot> free_pairs_;
  std::vector<PairSlot> unsettled_;
  Walks near_walks_;
  Walks far_walks_;

  // Work space.
  std::size_t grown_sites_ = 0;  ///< in this call, over all growths
  SlotMarks<SiteSlot> grown_;
  std::vector<Candidate> heap_;
  Table<TreeSlot, Candidate> tree_;
  std::vector<TreeSlot> order_;
  TreePairs tree_pairs_;
  std::vector<TreePairs::Edge> edges_;
  Table<TreeSlot, std::uint8_t> odd_;
  std::vector<SiteSlot> seeds_;
  struct Noted {
    EdgeSlot edge;
    std::uint8_t before;
  };
  SlotMarks<EdgeSlot> noted_marks_;
  std::vector<Noted> noted_;
};

}  // namespace mes
