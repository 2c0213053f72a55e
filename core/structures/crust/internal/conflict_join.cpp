// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/conflict_join.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"

namespace mes {

namespace {

std::pair<Vec2, Vec2> sorted_ends(const Delaunay& delaunay, EdgeSlot edge) {
  const Vec2 a = delaunay.site_position(delaunay.edge(edge).v[0]);
  const Vec2 b = delaunay.site_position(delaunay.edge(edge).v[1]);
  return lexicographically_less(b, a) ? std::pair(b, a) : std::pair(a, b);
}

}  // namespace

// A strict total order on edges that depends on the sites' positions only.
bool ConflictJoin::is_surer(const Rank& a, const Rank& b) const {
  if (a.mends != b.mends) return b.mends;
  if (!a.mends && std::abs(a.key - b.key) > 2.0 * kAmbiguityKeyError) return a.key > b.key;
  if (a.edge == b.edge) return false;
  int order = 0;
  if (a.mends) {
    const SiteSlot* of_a = delaunay_.edge(a.edge).v;
    const SiteSlot* of_b = delaunay_.edge(b.edge).v;
    order = compare_lengths(delaunay_.site_position(of_a[0]), delaunay_.site_position(of_a[1]),
                            delaunay_.site_position(of_b[0]), delaunay_.site_position(of_b[1]));
  } else {
    order = compare_ambiguity(crust_.corners(a.edge), crust_.corners(b.edge));
  }
  if (order != 0) return order > 0;
  const auto [a_low, a_high] = sorted_ends(delaunay_, a.edge);
  const auto [b_low, b_high] = sorted_ends(delaunay_, b.edge);
  if (a_low != b_low) return lexicographically_less(b_low, a_low);
  return lexicographically_less(b_high, a_high);
}

// Contradicting the edge brings both of its ends, which are odd, to degree two or nearer to it.
bool ConflictJoin::mends_both_ends(EdgeSlot edge) const {
  const SiteSlot* end = delaunay_.edge(edge).v;
  if (!crust_.is_odd(end[0]) || !crust_.is_odd(end[1])) return false;
  // Which diagonals cocircular sites have is chance, and their triangles are one ball: never between different
  // labels.
  if (crust_.is_cocircular(edge)) return false;
  if (crust_.is_crust(edge)) return crust_.degree(end[0]) >= 3 && crust_.degree(end[1]) >= 3;
  return crust_.degree(end[0]) == 1 && crust_.degree(end[1]) == 1;
}

void ConflictJoin::push_edges_of(SiteSlot site, TreeSlot position) {
  delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
    if (grown_.contains(other)) return;
    heap_.push_back({rank_of(edge), other, position});
    std::ranges::push_heap(heap_, [this](const Candidate& a, const Candidate& b) { return is_surer(a, b); });
  });
}

void ConflictJoin::grow(SiteSlot seed, JobControl& job) {
  grown_.begin(delaunay_.site_rows());
  heap_.clear();
  tree_.clear();
  tree_.push_back({{0.0, EdgeSlot(), false}, seed, TreeSlot()});
  grown_.insert(seed);
  push_edges_of(seed, TreeSlot(0));
  std::size_t odd = 1;
  Rank surest = tree_.back();
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
    const TreeSlot position = tree_.next();
    tree_.push_back(next);
    if ((tree_.size() & 1023U) == 0) job.checkpoint();
    push_edges_of(next.site, position);
  }
  MES_ASSERT((odd & 1U) == 0);
  grown_sites_ += tree_.size();

  // Pairs come of the order of the edges, not of the order of growing.
  order_.clear();
  for (const TreeSlot i : slots_between<TreeSlot>(1, tree_.size())) order_.push_back(i);
  std::ranges::sort(order_, [this](TreeSlot a, TreeSlot b) { return is_surer(tree_[b], tree_[a]); });
  edges_.clear();
  for (const TreeSlot i : order_) edges_.push_back({tree_[i].edge, i, tree_[i].from});
  std::vector<SiteSlot> sites;
  sites.reserve(tree_.size());
  for (const Candidate& step : tree_) sites.push_back(step.site);
  add_cluster(std::move(sites));
}

void ConflictJoin::add_cluster(std::vector<SiteSlot> sites) {
  const ClusterId id = next_cluster_;
  ++next_cluster_.value;
  odd_.clear();
  for (const SiteSlot site : sites) {
    if (cluster_of_[site].is_valid()) dissolve(cluster_of_[site]);
    odd_.push_back(crust_.is_odd(site) ? 1 : 0);
  }
  for (const SiteSlot site : sites) cluster_of_[site] = id;
  Cluster& cluster = clusters_[id];
  for (TreePair& way : tree_pairs_.find(edges_, odd_)) {
    PairSlot number = pairs_.next();
    if (free_pairs_.empty()) {
      pairs_.emplace_back();
    } else {
      number = free_pairs_.back();
      free_pairs_.pop_back();
      pairs_[number] = Pair{};
    }
    Pair& pair = pairs_[number];
    pair.a = sites[way.a.index()];
    pair.b = sites[way.b.index()];
    pair.component = way.component;
    pair.path = std::move(way.path);
    cluster.pairs.push_back(number);
    unsettled_.push_back(number);
  }
  cluster.sites = std::move(sites);
}

