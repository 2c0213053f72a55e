// SPDX-License-Identifier: GPL-3.0-or-later
// Where labels must contradict the crust if few samples are odd: pieces of the spanning tree around them.
#pragma once

#include <vector>

#include "core/structures/crust/internal/certainty_growth.h"
#include "core/structures/crust/internal/open_strokes.h"

namespace mes {

/// The join of the odd sites in the spanning tree of the triangulation: the edges of the tree that separate an odd
/// number of them from the rest. A site is odd if its crust degree is odd and it is not the end of an open stroke. If
/// labels contradict the crust at these edges, and at those of open strokes, they are consistent.
///
/// Why it is local: the growth from an odd site (`CertaintyGrowth`) closes in a component whose edges of the join
/// depend on nothing outside it. These *clusters* are nested or disjoint; the outermost ones are kept, and an edit
/// touches only the clusters that share a site with it.
///
/// Cost: O(k log k) for k sites in the clusters touched. Near a corner a cluster has a handful of sites. Where clusters
/// grow to a good part of the plane, as among random points, `CertaintyTree` is used instead. The number of odd sites
/// does not tell: in a lattice of shapes close together half of all sites are odd, in clusters of two.
class ConflictJoin {
 public:
  ConflictJoin(const Delaunay& delaunay, const OneStepCrust& crust, const CertaintyOrder& order,
               const OpenStrokes& strokes)
      : delaunay_(delaunay), crust_(crust), strokes_(strokes), growth_(delaunay, order) {}

  bool has_edge(EdgeSlot edge) const { return in_join_.has(edge) && in_join_[edge] != 0; }

  void clear();
  /// True if the clusters of a few odd sites are small. Takes no time to speak of. Open strokes need not be known.
  bool promises_to_be_small(JobControl& job);
  /// False if clusters would be large; the object must then be cleared or rebuilt.
  bool rebuild(JobControl& job);
  /// Like `rebuild`. `touched` is as for `OpenStrokes::update`, whose changes are included.
  bool update(const std::vector<SiteSlot>& touched, JobControl& job);
  /// Edges that the last update may have changed; some may be dead, and some unchanged.
  const std::vector<EdgeSlot>& changed_edges() const { return changed_edges_; }

 private:
  /// The sites of a cluster are linked from the one that it was grown from, which also names it.
  struct Member {
    SiteSlot cluster;  ///< kNoSlot: in no cluster
    SiteSlot next;     ///< kNoSlot at the last
    EdgeSlot join;     ///< an edge of the join, or kNoSlot
  };

  bool is_odd(SiteSlot site) const { return crust_.is_odd(site) && !strokes_.ends_at(site); }
  /// Changes no result, only when the tree takes over.
  std::size_t a_good_part() const { return 64 + delaunay_.site_count() / 4; }
  /// Makes the cluster around an odd site, unless it is in one already. False if it would be too large.
  bool grow(SiteSlot seed, JobControl& job);
  void dissolve(SiteSlot cluster);
  void toggle(EdgeSlot edge);
  void make_room();

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  const OpenStrokes& strokes_;
  CertaintyGrowth growth_;
  // Empty until there is an odd site.
  Table<SiteSlot, Member> member_;
  Table<EdgeSlot, std::uint8_t> in_join_;

  // Work space.
  std::size_t may_grow_ = 0;  ///< number of sites, in this call, over all growths
  Table<CertaintyGrowth::Place, std::uint8_t> parity_;
  std::vector<SiteSlot> seeds_;
  std::vector<EdgeSlot> changed_edges_;
};

}  // namespace mes
