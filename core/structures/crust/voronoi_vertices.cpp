// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/voronoi_vertices.h"

#include <algorithm>
#include <array>
#include <compare>
#include <span>

namespace mes {

VoronoiVertices::VoronoiVertices(Delaunay& delaunay, OneStepCrust& crust)
    : Structure("voronoi-vertices", {&delaunay, &crust}), delaunay_(delaunay), crust_(crust) {}

bool VoronoiVertices::has_cocircular_edge(FaceSlot face) const {
  for (const EdgeSlot edge : delaunay_.face(face).e)
    if (edge != kNoSlot && crust_.is_cocircular(edge)) return true;
  return false;
}

std::array<Vec2, 3> VoronoiVertices::sorted_corners(FaceSlot face) const {
  const auto& v = delaunay_.face(face).v;
  std::array<Vec2, 3> out{delaunay_.site_position(v[0]), delaunay_.site_position(v[1]),
                          delaunay_.site_position(v[2])};
  std::ranges::sort(out, lexicographically_less);
  return out;
}

void VoronoiVertices::gather_group(FaceSlot face) {
  GroupSlot group = groups_.next();
  if (free_groups_.empty()) {
    groups_.emplace_back();
  } else {
    group = free_groups_.back();
    free_groups_.pop_back();
  }
  std::vector<FaceSlot>& members = groups_[group];
  members.assign(1, face);
  group_of_[face] = group;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const FaceRow& row = delaunay_.face(members[next]);
    for (int i = 0; i < 3; ++i) {
      if (row.e[i] == kNoSlot || !crust_.is_cocircular(row.e[i])) continue;
      if (group_of_[row.n[i]] != kNoSlot) continue;
      group_of_[row.n[i]] = group;
      members.push_back(row.n[i]);
    }
  }
  // Each face of the group rounds the circle in its own way, and has other corners to make balls from. The first of
  // them stands for all.
  const auto comes_before = [this](FaceSlot x, FaceSlot y) {
    const FaceRow& a = delaunay_.face(x);
    const FaceRow& b = delaunay_.face(y);
    if (const auto order = std::strong_order(a.center.x, b.center.x); order != 0) return order < 0;
    if (const auto order = std::strong_order(a.center.y, b.center.y); order != 0) return order < 0;
    if (const auto order = std::strong_order(a.radius, b.radius); order != 0) return order < 0;
    return std::ranges::lexicographical_compare(sorted_corners(x), sorted_corners(y), lexicographically_less);
  };
  std::ranges::iter_swap(members.begin(), std::ranges::min_element(members, comes_before));
}

void VoronoiVertices::append_sites(FaceSlot face, std::vector<SiteSlot>& out) const {
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  const std::vector<FaceSlot>* faces = group(face);
  for (const FaceSlot f : faces != nullptr ? std::span<const FaceSlot>(*faces) : std::span<const FaceSlot>(&face, 1))
    for (const SiteSlot site : delaunay_.face(f).v) out.push_back(site);
  std::sort(out.begin() + first, out.end());
  out.erase(std::unique(out.begin() + first, out.end()), out.end());
}

void VoronoiVertices::rebuild(JobControl&) {
  clear_changes();
  group_of_.clear();
  groups_.clear();
  free_groups_.clear();
  if (crust_.cocircular_count() == 0) return;
  group_of_.resize(delaunay_.face_rows());
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!delaunay_.edge(edge).is_alive() || !crust_.is_cocircular(edge)) continue;
    const FaceSlot face = delaunay_.edge(edge).f[0];
    if (group_of_[face] == kNoSlot) gather_group(face);
  }
}

bool VoronoiVertices::update(JobControl&) {
  const ChangeSet<FaceSlot>& faces = delaunay_.face_changes();
  follows_faces_ = crust_.cocircular_count() == 0 && group_count() == 0;
  if (follows_faces_) {
    changes_ = faces;
    return true;
  }
  group_of_.resize(delaunay_.face_rows());
  recorder_.begin(delaunay_.face_rows());
  for (const FaceSlot face : faces.removed) recorder_.note(face, true);
  for (const FaceSlot face : faces.touched) recorder_.note(face, true);
  work_.assign(faces.touched.begin(), faces.touched.end());
  // A group that met the change may have lost or gained faces or been split; its other faces, and groups across changed
  // edges, are checked again. A group loses nothing across an edge that is not cocircular: the face that it was
  // cocircular with is among those removed or changed, and stands for the group below.
  for (const EdgeSlot edge : delaunay_.edge_changes().touched)
    if (crust_.is_cocircular(edge))
      for (const FaceSlot face : delaunay_.edge(edge).f) work_.push_back(face);
  work_.insert(work_.end(), faces.removed.begin(), faces.removed.end());
  for (std::size_t next = 0; next < work_.size(); ++next) {
    const GroupSlot group = group_of_[work_[next]];
    if (group == kNoSlot) continue;
    for (const FaceSlot member : groups_[group]) {
      group_of_[member] = kNoSlot;
      work_.push_back(member);
    }
    groups_[group] = {};
    free_groups_.push_back(group);
  }
  for (const FaceSlot face : work_) {
    if (!delaunay_.is_finite_face(face) || !has_cocircular_edge(face) || group_of_[face] != kNoSlot) continue;
    gather_group(face);
    for (const FaceSlot member : groups_[group_of_[face]]) recorder_.note(member, true);
  }
  for (const FaceSlot face : work_) recorder_.note(face, true);
  recorder_.finish(changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  return true;
}

StatList VoronoiVertices::statistics() const {
  std::int64_t vertices = 0;
  for (const FaceSlot face : delaunay_.face_slots())
    vertices += delaunay_.face(face).is_alive() && is_vertex(face) ? 1 : 0;
  return {{"vertices", vertices}, {"of_more_than_three_samples", static_cast<std::int64_t>(group_count())}};
}

}  // namespace mes