void ConflictJoin::dissolve(ClusterId id) {
  const auto found = clusters_.find(id);
  if (found == clusters_.end()) return;
  for (const SiteSlot site : found->second.sites)
    if (cluster_of_[site] == id) cluster_of_[site] = ClusterId();
  for (const PairSlot number : found->second.pairs) {
    unsettle(number);
    pairs_[number].is_alive = false;
    free_pairs_.push_back(number);
  }
  clusters_.erase(found);
}

void ConflictJoin::contradict(EdgeSlot edge, bool is_near) {
  if (noted_marks_.insert(edge)) noted_.push_back({edge, state_[edge]});
  state_[edge] ^= is_near ? kConflict | kContradictedByNear : kConflict;
  if ((state_[edge] & kConflict) != 0) {
    ++conflict_count_;
  } else {
    --conflict_count_;
  }
}

void ConflictJoin::contradict_all(const Pair& pair) {
  for (const EdgeSlot edge : pair.contradicted()) contradict(edge, pair.is_near());
}

void ConflictJoin::walk_from(Pair& pair, PairSlot number) {
  const bool near = pair.is_near();
  SiteSlot site = pair.a;
  EdgeSlot last = kNoSlot;
  for (;;) {
    int edges_here = 0;
    EdgeSlot next_edge = kNoSlot;
    SiteSlot next_site = kNoSlot;
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
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
      if (site == pair.b && edges_here == 1) return;
      break;
    }
    pair.walk.push_back(site);
    auto& both = walks_of(pair).through[site];
    PairSlot& free = both[both[0] == kNoSlot ? 0 : 1];
    MES_ASSERT(free == kNoSlot);
    free = number;
    if (is_first && edges_here != 1) break;
    if (pair.walk.size() + 1 >= kStrokeSites * pair.component) break;
    pair.stroke.push_back(next_edge);
    site = next_site;
    last = next_edge;
  }
  pair.stroke.clear();
}

void ConflictJoin::settle(PairSlot number) {
  Pair& pair = pairs_[number];
  if (pair.path.size() > 2) walk_from(pair, number);
  contradict_all(pair);
  pair.is_settled = true;
}

