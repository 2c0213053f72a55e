// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/alpha/alpha_filtration.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/structures/alpha/persistence.h"
#include "core/structures/delaunay/sorted_ends.h"

namespace mes {
namespace {

std::array<Vec2, 3> sorted_corners(const Delaunay& delaunay, FaceSlot face) {
  const SiteSlot* const v = delaunay.face(face).v;
  std::array out{delaunay.site_position(v[0]), delaunay.site_position(v[1]), delaunay.site_position(v[2])};
  std::ranges::sort(out, lexicographically_less);
  return out;
}

/// The rows with a rank, sorted by rank and then by corners.
template <class Row, class Corners>
std::vector<Row> in_order(const Table<Row, std::uint32_t>& ranks, std::uint32_t none, Corners corners) {
  struct Entry {
    std::uint32_t rank = 0;
    Row row{};
  };
  std::vector<Entry> entries;
  entries.reserve(ranks.size());
  for (const Row row : ranks.rows())
    if (ranks[row] != none) entries.push_back({ranks[row], row});
  std::ranges::sort(entries, [&](const Entry& a, const Entry& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    return a.row != b.row &&
           std::ranges::lexicographical_compare(corners(a.row), corners(b.row), lexicographically_less);
  });
  std::vector<Row> out(entries.size());
  std::ranges::transform(entries, out.begin(), &Entry::row);
  return out;
}

}  // namespace

AlphaFiltration::AlphaFiltration(Delaunay& delaunay)
    : Structure("alpha-filtration", {&delaunay}), delaunay_(delaunay) {}

FaceSlot AlphaFiltration::comes_with(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  for (const FaceSlot face : row.f) {
    if (face == kNoSlot || delaunay_.face(face).is_infinite()) continue;
    if (sees_wide(delaunay_.site_position(delaunay_.apex(face, edge)), delaunay_.site_position(row.v[0]),
                  delaunay_.site_position(row.v[1])))
      return face;  // where both see a right angle, their radii are equal
  }
  return FaceSlot();
}

void AlphaFiltration::find_ranks(JobControl& job) {
  edge_rank_.assign(delaunay_.edge_rows(), kNever);
  face_rank_.assign(delaunay_.face_rows(), kNever);
  std::vector<SpannedCircle> circles;
  circles.reserve(delaunay_.face_rows() + delaunay_.edge_rows());
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.is_finite_face(face)) continue;
    face_rank_[face] = static_cast<std::uint32_t>(circles.size());
    const SiteSlot* const v = delaunay_.face(face).v;
    circles.push_back(
        {delaunay_.site_position(v[0]), delaunay_.site_position(v[1]), delaunay_.site_position(v[2]), true});
  }
  job.checkpoint();
  std::vector<std::pair<EdgeSlot, FaceSlot>> attached;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (!row.is_alive()) continue;
    if (const FaceSlot face = comes_with(edge); face != kNoSlot) {
      attached.emplace_back(edge, face);
      continue;
    }
    edge_rank_[edge] = static_cast<std::uint32_t>(circles.size());
    circles.push_back({delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]), {}, false});
  }
  const RadiusRanks ranks = rank_radii(circles, [&job] { job.checkpoint(); });
  radius_.assign(1, 0.0);
  radius_.insert(radius_.end(), ranks.radius.begin(), ranks.radius.end());
  if (delaunay_.site_count() == 0) radius_.clear();
  for (std::uint32_t& rank : face_rank_)
    if (rank != kNever) rank = ranks.rank[rank] + 1;
  for (std::uint32_t& rank : edge_rank_)
    if (rank != kNever) rank = ranks.rank[rank] + 1;
  for (const auto& [edge, face] : attached) edge_rank_[edge] = face_rank_[face];
}

void AlphaFiltration::find_order() {
  edges_ = in_order(edge_rank_, kNever, [this](EdgeSlot edge) { return sorted_ends(delaunay_, edge); });
  faces_ = in_order(face_rank_, kNever, [this](FaceSlot face) { return sorted_corners(delaunay_, face); });
}

void AlphaFiltration::find_classes() {
  std::vector<SiteSlot> sites;
  sites.reserve(delaunay_.site_count());
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site)) sites.push_back(site);
  std::ranges::sort(sites, [this](SiteSlot a, SiteSlot b) {
    return lexicographically_less(delaunay_.site_position(a), delaunay_.site_position(b));
  });
  PlaneFiltration plane;
  Table<SiteSlot, std::uint32_t> number_of_site(delaunay_.site_rows(), 0);
  plane.corners.reserve(sites.size());
  for (const SiteSlot site : sites) {
    const auto number = static_cast<std::uint32_t>(plane.corners.size());
    number_of_site[site] = number;
    plane.corners.push_back({0, number});
  }
  Table<FaceSlot, std::uint32_t> number_of_face(delaunay_.face_rows(), PlaneFiltration::kOutside);
  plane.triangles.reserve(faces_.size());
  for (const FaceSlot face : faces_) {
    const auto number = static_cast<std::uint32_t>(plane.triangles.size());
    number_of_face[face] = number;
    plane.triangles.push_back({face_rank_[face], number});
  }
  plane.edges.reserve(edges_.size());
  for (const EdgeSlot edge : edges_) {
    const EdgeRow& row = delaunay_.edge(edge);
    PlaneFiltration::Edge out{edge_rank_[edge], {number_of_site[row.v[0]], number_of_site[row.v[1]]}};
    for (int i = 0; i < 2; ++i)
      if (row.f[i] != kNoSlot) out.side[i] = number_of_face[row.f[i]];
    plane.edges.push_back(out);
  }
  classes_.clear();
  for (const PersistentClass& found : persistent_classes(plane)) {
    Class out{found.is_hole, found.birth, found.death};
    if (found.is_hole) {
      out.edge = edges_[found.born_with];
      out.face = faces_[found.dies_with];
    } else {
      out.site = sites[found.born_with];
      if (found.dies_with != PersistentClass::kNever) out.edge = edges_[found.dies_with];
    }
    classes_.push_back(out);
  }
}

std::uint32_t AlphaFiltration::last_rank(double r) const {
  // Exact, since no double lies between a radius and its rounded-up value.
  const auto at = std::ranges::upper_bound(radius_, r) - radius_.begin();
  return at == 0 ? 0 : static_cast<std::uint32_t>(at - 1);
}

void AlphaFiltration::rebuild(JobControl& job) {
  find_ranks(job);
  job.checkpoint();
  find_order();
  job.checkpoint();
  find_classes();
}

bool AlphaFiltration::update(JobControl&) {
  return delaunay_.site_changes().is_empty() && delaunay_.face_changes().is_empty() &&
         delaunay_.edge_changes().is_empty();
}

StatList AlphaFiltration::statistics() const {
  std::int64_t joined = 0;
  std::int64_t holes = 0;
  std::int64_t stay = 0;
  for (const Class& one : classes_) ++(one.is_hole ? holes : (one.death == kNever ? stay : joined));
  return {{"radii", static_cast<std::int64_t>(radius_.empty() ? 0 : radius_.size() - 1)},
          {"joined", joined},
          {"holes", holes},
          {"stay", stay}};
}

}  // namespace mes
