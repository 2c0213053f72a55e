// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/certainty_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"

namespace mes {

namespace {

// Keys of edges that are about to go: surer than all others, and all different. No exact test sees such an edge, which
// may not be there any more.
constexpr double kGoing = 16.0;

}  // namespace

CertaintyTree::CertaintyTree(const Delaunay& delaunay, const OneStepCrust& crust, const CertaintyOrder& order)
    : delaunay_(delaunay), crust_(crust), order_(order), sites_(Surer{this}), faces_(MoreDoubtful{this}) {}

CertaintyTree::Ends CertaintyTree::ends_of(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  return {{row.v[0].index(), row.v[1].index()}, {vertex_of(row.f[0]), vertex_of(row.f[1])}};
}

void CertaintyTree::make_room() {
  key_.resize(delaunay_.edge_rows());
  ends_.resize(delaunay_.edge_rows());
  place_.resize(delaunay_.edge_rows(), Place::none);
  sites_.grow(delaunay_.site_rows(), delaunay_.edge_rows());
  faces_.grow(delaunay_.face_rows() + 1, delaunay_.edge_rows());
}

// By their keys alone, so that all edges of one group come before all of the next, except those whose keys differ by less
// than their error.
CertaintyTree::Groups CertaintyTree::grouped_by_key() {
  using Rank = CertaintyOrder::Rank;
  // Keys lie between -2 and 1.5.
  constexpr std::size_t kGroups = 2048;
  constexpr double kPerGroup = static_cast<double>(kGroups) / 3.5;
  const auto group_of = [](double key) {
    return static_cast<std::size_t>(std::clamp((key + 2.0) * kPerGroup, 0.0, static_cast<double>(kGroups - 1)));
  };
  const std::size_t rows = delaunay_.edge_rows();
  const std::size_t parts = worker_count();
  const auto rows_of = [&](std::size_t part) {
    return slots_between<EdgeSlot>(rows * part / parts, rows * (part + 1) / parts);
  };
  std::vector<std::vector<std::size_t>> place(parts);  // first how many there are, then where the next one goes
  run_tasks(parts, [&](std::size_t part) {
    std::vector<std::size_t> counts(kGroups, 0);
    for (const EdgeSlot edge : rows_of(part)) {
      if (!delaunay_.edge(edge).is_alive()) continue;
      key_[edge] = order_.rank_of(edge).key;
      ++counts[group_of(key_[edge])];
    }
    place[part] = std::move(counts);
  });
  Groups out;
  out.begin.reserve(kGroups + 1);
  std::size_t total = 0;
  for (std::size_t group = 0; group < kGroups; ++group) {
    out.begin.push_back(total);
    for (std::size_t part = 0; part < parts; ++part) total += std::exchange(place[part][group], total);
  }
  out.begin.push_back(total);
  out.ranks.resize(total);
  run_tasks(parts, [&](std::size_t part) {
    std::vector<std::size_t>& next = place[part];
    for (const EdgeSlot edge : rows_of(part))
      if (delaunay_.edge(edge).is_alive()) out.ranks[next[group_of(key_[edge])]++] = Rank{key_[edge], edge};
  });
  return out;
}

// Kruskal's algorithm. Most edges are never put in order: when their group comes, their ends are in one tree already.
void CertaintyTree::rebuild(JobControl& job) {
  using Rank = CertaintyOrder::Rank;
  has_forests_ = false;
  key_.assign(delaunay_.edge_rows(), 0.0);
  place_.assign(delaunay_.edge_rows(), Place::none);
  const Groups groups = grouped_by_key();
  job.checkpoint();
  DisjointSets<SiteSlot> joined(delaunay_.site_rows());
  const auto are_joined = [&](EdgeSlot edge) {
    const EdgeRow& row = delaunay_.edge(edge);
    return joined.root(row.v[0]) == joined.root(row.v[1]);
  };
  std::vector<Rank> waiting;
  for (std::size_t group = 0; group + 1 < groups.begin.size(); ++group) {
    if (groups.begin[group] == groups.begin[group + 1]) continue;
    job.checkpoint();
    for (std::size_t i = groups.begin[group]; i < groups.begin[group + 1]; ++i) {
      const Rank& rank = groups.ranks[i];
      if (are_joined(rank.edge))
        place_[rank.edge] = Place::faces;
      else
        waiting.push_back(rank);
    }
    std::ranges::sort(waiting, [this](const Rank& a, const Rank& b) { return order_.is_surer(b, a); });
    // What is too near to an edge of the next groups waits for it.
    double least = groups.least_after(group);
    std::size_t ready = waiting.size();
    while (ready != 0 && waiting[ready - 1].key >= least - 4.0 * kAmbiguityKeyError)
      least = std::min(least, waiting[--ready].key);
    for (std::size_t i = 0; i < ready; ++i) {
      const EdgeRow& row = delaunay_.edge(waiting[i].edge);
      const SiteSlot a = joined.root(row.v[0]);
      const SiteSlot b = joined.root(row.v[1]);
      place_[waiting[i].edge] = a == b ? Place::faces : Place::sites;
      if (a != b) joined.join(a, b);
    }
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(ready));
  }
}

double CertaintyTree::Groups::least_after(std::size_t group) const {
  double least = std::numeric_limits<double>::infinity();
  const auto next = std::ranges::upper_bound(begin, begin[group + 1]);
  if (next == begin.end()) return least;
  for (std::size_t i = begin[group + 1]; i < *next; ++i) least = std::min(least, ranks[i].key);
  return least;
}