void ConflictJoin::unsettle(PairSlot number) {
  Pair& pair = pairs_[number];
  if (!pair.is_settled) return;
  contradict_all(pair);
  for (const SiteSlot site : pair.walk) {
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

void ConflictJoin::unsettle_walks(Walks& walks, SiteSlot site) {
  for (const PairSlot number : walks.through[site])
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
      for (const SiteSlot end : row.v) unsettle_walks(far_walks_, end);
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
  // Among random samples, where clusters take up a good part of the plane, 43 to 45 % are odd. Both ways lead to the
  // same clusters.
  if (crust_.odd_count() > 64 + delaunay_.site_count() / 3) {
    join_all(job);
  } else {
    for (const SiteSlot site : delaunay_.site_slots()) {
      if (!delaunay_.is_site(site) || !crust_.is_odd(site) || cluster_of_[site].is_valid()) continue;
      grow(site, job);
      if (!is_too_much()) continue;
      join_all(job);
      break;
    }
  }
  settle_all(job);
}

void ConflictJoin::make_room() {
  state_.resize(delaunay_.edge_rows(), 0);
  cluster_of_.resize(delaunay_.site_rows());
  for (Walks* walks : {&near_walks_, &far_walks_}) walks->through.resize(delaunay_.site_rows());
}

void ConflictJoin::begin() {
  make_room();
  grown_sites_ = 0;
  noted_.clear();
  noted_marks_.begin(delaunay_.edge_rows());
}

void ConflictJoin::join_all(JobControl& job) {
  // Kruskal, remembering the order of merging as a binary forest: leaves are sites, inner nodes merges.
  std::vector<Rank> edges;
  edges.reserve(delaunay_.edge_rows());
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if ((edge.index() & 0xffffU) == 0) job.checkpoint();
    if (delaunay_.edge(edge).is_alive()) edges.push_back(rank_of(edge));
  }
  std::ranges::sort(edges, [this](const Rank& a, const Rank& b) { return is_surer(b, a); });
  job.checkpoint();

  // Of the forest: the sites in their order, then the merges in theirs.
  using Node = Slot<struct ForestTag>;
  struct Merge {
    Node left, right;
    EdgeSlot edge;
    bool closes;  ///< two odd components made an even one
  };
  const std::size_t sites = delaunay_.site_rows();
  DisjointSets<SiteSlot> joined(sites);
  Table<SiteSlot, Node> node(sites);  // of the component, by root
  Table<SiteSlot, std::uint8_t> odd(sites);
  for (const SiteSlot site : delaunay_.site_slots()) {
    node[site] = same_row<Node>(site);
    odd[site] = delaunay_.is_site(site) && crust_.is_odd(site) ? 1 : 0;
  }
  std::vector<Merge> merges;
  merges.reserve(sites);
  for (const Rank& edge : edges) {
    const EdgeRow& row = delaunay_.edge(edge.edge);
    const SiteSlot a = joined.root(row.v[1]);
    const SiteSlot b = joined.root(row.v[0]);
    if (a == b) continue;
    const auto odd_of_both = static_cast<std::uint8_t>(odd[a] ^ odd[b]);
    const Node merge(sites + merges.size());
    merges.push_back({node[a], node[b], edge.edge, odd[a] != 0 && odd[b] != 0});
    const SiteSlot both = joined.join(a, b);
    odd[both] = odd_of_both;
    node[both] = merge;
  }
  job.checkpoint();

  // The clusters: the outermost merges that close.
  for (const EdgeSlot edge : state_.rows()) {
    if (state_[edge] != 0 && noted_marks_.insert(edge)) noted_.push_back({edge, state_[edge]});
  }
  clear();
  make_room();
  std::vector<std::uint8_t> covered(merges.size(), 0);
  Table<SiteSlot, TreeSlot> position(sites);
  std::vector<Node> stack;
  std::vector<std::size_t> inside;  // merges of a cluster
  for (std::size_t m = merges.size(); m-- > 0;) {
    const auto pass_on = [&](Node child) {
      if (child.index() >= sites) covered[child.index() - sites] = 1;
    };
    if (covered[m] == 0 && merges[m].closes) {
      std::vector<SiteSlot> members;
      inside.clear();
      stack.assign(1, Node(sites + m));
      while (!stack.empty()) {
        const Node at = stack.back();
        stack.pop_back();
        if (at.index() < sites) {
          position[same_row<SiteSlot>(at)] = TreeSlot(members.size());
          members.push_back(same_row<SiteSlot>(at));
          continue;
        }
        const std::size_t merge = at.index() - sites;
        inside.push_back(merge);
        stack.push_back(merges[merge].left);
        stack.push_back(merges[merge].right);
      }
      std::ranges::sort(inside);
      edges_.clear();
      for (const std::size_t i : inside) {
        const EdgeRow& row = delaunay_.edge(merges[i].edge);
        edges_.push_back({merges[i].edge, position[row.v[0]], position[row.v[1]]});
      }
      add_cluster(std::move(members));
      covered[m] = 1;
    }
    if (covered[m] == 0) continue;
    pass_on(merges[m].left);
    pass_on(merges[m].right);
  }
}

void ConflictJoin::update(JobControl& job, std::vector<EdgeSlot>& changed_edges) {
  changed_edges.clear();
  if (crust_.odd_count() == 0 && clusters_.empty()) return;
  begin();
  seeds_.clear();
  const auto touch = [this](SiteSlot site) {
    unsettle_walks(near_walks_, site);
    unsettle_walks(far_walks_, site);
    const ClusterId id = cluster_of_[site];
    if (!id.is_valid()) return;
    const Cluster& cluster = clusters_.at(id);
    seeds_.insert(seeds_.end(), cluster.sites.begin(), cluster.sites.end());
    dissolve(id);
  };
  const ChangeSet<SiteSlot>& sites = crust_.site_changes();
  for (const SiteSlot site : sites.removed) touch(site);
  for (const SiteSlot site : sites.touched) touch(site);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched)
    for (const SiteSlot site : delaunay_.edge(edge).v) touch(site);
  // What an edge mends depends on the degrees at both of its ends.
  for (const SiteSlot site : crust_.degree_changes())
    delaunay_.for_each_edge_at(site, [&](EdgeSlot, SiteSlot other, FaceSlot) { touch(other); });
  seeds_.insert(seeds_.end(), crust_.degree_changes().begin(), crust_.degree_changes().end());
  // Where clusters as large as this come apart, growing new ones mostly ends in making the whole tree.
  grown_sites_ = seeds_.size();
  if (is_too_much()) {
    join_all(job);
    seeds_.clear();
  }
  grown_sites_ = 0;
  for (std::size_t i = 0; i < seeds_.size(); ++i) {
    const SiteSlot site = seeds_[i];
    if (!delaunay_.is_site(site) || !crust_.is_odd(site) || cluster_of_[site].is_valid()) continue;
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
