// SPDX-License-Identifier: GPL-3.0-or-later
// Which odd sites of a spanning tree belong together, and the way between them.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/table.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// A site of the tree: its position among the sites of its cluster.
using TreeSlot = Slot<struct TreeTag>;

/// Two odd sites that are joined with each other.
struct TreePair {
  TreeSlot a;
  TreeSlot b;
  std::size_t component = 0;   ///< sites of the component in which they found each other
  std::vector<EdgeSlot> path;  ///< the edges of the tree between them, in no order
};

/// Adds the edges of a tree one by one, in the order given, and pairs the odd sites: whenever an edge connects two
/// components with one site left over each, these two are a pair. The paths of all pairs, an edge that lies on two of
/// them not counted, are the edges of the tree with an odd number of odd sites on either side; unlike that set the
/// pairs depend on the order as well.
///
/// Cost: O(sites times the inverse Ackermann function, and the lengths of all paths).
class TreePairs {
 public:
  struct Edge {
    EdgeSlot edge;
    TreeSlot a, b;
  };
  /// `odd[site]` is 1 for odd sites, of which there is an even number, and 0 for others. The caller may move from the
  /// result, which is valid until the next call.
  std::vector<TreePair>& find(const std::vector<Edge>& edges, const Table<TreeSlot, std::uint8_t>& odd);

 private:
  void find_pairs(const std::vector<Edge>& edges, const Table<TreeSlot, std::uint8_t>& odd);
  void hang_up(const std::vector<Edge>& edges, std::size_t sites);

  using EdgeNumber = std::uint32_t;  ///< position among the edges
  static constexpr EdgeNumber kNoEdge = 0xffffffffU;

  std::vector<TreePair> pairs_;
  DisjointSets<TreeSlot> joined_;
  Table<TreeSlot, TreeSlot> left_over_;
  Table<TreeSlot, std::uint32_t> size_;
  std::vector<std::uint32_t> first_;   // by site, and one more: where its edges begin in `incident_`
  std::vector<std::uint32_t> filled_;  // by site: where its next edge goes
  std::vector<EdgeNumber> incident_;
  Table<TreeSlot, TreeSlot> up_;         // site above in the tree, hung up at site 0
  Table<TreeSlot, EdgeNumber> up_edge_;  // the edge to it
  Table<TreeSlot, std::uint32_t> depth_;
  std::vector<TreeSlot> queue_;
};

inline void TreePairs::find_pairs(const std::vector<Edge>& edges, const Table<TreeSlot, std::uint8_t>& odd) {
  joined_.reset(odd.size());
  size_.assign(odd.size(), 1);
  left_over_.resize(odd.size());
  for (const TreeSlot site : odd.rows()) left_over_[site] = odd[site] != 0 ? site : kNoSlot;
  for (const Edge& edge : edges) {
    const TreeSlot a = joined_.root(edge.a);
    const TreeSlot b = joined_.root(edge.b);
    const TreeSlot of_a = left_over_[a];
    const TreeSlot of_b = left_over_[b];
    const std::uint32_t size = size_[a] + size_[b];
    const TreeSlot both = joined_.join(a, b);
    size_[both] = size;
    left_over_[both] = of_a == kNoSlot ? of_b : (of_b == kNoSlot ? of_a : TreeSlot());
    if (of_a != kNoSlot && of_b != kNoSlot) pairs_.push_back({of_a, of_b, size, {}});
  }
}

inline void TreePairs::hang_up(const std::vector<Edge>& edges, std::size_t sites) {
  first_.assign(sites + 1, 0);
  for (const Edge& edge : edges) {
    ++first_[edge.a.index() + std::size_t{1}];
    ++first_[edge.b.index() + std::size_t{1}];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  incident_.resize(2 * edges.size());
  filled_.assign(first_.begin(), first_.end() - 1);
  for (EdgeNumber i = 0; i < edges.size(); ++i) {
    incident_[filled_[edges[i].a.index()]++] = i;
    incident_[filled_[edges[i].b.index()]++] = i;
  }
  up_.assign(sites, kNoSlot);
  up_edge_.assign(sites, kNoEdge);
  depth_.assign(sites, 0);
  queue_.assign(1, TreeSlot(0));
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const TreeSlot site = queue_[next];
    for (std::uint32_t k = first_[site.index()]; k < first_[site.index() + std::size_t{1}]; ++k) {
      const EdgeNumber i = incident_[k];
      if (i == up_edge_[site]) continue;
      const TreeSlot below = edges[i].a == site ? edges[i].b : edges[i].a;
      up_[below] = site;
      up_edge_[below] = i;
      depth_[below] = depth_[site] + 1;
      queue_.push_back(below);
    }
  }
}

inline std::vector<TreePair>& TreePairs::find(const std::vector<Edge>& edges,
                                              const Table<TreeSlot, std::uint8_t>& odd) {
  pairs_.clear();
  if (edges.size() == 1) {  // by far the most frequent: two odd sites side by side
    pairs_.push_back({TreeSlot(0), TreeSlot(1), 2, {edges[0].edge}});
    return pairs_;
  }
  find_pairs(edges, odd);
  hang_up(edges, odd.size());
  for (TreePair& pair : pairs_) {
    for (TreeSlot a = pair.a, b = pair.b; a != b;) {
      TreeSlot& lower = depth_[a] > depth_[b] ? a : b;
      pair.path.push_back(edges[up_edge_[lower]].edge);
      lower = up_[lower];
    }
  }
  return pairs_;
}

}  // namespace mes
