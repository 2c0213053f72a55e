// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/internal/conflict_join.h"

#include <algorithm>

namespace mes {

namespace {

std::pair<Vec2, Vec2> sorted_ends(const Delaunay& delaunay, Slot edge) {
  const Vec2 a = delaunay.site_position(delaunay.edge(edge).v[0]);
  const Vec2 b = delaunay.site_position(delaunay.edge(edge).v[1]);
  return lexicographically_less(b, a) ? std::pair(b, a) : std::pair(a, b);
}

}  // namespace

// A strict total order on edges that depends on the sites' positions only.
bool ConflictJoin::is_surer(const Candidate& a, const Candidate& b) const {
  if (a.edge == b.edge) return false;
  if (a.mends != b.mends) return b.mends;
  int order = 0;
  if (a.mends) {
    const auto [a_low, a_high] = sorted_ends(delaunay_, a.edge);
    const auto [b_low, b_high] = sorted_ends(delaunay_, b.edge);
    order = compare_lengths(a_low, a_high, b_low, b_high);
  } else {
    if (std::abs(a.key - b.key) > 2.0 * kAmbiguityKeyError) return a.key > b.key;
    order = compare_ambiguity(crust_.corners(a.edge), crust_.corners(b.edge));
  }
  if (order != 0) return order > 0;
  const auto [a_low, a_high] = sorted_ends(delaunay_, a.edge);
  const auto [b_low, b_high] = sorted_ends(delaunay_, b.edge);
  if (a_low != b_low) return lexicographically_less(b_low, a_low);
  return lexicographically_less(b_high, a_high);
}

// Contradicting the edge brings both of its ends, which are odd, to degree two or nearer to it.
bool ConflictJoin::mends_both_ends(Slot edge) const {
  const Slot* end = delaunay_.edge(edge).v;
  if (!crust_.is_odd(end[0]) || !crust_.is_odd(end[1])) return false;
  if (crust_.is_crust(edge)) return crust_.degree(end[0]) >= 3 && crust_.degree(end[1]) >= 3;
  return crust_.degree(end[0]) == 1 && crust_.degree(end[1]) == 1;
}

void ConflictJoin::push_edges_of(Slot site, Slot position) {
  delaunay_.for_each_edge_at(site, [&](Slot edge, Slot other, Slot) {
    if (grown_.contains(other)) return;
    heap_.push_back(candidate(edge, other, position));
    std::ranges::push_heap(heap_, [this](const Candidate& a, const Candidate& b) { return is_surer(a, b); });
  });
}

void ConflictJoin::grow(Slot seed, JobControl& job) {
  grown_.begin(delaunay_.site_rows());
  heap_.clear();
  tree_.clear();
  tree_.push_back({0.0, kNoSlot, seed, kNoSlot, false});
  grown_.insert(seed);
  push_edges_of(seed, 0);
  std::size_t odd = 1;
  Candidate surest = tree_.front();
  const auto by_certainty = [this](const Candidate& a, const Candidate& b) { return is_surer(a, b); };
  for (;;) {
    while (!heap_.empty() && grown_.contains(heap_.front().site)) {
      std::ranges::pop_heap(heap_, by_certainty);
      heap_.pop_back();
    }
    if (heap_.empty()) break;
    const Candidate next = heap_.front();
    if ((odd & 1U) == 0 && is_surer(next, surest)) break;
    std::ranges::pop_heap(heap_, by_certainty);
    heap_.pop_back();
    if (surest.edge == kNoSlot || is_surer(next, surest)) surest = next;
    grown_.insert(next.site);
    odd += crust_.is_odd(next.site) ? 1U : 0U;
    tree_.push_back(next);
    if ((tree_.size() & 1023U) == 0) job.checkpoint();
    push_edges_of(next.site, static_cast<Slot>(tree_.size() - 1));
  }
  MES_ASSERT((odd & 1U) == 0);
  grown_sites_ += tree_.size();

  // In a tree the set of edges with an odd number of odd sites behind them is found from the leaves.
  Cluster cluster;
  cluster.sites.reserve(tree_.size());
  parity_.assign(tree_.size(), 0);
  for (std::size_t i = tree_.size(); i-- > 1;) {
    const bool is_odd = (parity_[i] != 0) != crust_.is_odd(tree_[i].site);
    if (!is_odd) continue;
    parity_[tree_[i].from] ^= 1U;
    cluster.conflicts.push_back(tree_[i].edge);
  }
  const Slot id = next_cluster_++;
  for (const Candidate& step : tree_) {
    const Slot inner = cluster_of_[step.site];
    if (inner != kNoSlot) dissolve(inner);
    cluster.sites.push_back(step.site);
  }
  for (const Slot site : cluster.sites) cluster_of_[site] = id;
  for (const Slot edge : cluster.conflicts) {
    conflict_[edge] = 1;
    changed_.push_back(edge);
  }
  conflict_count_ += cluster.conflicts.size();
  clusters_.emplace(id, std::move(cluster));
}

void ConflictJoin::dissolve(Slot id) {
  const auto found = clusters_.find(id);
  if (found == clusters_.end()) return;
  for (const Slot site : found->second.sites)
    if (cluster_of_[site] == id) cluster_of_[site] = kNoSlot;
  for (const Slot edge : found->second.conflicts) {
    conflict_[edge] = 0;
    changed_.push_back(edge);
  }
  conflict_count_ -= found->second.conflicts.size();
  clusters_.erase(found);
}

void ConflictJoin::rebuild(JobControl& job) {
  clusters_.clear();
  conflict_count_ = 0;
  changed_.clear();
  conflict_.clear();
  cluster_of_.clear();
  grown_sites_ = 0;
  if (crust_.odd_count() == 0 || delaunay_.dimension() < 2) return;
  conflict_.assign(delaunay_.edge_rows(), 0);
  cluster_of_.assign(delaunay_.site_rows(), kNoSlot);
  for (Slot site = 0; site < delaunay_.site_rows(); ++site) {
    if (!delaunay_.is_site(site) || !crust_.is_odd(site) || cluster_of_[site] != kNoSlot) continue;
    grow(site, job);
    if (is_too_much()) return join_all(job);
  }
}

void ConflictJoin::join_all(JobControl& job) {
  // Kruskal, remembering the order of merging as a binary forest: leaves are sites, inner nodes merges.
  std::vector<Candidate> edges;
  edges.reserve(delaunay_.edge_rows());
  for (Slot edge = 0; edge < delaunay_.edge_rows(); ++edge) {
    if ((edge & 0xffffU) == 0) job.checkpoint();
    const EdgeRow& row = delaunay_.edge(edge);
    if (row.is_alive()) edges.push_back(candidate(edge, row.v[1], row.v[0]));
  }
  std::ranges::sort(edges, [this](const Candidate& a, const Candidate& b) { return is_surer(b, a); });
  job.checkpoint();

  struct Merge {
    Slot left, right;  ///< below `sites`: a site, otherwise sites + number of an earlier merge
    bool closes;       ///< two odd components made an even one
  };
  const auto sites = static_cast<Slot>(delaunay_.site_rows());
  std::vector<Slot> parent(sites);
  std::vector<Slot> node(sites);  // of the component, by root
  std::vector<std::uint8_t> odd(sites);
  for (Slot site = 0; site < sites; ++site) {
    parent[site] = node[site] = site;
    odd[site] = delaunay_.is_site(site) && crust_.is_odd(site) ? 1 : 0;
  }
  const auto root = [&parent](Slot site) {
    while (parent[site] != site) site = parent[site] = parent[parent[site]];
    return site;
  };
  std::vector<Merge> merges;
  std::vector<Slot> tree;  // edge of each merge
  merges.reserve(sites);
  tree.reserve(sites);
  std::vector<Slot> degree(sites + std::size_t{1}, 0);
  for (const Candidate& edge : edges) {
    Slot a = root(edge.site);
    Slot b = root(edge.from);
    if (a == b) continue;
    merges.push_back({node[a], node[b], odd[a] != 0 && odd[b] != 0});
    tree.push_back(edge.edge);
    ++degree[edge.site];
    ++degree[edge.from];
    parent[b] = a;
    odd[a] ^= odd[b];
    node[a] = sites + static_cast<Slot>(merges.size() - 1);
  }
  job.checkpoint();

  // The conflicts: edges of the tree with an odd number of odd sites behind them, found by plucking leaves.
  std::vector<std::uint8_t> is_conflict(delaunay_.edge_rows(), 0);
  std::vector<Slot> xor_of_edges(sites, 0);
  for (Slot i = 0; i < tree.size(); ++i)
    for (const Slot end : delaunay_.edge(tree[i]).v) xor_of_edges[end] ^= i;
  for (Slot site = 0; site < sites; ++site) {
    odd[site] = delaunay_.is_site(site) && crust_.is_odd(site) ? 1 : 0;
  }
  conflict_count_ = 0;
  for (Slot start = 0; start < sites; ++start) {
    Slot leaf = start;
    while (degree[leaf] == 1) {
      const Slot i = xor_of_edges[leaf];
      const EdgeRow& row = delaunay_.edge(tree[i]);
      const Slot next = row.v[0] == leaf ? row.v[1] : row.v[0];
      if (odd[leaf] != 0) {
        is_conflict[tree[i]] = 1;
        ++conflict_count_;
        odd[next] ^= 1U;
      }
      degree[leaf] = 0;
      --degree[next];
      xor_of_edges[next] ^= i;
      leaf = next;
    }
  }
  for (Slot edge = 0; edge < is_conflict.size(); ++edge)
    if (is_conflict[edge] != conflict_[edge]) changed_.push_back(edge);
  conflict_.swap(is_conflict);

  // The clusters: the outermost merges that close.
  clusters_.clear();
  cluster_of_.assign(sites, kNoSlot);
  std::vector<std::uint8_t> covered(merges.size(), 0);
  std::vector<Slot> stack;
  for (std::size_t m = merges.size(); m-- > 0;) {
    const auto pass_on = [&](Slot child) {
      if (child >= sites) covered[child - sites] = 1;
    };
    if (covered[m] == 0 && merges[m].closes) {
      const Slot id = next_cluster_++;
      Cluster& cluster = clusters_[id];
      stack.assign(1, sites + static_cast<Slot>(m));
      while (!stack.empty()) {
        const Slot at = stack.back();
        stack.pop_back();
        if (at < sites) {
          cluster.sites.push_back(at);
          cluster_of_[at] = id;
          continue;
        }
        if (conflict_[tree[at - sites]] != 0) cluster.conflicts.push_back(tree[at - sites]);
        stack.push_back(merges[at - sites].left);
        stack.push_back(merges[at - sites].right);
      }
      covered[m] = 1;
    }
    if (covered[m] == 0) continue;
    pass_on(merges[m].left);
    pass_on(merges[m].right);
  }
}

void ConflictJoin::update(JobControl& job, std::vector<Slot>& changed_edges) {
  changed_edges.clear();
  if (crust_.odd_count() == 0 && clusters_.empty()) return;
  conflict_.resize(delaunay_.edge_rows(), 0);
  cluster_of_.resize(delaunay_.site_rows(), kNoSlot);
  changed_.clear();
  seeds_.clear();
  grown_sites_ = 0;
  const auto touch = [this](Slot site) {
    const Slot id = cluster_of_[site];
    if (id == kNoSlot) return;
    const Cluster& cluster = clusters_.at(id);
    seeds_.insert(seeds_.end(), cluster.sites.begin(), cluster.sites.end());
    dissolve(id);
  };
  const ChangeSet& sites = crust_.site_changes();
  for (const Slot site : sites.removed) touch(site);
  for (const Slot site : sites.touched) touch(site);
  for (const Slot edge : delaunay_.edge_changes().touched)
    for (const Slot site : delaunay_.edge(edge).v) touch(site);
  // What an edge mends depends on the degrees at both of its ends.
  for (const Slot site : crust_.degree_changes())
    delaunay_.for_each_edge_at(site, [&](Slot, Slot other, Slot) { touch(other); });
  seeds_.insert(seeds_.end(), crust_.degree_changes().begin(), crust_.degree_changes().end());
  for (std::size_t i = 0; i < seeds_.size(); ++i) {
    const Slot site = seeds_[i];
    if (!delaunay_.is_site(site) || !crust_.is_odd(site) || cluster_of_[site] != kNoSlot) continue;
    grow(site, job);
    if (!is_too_much()) continue;
    join_all(job);
    break;
  }
  for (const Slot edge : changed_)
    if (delaunay_.edge(edge).is_alive()) changed_edges.push_back(edge);
}

std::size_t ConflictJoin::largest_cluster() const {
  std::size_t largest = 0;
  for (const auto& [id, cluster] : clusters_) largest = std::max(largest, cluster.sites.size());
  return largest;
}

}  // namespace mes
