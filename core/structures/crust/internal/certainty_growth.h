// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the spanning tree in which an odd site finds its partner, grown from the site.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/crust/internal/certainty_order.h"

namespace mes {

/// Grows the minimum spanning tree of the triangulation in the order of certainty from one site (Prim). Each time the
/// next edge is surer than all so far, the grown part is a component that Kruskal's algorithm makes as well, and
/// nothing inside it depends on what lies outside. The growth *closes* at the first such component with an even number
/// of odd sites.
///
/// Cost: O(sites grown, times log). Threads: none; work space is kept from one growth to the next.
class CertaintyGrowth {
 public:
  /// Index among the sites of a growth.
  using Place = Slot<struct GrowthTag>;
  struct Step {
    CertaintyOrder::Rank rank;  ///< the edge through which the site was reached; unset for the seed
    SiteSlot site;
    Place from;  ///< the other end of that edge; it comes before this site
  };

  /// If the spanning tree (spanning_tree.h) is given, the growth looks at its edges only: it can take no others.
  CertaintyGrowth(const Delaunay& delaunay, const CertaintyOrder& order,
                  const Table<EdgeSlot, std::uint8_t>* tree = nullptr)
      : delaunay_(delaunay), order_(order), tree_(tree) {}

  /// Grows from `seed`, which is odd; `is_odd(site)` tells which sites are, and their number is even. False if the
  /// component would have more than `limit` sites; that outcome depends on the sites grown by then.
  template <class IsOdd>
  bool grow(SiteSlot seed, std::size_t limit, IsOdd is_odd, JobControl& job);

  /// The sites in the order in which they were reached.
  const Table<Place, Step>& steps() const { return steps_; }
  bool holds(SiteSlot site) const { return grown_.contains(site); }

 private:
  template <class IsOdd>
  bool closes_in_a_pair(IsOdd is_odd);
  template <class Visit>
  void for_each_edge_to_take(SiteSlot site, Visit visit) const;
  void push_edges_of(SiteSlot site, Place place);

  const Delaunay& delaunay_;
  const CertaintyOrder& order_;
  const Table<EdgeSlot, std::uint8_t>* tree_;
  SlotMarks<SiteSlot> grown_;
  std::vector<Step> heap_;
  Table<Place, Step> steps_;
};

template <class Visit>
void CertaintyGrowth::for_each_edge_to_take(SiteSlot site, Visit visit) const {
  delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
    if (tree_ == nullptr || (*tree_)[edge] != 0) visit(edge, other);
  });
}

inline void CertaintyGrowth::push_edges_of(SiteSlot site, Place place) {
  for_each_edge_to_take(site, [&](EdgeSlot edge, SiteSlot other) {
    if (grown_.contains(other)) return;
    heap_.push_back({order_.rank_of(edge), other, place});
    std::ranges::push_heap(heap_, [this](const Step& a, const Step& b) { return order_.is_surer(a.rank, b.rank); });
  });
}

// Most components are the seed and another odd site, with an edge between them that is more doubtful than all others
// there. Those others need not be put in order, which takes long where they are equally certain, as in a lattice. Where
// an edge mends, the keys of edges that do not are not needed.
template <class IsOdd>
bool CertaintyGrowth::closes_in_a_pair(IsOdd is_odd) {
  const SiteSlot seed = steps_[Place(0)].site;
  Step best{{}, seed, Place(0)};
  const auto look_at = [&](EdgeSlot edge, SiteSlot other) {
    const CertaintyOrder::Rank rank = order_.rank_of(edge);
    if (best.rank.edge == kNoSlot || order_.is_surer(best.rank, rank)) best = {rank, other, Place(0)};
  };
  for_each_edge_to_take(seed, [&](EdgeSlot edge, SiteSlot other) {
    if (order_.mends(edge)) look_at(edge, other);
  });
  const bool mends = best.rank.edge != kNoSlot;
  if (!mends) for_each_edge_to_take(seed, look_at);
  if (best.rank.edge == kNoSlot || !is_odd(best.site)) return false;
  bool is_most_doubtful = true;
  for_each_edge_to_take(best.site, [&](EdgeSlot edge, SiteSlot) {
    if (!is_most_doubtful || edge == best.rank.edge || (mends && !order_.mends(edge))) return;
    is_most_doubtful = order_.is_surer(order_.rank_of(edge), best.rank);
  });
  if (!is_most_doubtful) return false;
  grown_.insert(best.site);
  steps_.push_back(best);
  return true;
}

template <class IsOdd>
bool CertaintyGrowth::grow(SiteSlot seed, std::size_t limit, IsOdd is_odd, JobControl& job) {
  grown_.begin(delaunay_.site_rows());
  heap_.clear();
  steps_.clear();
  steps_.push_back({{}, seed, kNoSlot});
  grown_.insert(seed);
  if (limit >= 2 && closes_in_a_pair(is_odd)) return true;
  push_edges_of(seed, Place(0));
  bool is_even = false;
  CertaintyOrder::Rank surest;
  const auto by_certainty = [this](const Step& a, const Step& b) { return order_.is_surer(a.rank, b.rank); };
  for (;;) {
    while (!heap_.empty() && grown_.contains(heap_.front().site)) {
      std::ranges::pop_heap(heap_, by_certainty);
      heap_.pop_back();
    }
    if (heap_.empty()) return true;
    const Step next = heap_.front();
    const bool is_record = surest.edge == kNoSlot || order_.is_surer(next.rank, surest);
    if (is_even && is_record) return true;
    if (steps_.size() == limit) return false;
    std::ranges::pop_heap(heap_, by_certainty);
    heap_.pop_back();
    if (is_record) surest = next.rank;
    grown_.insert(next.site);
    if (is_odd(next.site)) is_even = !is_even;
    const Place place = steps_.next();
    steps_.push_back(next);
    if ((steps_.size() & 1023U) == 0) job.checkpoint();
    push_edges_of(next.site, place);
  }
}

}  // namespace mes
