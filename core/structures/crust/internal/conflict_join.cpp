// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/conflict_join.h"

#include <algorithm>
#include <numeric>

#include "core/base/disjoint_sets.h"

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
  // Which diagonals cocircular sites have is chance, and their triangles are one ball: never between different
  // labels.
  if (crust_.is_cocircular(edge)) return false;
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

  // Pairs come of the order of the edges, not of the order of growing.
  order_.resize(tree_.size() - 1);
  std::iota(order_.begin(), order_.end(), Slot{1});
  std::ranges::sort(order_, [this](Slot a, Slot b) { return is_surer(tree_[b], tree_[a]); });
  edges_.clear();
  for (const Slot i : order_) edges_.push_back({tree_[i].edge, i, tree_[i].from});
  std::vector<Slot> sites;
  sites.reserve(tree_.size());
  for (const Candidate& step : tree_) sites.push_back(step.site);
  add_cluster(std::move(sites));
}

void ConflictJoin::add_cluster(std::vector<Slot> sites) {
  const Slot id = next_cluster_++;
  odd_.clear();
  for (const Slot site : sites) {
    if (cluster_of_[site] != kNoSlot) dissolve(cluster_of_[site]);
    odd_.push_back(crust_.is_odd(site) ? 1 : 0);
  }
  for (const Slot site : sites) cluster_of_[site] = id;
  Cluster& cluster = clusters_[id];
  for (TreePair& way : tree_pairs_.find(edges_, odd_)) {
    Slot number = static_cast<Slot>(pairs_.size());
    if (free_pairs_.empty()) {
      pairs_.emplace_back();
    } else {
      number = free_pairs_.back();
      free_pairs_.pop_back();
      pairs_[number] = Pair{};
    }
    Pair& pair = pairs_[number];
    pair.way = std::move(way);
    pair.way.a = sites[pair.way.a];
    pair.way.b = sites[pair.way.b];
    cluster.pairs.push_back(number);
    unsettled_.push_back(number);
  }
  cluster.sites = std::move(sites);
}

void ConflictJoin::dissolve(Slot id) {
  const auto found = clusters_.find(id);
  if (found == clusters_.end()) return;
  for (const Slot site : found->second.sites)
    if (cluster_of_[site] == id) cluster_of_[site] = kNoSlot;
  for (const Slot number : found->second.pairs) {
    unsettle(number);
    pairs_[number].is_alive = false;
    free_pairs_.push_back(number);
  }
  clusters_.erase(found);
}

void ConflictJoin::contradict(Slot edge, bool is_near) {
  if (noted_marks_.insert(edge)) noted_.push_back({edge, state_[edge]});
  state_[edge] ^= is_near ? kConflict | kContradictedByNear : kConflict;
  if ((state_[edge] & kConflict) != 0) {
    ++conflict_count_;
  } else {
    --conflict_count_;
  }
}

void ConflictJoin::contradict_all(const Pair& pair) {
  for (const Slot edge : pair.contradicted()) contradict(edge, pair.is_near());
}

void ConflictJoin::walk_from(Pair& pair, Slot number) {
  const bool near = pair.is_near();
  Slot site = pair.way.a;
  Slot last = kNoSlot;
  for (;;) {
    int edges_here = 0;
    Slot next_edge = kNoSlot;
    Slot next_site = kNoSlot;
    delaunay_.for_each_edge_at(site, [&](Slot edge, Slot other, Slot) {
      if (crust_.is_crust(edge) == (!near && (state_[edge] & kContradictedByNear) != 0)) return;
      ++edges_here;
      if (edge == last) return;
      next_edge = edge;
      next_site = other;
    });
    const bool is_first = last == kNoSlot;
    if (!is_first && edges_here != 2) {
      pair.stop = site;
      walks_of(pair).stopped.emplace(site, number);
      if (site == pair.way.b && edges_here == 1) return;
      break;
    }
    pair.walk.push_back(site);
    auto& both = walks_of(pair).through[site];
    Slot& free = both[both[0] == kNoSlot ? 0 : 1];
    MES_ASSERT(free == kNoSlot);
    free = number;
    if (is_first && edges_here != 1) break;
    if (pair.walk.size() + 1 >= kStrokeSites * pair.way.component) break;
    pair.stroke.push_back(next_edge);
    site = next_site;
    last = next_edge;
  }
  pair.stroke.clear();
}

void ConflictJoin::settle(Slot number) {
  Pair& pair = pairs_[number];
  if (pair.way.path.size() > 2) walk_from(pair, number);
  contradict_all(pair);
  pair.is_settled = true;
}

void ConflictJoin::unsettle(Slot number) {
  Pair& pair = pairs_[number];
  if (!pair.is_settled) return;
  contradict_all(pair);
  for (const Slot site : pair.walk) {
    auto& both = walks_of(pair).through[site];
    both[both[0] == number ? 0 : 1] = kNoSlot;
  }
  if (pair.stop != kNoSlot) {
    auto& stopped = walks_of(pair).stopped;
    const auto [begin, end] = stopped.equal_range(pair.stop);
    stopped.erase(std::find_if(begin, end, [number](const auto& entry) { return entry.second == number; }));
  }
  pair.stop = kNoSlot;
  pair.walk.clear();
  pair.stroke.clear();
  pair.is_settled = false;
  unsettled_.push_back(number);
}

void ConflictJoin::unsettle_walks(Walks& walks, Slot site) {
  for (const Slot number : walks.through[site])
    if (number != kNoSlot) unsettle(number);
  for (auto stop = walks.stopped.find(site); stop != walks.stopped.end(); stop = walks.stopped.find(site))
    unsettle(stop->second);
}

