// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/certainty_tree.h"

#include <algorithm>

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

std::vector<CertaintyOrder::Rank> CertaintyTree::ranks_in_order(JobControl& job) {
  using Rank = CertaintyOrder::Rank;
  std::vector<Rank> ranks;
  ranks.reserve(delaunay_.edge_rows());
  for (const EdgeSlot edge : delaunay_.edge_slots())
    if (delaunay_.edge(edge).is_alive()) ranks.push_back({0.0, edge});
  const auto is_before = [this](const Rank& a, const Rank& b) { return order_.is_surer(b, a); };
  const std::size_t parts = worker_count();
  const auto begin_of = [&](std::size_t part) {
    return ranks.begin() + static_cast<std::ptrdiff_t>(ranks.size() * std::min(part, parts) / parts);
  };
  run_tasks(parts, [&](std::size_t part) {
    for (auto rank = begin_of(part); rank != begin_of(part + 1); ++rank) {
      *rank = order_.rank_of(rank->edge);
      key_[rank->edge] = rank->key;
      ends_[rank->edge] = ends_of(rank->edge);
    }
    std::sort(begin_of(part), begin_of(part + 1), is_before);
  });
  job.checkpoint();
  for (std::size_t width = 1; width < parts; width *= 2) {
    run_tasks((parts + 2 * width - 1) / (2 * width), [&](std::size_t i) {
      const std::size_t part = 2 * width * i;
      std::inplace_merge(begin_of(part), begin_of(part + width), begin_of(part + 2 * width), is_before);
    });
    job.checkpoint();
  }
  return ranks;
}

void CertaintyTree::rebuild(JobControl& job) {
  key_.clear();
  ends_.clear();
  place_.clear();
  sites_.clear(delaunay_.site_rows(), delaunay_.edge_rows());
  faces_.clear(delaunay_.face_rows() + 1, delaunay_.edge_rows());
  make_room();
  DisjointSets<SiteSlot> joined(delaunay_.site_rows());
  for (const CertaintyOrder::Rank& rank : ranks_in_order(job)) {
    const EdgeRow& row = delaunay_.edge(rank.edge);
    const SiteSlot a = joined.root(row.v[0]);
    const SiteSlot b = joined.root(row.v[1]);
    place_[rank.edge] = a == b ? Place::faces : Place::sites;
    if (a != b) joined.join(a, b);
  }
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
