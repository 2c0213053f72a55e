// SPDX-License-Identifier: GPL-3.0-or-later
// Which Delaunay edges give way first where labels cannot follow all of the crust.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/base/job_control.h"
#include "core/structures/crust/one_step_crust.h"

namespace mes {

/// A strict total order on the edges of the triangulation that depends on the positions of the sites alone. First,
/// as the most doubtful, come edges that *mend*: crust edges between two odd sites of degree three or more, and other
/// edges between two sites of degree one, by length; then all others by certainty |cot(alpha + beta)|; ties by the
/// lexicographic order of their ends.
///
/// What it guarantees: `is_surer` is exact. Keys are doubles with a proved bound, and where two are closer than that,
/// the exact predicates of core/kernel/edge_predicates.h decide.
///
/// Why mending edges come first: at a sharp corner the test accepts rungs between its two legs, and by certainty alone
/// the legs may give way instead, which cuts the corner off and makes a hole of it. Taking out the shortest rungs
/// leaves every site at degree two.
class CertaintyOrder {
 public:
  /// The place of an edge: its key, for most comparisons enough, and the edge.
  struct Rank {
    double key = 0.0;  ///< approximate, grows along the order; negative for edges that mend
    EdgeSlot edge;
  };

  CertaintyOrder(const Delaunay& delaunay, const OneStepCrust& crust) : delaunay_(delaunay), crust_(crust) {}

  Rank rank_of(EdgeSlot edge) const {
    if (!keys_.empty()) return {keys_[edge], edge};
    return {mends(edge) ? mending_key(edge) : ambiguity_key(crust_.corners(edge)), edge};
  }
  /// Finds the keys of all edges, on all cores, for when most of them will be asked for. They hold until `take_keys`
  /// or `forget_keys`, one of which has to come before the next edit.
  void find_keys();
  Table<EdgeSlot, double> take_keys() { return std::exchange(keys_, {}); }
  void forget_keys() { keys_ = {}; }
  /// The first comes later in the order than the second.
  bool is_surer(const Rank& a, const Rank& b) const {
    if (std::abs(a.key - b.key) > 2.0 * kAmbiguityKeyError) return a.key > b.key;
    return a.edge != b.edge && is_surer_by_exact_test(a, b);
  }
  /// The most doubtful first. May throw `Cancelled`. O(n) where keys are well apart, otherwise O(n log n).
  void sort(std::vector<Rank>& ranks, JobControl& job) const;
  /// Contradicting the edge brings both of its ends, which are odd, to degree two or nearer to it.
  bool mends(EdgeSlot edge) const;

 private:
  /// From -2 for the shortest to -1, exact up to `kAmbiguityKeyError` and to spare.
  double mending_key(EdgeSlot edge) const {
    const SiteSlot* end = delaunay_.edge(edge).v;
    const Vec2 along = delaunay_.site_position(end[1]) - delaunay_.site_position(end[0]);
    return -1.0 - 1.0 / (1.0 + dot(along, along));
  }
  void sort_run(std::span<Rank> run, JobControl& job) const;
  bool is_surer_by_exact_test(const Rank& a, const Rank& b) const;

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  Table<EdgeSlot, double> keys_;  ///< empty unless all are known
};

}  // namespace mes