void CertaintyTree::make_forests(JobControl& job) {
  ends_.resize(delaunay_.edge_rows());
  sites_.clear(delaunay_.site_rows(), delaunay_.edge_rows());
  faces_.clear(delaunay_.face_rows() + 1, delaunay_.edge_rows());
  parallel_for(delaunay_.edge_rows(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end))
      if (delaunay_.edge(edge).is_alive()) ends_[edge] = ends_of(edge);
  });
  job.checkpoint();

  // Both trees, from their roots down.
  std::vector<std::pair<SiteSlot, EdgeSlot>> sites;
  for (const SiteSlot site : delaunay_.site_slots()) {
    if (!delaunay_.is_site(site)) continue;
    sites.emplace_back(site, kNoSlot);
    break;
  }
  while (!sites.empty()) {
    const auto [site, up] = sites.back();
    sites.pop_back();
    delaunay_.for_each_edge_at(site, [&, site = site, up = up](EdgeSlot edge, SiteSlot other, FaceSlot) {
      if (edge == up || place_[edge] != Place::sites) return;
      sites_.hang(edge, site.index(), other.index());
      sites.emplace_back(other, edge);
    });
  }
  job.checkpoint();
  std::vector<std::pair<FaceSlot, EdgeSlot>> faces;
  const auto hang_below = [&](FaceSlot face, EdgeSlot up) {
    const FaceRow& row = delaunay_.face(face);
    for (int i = 0; i < 3; ++i) {
      const EdgeSlot edge = row.e[i];
      if (edge == kNoSlot || edge == up || place_[edge] != Place::faces) continue;
      faces_.hang(edge, vertex_of(face), vertex_of(row.n[i]));
      faces.emplace_back(row.n[i], edge);
    }
  };
  for (const FaceSlot face : delaunay_.face_slots())
    if (delaunay_.face(face).is_alive() && delaunay_.face(face).is_infinite()) hang_below(face, kNoSlot);
  while (!faces.empty()) {
    const auto [face, up] = faces.back();
    faces.pop_back();
    hang_below(face, up);
  }
  has_forests_ = true;
}

void CertaintyTree::put_between_sites(EdgeSlot edge) {
  sites_.link(edge, ends_[edge].sites[0], ends_[edge].sites[1]);
  place_[edge] = Place::sites;
}

void CertaintyTree::put_between_faces(EdgeSlot edge) {
  faces_.link(edge, ends_[edge].faces[0], ends_[edge].faces[1]);
  place_[edge] = Place::faces;
}

void CertaintyTree::take_out(EdgeSlot edge) {
  const Ends& ends = ends_[edge];
  if (place_[edge] == Place::sites) {
    sites_.cut(edge, ends.sites[0], ends.sites[1]);
  } else {
    faces_.cut(edge, ends.faces[0], ends.faces[1]);
  }
  place_[edge] = Place::none;
}

void CertaintyTree::insert(EdgeSlot edge) {
  const Ends& ends = ends_[edge];
  if (!sites_.are_connected(ends.sites[0], ends.sites[1])) {
    put_between_sites(edge);
    return;
  }
  const EdgeSlot surest = sites_.best_between(ends.sites[0], ends.sites[1]);
  if (is_surer(surest, edge)) {
    take_out(surest);
    put_between_faces(surest);
    put_between_sites(edge);
    new_between_faces_.push_back(surest);
  } else {
    put_between_faces(edge);
    new_between_faces_.push_back(edge);
  }
}

void CertaintyTree::update(JobControl& job) {
  make_room();
  new_between_faces_.clear();
  going_.clear();
  coming_.clear();
  marks_.begin(delaunay_.edge_rows());
  const auto note = [this](EdgeSlot edge) {
    if (!marks_.insert(edge)) return;
    if (place_[edge] != Place::none) going_.push_back(edge);
    if (delaunay_.edge(edge).is_alive()) coming_.push_back(edge);
  };
  for (const EdgeSlot edge : delaunay_.edge_changes().removed) note(edge);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched) note(edge);
  // What an edge mends depends on the degrees at both of its ends.
  for (const SiteSlot site : crust_.degree_changes())
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) {
      if (order_.mends(edge) != (key_[edge] < 0.0)) note(edge);
    });

  // Those that go become the surest of all: what is left of the tree of sites without them is then the minimum spanning
  // forest of the edges that stay.
  for (std::size_t i = 0; i < going_.size(); ++i) key_[going_[i]] = kGoing + static_cast<double>(i);
  for (const EdgeSlot edge : going_)
    if (place_[edge] == Place::faces) faces_.refresh(edge);
  for (std::size_t i = 0; i < going_.size(); ++i) {
    if ((i & 1023U) == 0) job.checkpoint();
    const EdgeSlot edge = going_[i];
    if (place_[edge] != Place::sites) continue;
    const EdgeSlot instead = faces_.best_between(ends_[edge].faces[0], ends_[edge].faces[1]);
    if (key_[instead] >= kGoing) continue;
    take_out(edge);
    take_out(instead);
    put_between_sites(instead);
    put_between_faces(edge);
  }
  for (const EdgeSlot edge : going_) take_out(edge);
  // No cycle is closed in either forest on the way: edges that have not come yet hold all together.
  for (std::size_t i = 0; i < coming_.size(); ++i) {
    if ((i & 1023U) == 0) job.checkpoint();
    const EdgeSlot edge = coming_[i];
    key_[edge] = order_.rank_of(edge).key;
    ends_[edge] = ends_of(edge);
    insert(edge);
  }
}

}  // namespace mes
