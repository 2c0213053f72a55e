// SPDX-License-Identifier: GPL-3.0-or-later
// Which Delaunay edges give way first where labels cannot follow the whole crust.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/crust/one_step_crust.h"

namespace mes {

/// A strict total order on the edges of the triangulation that depends on the positions of the sites alone. An edge
/// that is not crust is *long* if it is more than `kLong` times as long as every crust edge at its two ends. First, as
/// the most doubtful, come edges that *mend*, by length: crust edges between two odd sites of degree three or more, and
/// edges between two sites of degree one that are neither crust nor long. Then come all others by certainty
/// |cot(alpha + beta)|, the long ones and those between cocircular sites after the rest. Ties are decided by the
/// lexicographic order of the ends.
///
/// Guarantee: `is_surer` is exact. Keys are doubles with a proved bound. Where two keys are closer than that, or a
/// length is close to the limit, the exact predicates of core/kernel/edge_predicates.h decide.
///
/// Why mending edges come first: at a sharp corner the test accepts rungs between its two legs. By certainty alone, the
/// legs may give way instead, which cuts the corner off and makes a hole of it. Removing the shortest rungs leaves
/// every site at degree two.
///
/// Why long edges come last: where one of them gives way, the border of the labels runs along it, far from any curve.
/// Certainty does not see that: an edge across a bay, or of the hull between two capes, is doubtful if the angles
/// opposite happen to be near 90 degrees. The whole bay then changes sides.
///
/// Under edits: `update` follows them. Lengths are found when they are needed, and kept. Threads: several may rank
/// edges only after `find_keys`.
class CertaintyOrder {
 public:
  /// The rank of an edge: its key, which is enough for most comparisons, and the edge.
  struct Rank {
    double key = 0.0;  ///< approximate, grows along the order; negative for edges that mend
    EdgeSlot edge;
  };

  CertaintyOrder(const Delaunay& delaunay, const OneStepCrust& crust) : delaunay_(delaunay), crust_(crust) {}

  Rank rank_of(EdgeSlot edge) const {
    if (!keys_.empty()) return {keys_[edge], edge};
    return {mends(edge) ? mending_key(edge) : (comes_last(edge) ? kLast : 0.0) + ambiguity_key(crust_.corners(edge)),
            edge};
  }
  /// Forgets everything, as before a rebuild.
  void clear();
  /// Records an edit. `touched`: all sites at which an edge was added or removed, or changed its crust bit or an end.
  void update(const std::vector<SiteSlot>& touched);
  /// True if lengths have been needed since the last `clear`, so that `update` has something to do.
  bool keeps_lengths() const { return !longest_.empty(); }
  /// Older edges that the last update may have made long, or not long any more.
  const std::vector<EdgeSlot>& changed_edges() const { return changed_edges_; }
  /// True if the edge would now have another kind of key: mending, last, or other.
  bool has_other_kind(const Rank& rank) const;

  /// Finds the keys of all edges, on all cores, for when most of them will be needed. They hold until `take_keys` or
  /// `forget_keys`, one of which must be called before the next edit.
  void find_keys();
  Table<EdgeSlot, double> take_keys() { return std::exchange(keys_, {}); }
  void forget_keys() { keys_ = {}; }
  /// True if the first comes later in the order than the second.
  bool is_surer(const Rank& a, const Rank& b) const {
    if (std::abs(a.key - b.key) > 2.0 * kAmbiguityKeyError) return a.key > b.key;
    return a.edge != b.edge && is_surer_by_exact_test(a, b);
  }
  /// Sorts the most doubtful first. May throw `Cancelled`. O(n) where keys are well apart, otherwise O(n log n).
  void sort(std::vector<Rank>& ranks, JobControl& job) const;
  /// True if contradicting the edge brings both of its ends, which are odd, to degree two or nearer to it.
  bool mends(EdgeSlot edge) const;

 private:
  /// If smaller, coasts and noisy shapes are lost as a whole where samples lie far apart; from 12 on, strokes with
  /// jittery samples have an inside more often.
  static constexpr double kLong = 8.0;
  /// Keys of edges that come last begin here; those of the others end at 1. Adding it costs one rounding, which the
  /// bound of the keys allows for.
  static constexpr double kLast = 2.0;
  static constexpr double kUnknown = -1.0;

  bool is_long(EdgeSlot edge) const;
  bool comes_last(EdgeSlot edge) const {
    return !crust_.is_crust(edge) && (crust_.is_cocircular(edge) || is_long(edge));
  }
  double square(EdgeSlot edge) const;
  double longest_at(SiteSlot site) const;
  double find_longest_at(SiteSlot site) const;
  void find_all_longest();

  /// Ranges from -2 for the shortest to -1; exact to better than `kAmbiguityKeyError`.
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
  /// The square of the longest crust edge at a site, 0 if there is none, rounded; or `kUnknown`.
  mutable Table<SiteSlot, double> longest_;
  std::vector<EdgeSlot> changed_edges_;
};

}  // namespace mes