void ConflictJoin::settle_all(JobControl& job) {
  const auto settle_those = [&](bool near) {
    for (std::size_t i = 0; i < unsettled_.size(); ++i) {
      if ((i & 1023U) == 0) job.checkpoint();
      const Pair& pair = pairs_[unsettled_[i]];
      if (pair.is_alive && !pair.is_settled && pair.is_near() == near) settle(unsettled_[i]);
    }
  };
  settle_those(true);
  // Far walks go along the curve as near pairs have repaired it. Where edges came or went they are unsettled already.
  for (std::size_t i = 0; i < noted_.size(); ++i) {
    const EdgeRow& row = delaunay_.edge(noted_[i].edge);
    if (row.is_alive() && ((state_[noted_[i].edge] ^ noted_[i].before) & kContradictedByNear) != 0)
      for (const Slot end : row.v) unsettle_walks(far_walks_, end);
  }
  settle_those(false);
  unsettled_.clear();
}

void ConflictJoin::clear() {
  clusters_.clear();
  pairs_.clear();
  free_pairs_.clear();
  unsettled_.clear();
  conflict_count_ = 0;
  state_.clear();
  cluster_of_.clear();
  near_walks_ = far_walks_ = Walks{};
}

void ConflictJoin::rebuild(JobControl& job) {
  clear();
  if (crust_.odd_count() == 0 || delaunay_.dimension() < 2) return;
  begin();
  for (Slot site = 0; site < delaunay_.site_rows(); ++site) {
    if (!delaunay_.is_site(site) || !crust_.is_odd(site) || cluster_of_[site] != kNoSlot) continue;
    grow(site, job);
    if (!is_too_much()) continue;
    join_all(job);
    break;
  }
  settle_all(job);
}

void ConflictJoin::make_room() {
  state_.resize(delaunay_.edge_rows(), 0);
  cluster_of_.resize(delaunay_.site_rows(), kNoSlot);
  for (Walks* walks : {&near_walks_, &far_walks_}) walks->through.resize(delaunay_.site_rows(), {kNoSlot, kNoSlot});
}

void ConflictJoin::begin() {
  make_room();
  grown_sites_ = 0;
  noted_.clear();
  noted_marks_.begin(delaunay_.edge_rows());
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
  DisjointSets joined(sites);
  std::vector<Slot> node(sites);  // of the component, by root
  std::vector<std::uint8_t> odd(sites);
  for (Slot site = 0; site < sites; ++site) {
    node[site] = site;
    odd[site] = delaunay_.is_site(site) && crust_.is_odd(site) ? 1 : 0;
  }
  std::vector<Merge> merges;
  std::vector<Slot> tree;  // edge of each merge
  merges.reserve(sites);
  tree.reserve(sites);
  for (const Candidate& edge : edges) {
    const Slot a = joined.root(edge.site);
    const Slot b = joined.root(edge.from);
    if (a == b) continue;
    merges.push_back({node[a], node[b], odd[a] != 0 && odd[b] != 0});
    tree.push_back(edge.edge);
    const auto odd_of_both = static_cast<std::uint8_t>(odd[a] ^ odd[b]);
    const Slot both = joined.join(a, b);
    odd[both] = odd_of_both;
    node[both] = sites + static_cast<Slot>(merges.size() - 1);
  }
  job.checkpoint();

  // The clusters: the outermost merges that close.
  for (Slot edge = 0; edge < state_.size(); ++edge) {
    if (state_[edge] != 0 && noted_marks_.insert(edge)) noted_.push_back({edge, state_[edge]});
  }
  clear();
  make_room();
  std::vector<std::uint8_t> covered(merges.size(), 0);
  std::vector<Slot> position(sites, kNoSlot);
  std::vector<Slot> stack;
  for (std::size_t m = merges.size(); m-- > 0;) {
    const auto pass_on = [&](Slot child) {
      if (child >= sites) covered[child - sites] = 1;
    };
    if (covered[m] == 0 && merges[m].closes) {
      std::vector<Slot> members;
      order_.clear();
      stack.assign(1, sites + static_cast<Slot>(m));
      while (!stack.empty()) {
        const Slot at = stack.back();
        stack.pop_back();
        if (at < sites) {
          position[at] = static_cast<Slot>(members.size());
          members.push_back(at);
          continue;
        }
        order_.push_back(at - sites);
        stack.push_back(merges[at - sites].left);
        stack.push_back(merges[at - sites].right);
      }
      std::ranges::sort(order_);
      edges_.clear();
      for (const Slot i : order_) {
        const EdgeRow& row = delaunay_.edge(tree[i]);
        edges_.push_back({tree[i], position[row.v[0]], position[row.v[1]]});
      }
      add_cluster(std::move(members));
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
  begin();
  seeds_.clear();
  const auto touch = [this](Slot site) {
    unsettle_walks(near_walks_, site);
    unsettle_walks(far_walks_, site);
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
  settle_all(job);
  for (const Noted& note : noted_)
    if (((state_[note.edge] ^ note.before) & kConflict) != 0 && delaunay_.edge(note.edge).is_alive())
      changed_edges.push_back(note.edge);
}

std::size_t ConflictJoin::stroke_count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(pairs_, [](const Pair& pair) { return pair.is_settled && !pair.stroke.empty(); }));
}

std::size_t ConflictJoin::largest_cluster() const {
  std::size_t largest = 0;
  for (const auto& [id, cluster] : clusters_) largest = std::max(largest, cluster.sites.size());
  return largest;
}

}  // namespace mes
