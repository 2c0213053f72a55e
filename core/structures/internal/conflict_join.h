// SPDX-License-Identifier: GPL-3.0-or-later
// Where labels must contradict the crust: the canonical repair of samples of odd crust degree.
#pragma once

#include <unordered_map>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/job_control.h"
#include "core/structures/one_step_crust.h"

namespace mes {

/// Labels that change across crust edges and nowhere else exist only if every site has even crust degree. Otherwise
/// some edges must be *conflicts*: their two sides are labelled against their crust bit. The rule, which depends on
/// the samples alone, is
///
///   order all edges: first those that *mend*, by length: crust edges between two odd sites of degree three or more,
///   and other edges between two sites of degree one; then all others by certainty |cot(alpha + beta)|; ties by the
///   lexicographic order of their ends. Take the minimum spanning tree of the triangulation in this order; the
///   conflicts are the edges of this tree that separate an odd number of odd sites from the rest.
///
/// The dual of the complement of that tree is the maximum-certainty spanning tree of the faces, so this is the same
/// as handing labels on from the outside along the most certain edges first. In other words: among all repairs,
/// doubtful edges give way before sure ones. Mending edges come first because of corners: at a sharp corner the test
/// accepts rungs between its two legs, and by certainty alone the legs may give way instead, which cuts the corner
/// off and makes a hole of it. Taking out the shortest rungs leaves every site at degree two.
///
/// Why it is local. Grow the tree from an odd site, most doubtful edge first (Prim). Each time the next edge is surer
/// than all so far, what has grown is a component of Kruskal's algorithm at that level. As soon as such a component
/// holds an even number of odd sites, its conflicts lie inside it and depend on nothing outside it. These *clusters*
/// are nested or disjoint; the outermost ones are kept, and an edit touches only the clusters that share a site with
/// it.
///
/// Cost: O(sites in the clusters touched, times log). Near a corner a cluster has a handful of sites; two odd sites
/// far apart, such as the ends of an open stroke, make one cluster of all that is more doubtful than the way between
/// them. Where clusters grow to a good part of the plane, as among random points, growing them one by one would visit
/// the same sites again and again; then the whole tree is made at once by Kruskal's algorithm, O(n log n).
class ConflictJoin {
 public:
  explicit ConflictJoin(const Delaunay& delaunay, const OneStepCrust& crust) : delaunay_(delaunay), crust_(crust) {}

  bool is_conflict(Slot edge) const { return edge < conflict_.size() && conflict_[edge] != 0; }
  std::size_t conflict_count() const { return conflict_count_; }
  std::size_t cluster_count() const { return clusters_.size(); }
  std::size_t largest_cluster() const;

  void rebuild(JobControl& job);
  /// Follows the crust's and the triangulation's change sets. `changed_edges` receives live edges whose conflict bit
  /// may have changed.
  void update(JobControl& job, std::vector<Slot>& changed_edges);

 private:
  struct Cluster {
    std::vector<Slot> sites;
    std::vector<Slot> conflicts;
  };
  struct Candidate {
    double key;
    Slot edge;
    Slot site;  ///< the end that is reached through the edge
    Slot from;  ///< position of the other end in the growing cluster
    bool mends;
  };

  bool mends_both_ends(Slot edge) const;
  Candidate candidate(Slot edge, Slot site, Slot from) const {
    return {ambiguity_key(crust_.corners(edge)), edge, site, from, mends_both_ends(edge)};
  }
  /// Everything at once; replaces clusters and conflicts.
  void join_all(JobControl& job);
  bool is_too_much() const { return grown_sites_ > 64 + delaunay_.site_count() / 4; }
  bool is_surer(const Candidate& a, const Candidate& b) const;
  void grow(Slot seed, JobControl& job);
  void dissolve(Slot cluster);
  void push_edges_of(Slot site, Slot position);

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  std::vector<std::uint8_t> conflict_;
  std::size_t conflict_count_ = 0;
  std::unordered_map<Slot, Cluster> clusters_;
  Slot next_cluster_ = 0;
  std::vector<Slot> cluster_of_;  ///< by site; sized when the first odd site appears

  // Work space.
  std::size_t grown_sites_ = 0;  ///< in this call, over all growths
  SlotMarks grown_;
  std::vector<Candidate> heap_;
  std::vector<Candidate> tree_;
  std::vector<std::uint8_t> parity_;
  std::vector<Slot> seeds_;
  std::vector<Slot> changed_;
};

}  // namespace mes
