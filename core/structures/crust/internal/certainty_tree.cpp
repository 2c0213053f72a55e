// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/certainty_tree.h"

#include <utility>

#include "core/base/jobs/parallel.h"

namespace mes {

namespace {

// Keys of edges that are about to be removed: surer than all others, and all different. No exact test sees such an
// edge, which may be dead already.
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

void CertaintyTree::rebuild(const Table<EdgeSlot, std::uint8_t>& is_in_tree, Table<EdgeSlot, double> keys) {
  has_forests_ = false;
  place_.assign(delaunay_.edge_rows(), Place::none);
  parallel_for(delaunay_.edge_rows(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end))
      if (delaunay_.edge(edge).is_alive()) place_[edge] = is_in_tree[edge] != 0 ? Place::sites : Place::faces;
  });
  key_ = std::move(keys);
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

  // Build both trees from their roots down.
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

void CertaintyTree::find_odd_sides(const std::vector<std::pair<FaceSlot, FaceSlot>>& pairs,
                                   std::vector<FaceSlot>& out) {
  const auto mark = [&](bool is_marked) {
    for (const auto& [a, b] : pairs) {
      const FaceRow& row = delaunay_.face(a);
      faces_.set_mark(row.e[row.index_of_neighbour(b)], is_marked);
    }
  };
  mark(true);
  out.clear();
  for (const auto& [a, b] : pairs) out.push_back(faces_.are_marks_odd(0, vertex_of(a)) ? a : b);
  mark(false);
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
  // Whether an edge mends depends on the degrees at both of its ends; whether it is long, on the crust edges there.
  const auto note_other_kind = [&](EdgeSlot edge) {
    if (order_.has_other_kind({key_[edge], edge})) note(edge);
  };
  for (const SiteSlot site : crust_.degree_changes())
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) { note_other_kind(edge); });
  for (const EdgeSlot edge : order_.changed_edges()) note_other_kind(edge);

  // Edges to be removed become the surest of all. The rest of the tree of sites is then the minimum spanning forest of
  // the edges that stay.
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
  // Neither forest gets a cycle on the way: edges yet to be inserted hold everything together.
  for (std::size_t i = 0; i < coming_.size(); ++i) {
    if ((i & 1023U) == 0) job.checkpoint();
    const EdgeSlot edge = coming_[i];
    key_[edge] = order_.rank_of(edge).key;
    ends_[edge] = ends_of(edge);
    insert(edge);
  }
}

}  // namespace mes
