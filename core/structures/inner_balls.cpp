// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inner_balls.h"

#include <algorithm>
#include <limits>

namespace mes {

InnerBalls::InnerBalls(Delaunay& delaunay, OneStepCrust& crust, Labels& labels)
    : Structure("inner-balls", {&delaunay, &crust, &labels}), delaunay_(delaunay), crust_(crust), labels_(labels) {}

bool InnerBalls::has_cocircular_edge(Slot face) const {
  for (const Slot edge : delaunay_.face(face).e)
    if (edge != kNoSlot && crust_.is_cocircular(edge)) return true;
  return false;
}

void InnerBalls::gather_group(Slot face) {
  const Slot id = next_group_++;
  std::vector<Slot> members{face};
  group_of_[face] = id;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const FaceRow& row = delaunay_.face(members[next]);
    for (int i = 0; i < 3; ++i) {
      if (row.e[i] == kNoSlot || !crust_.is_cocircular(row.e[i])) continue;
      if (group_of_.try_emplace(row.n[i], id).second) members.push_back(row.n[i]);
    }
  }
  groups_.emplace(id, std::move(members));
}

void InnerBalls::rebuild(JobControl&) {
  clear_changes();
  group_of_.clear();
  groups_.clear();
  for (Slot edge = 0; edge < delaunay_.edge_rows(); ++edge) {
    if (!delaunay_.edge(edge).is_alive() || !crust_.is_cocircular(edge)) continue;
    const Slot face = delaunay_.edge(edge).f[0];
    if (labels_.is_inside(face) && !group_of_.contains(face)) gather_group(face);
  }
}

bool InnerBalls::update(JobControl&) {
  if (crust_.cocircular_count() == 0 && group_of_.empty()) {
    changes_ = labels_.face_changes();
    return true;
  }
  recorder_.begin(delaunay_.face_rows());
  const ChangeSet& faces = labels_.face_changes();
  for (const Slot face : faces.removed) recorder_.note(face, true);
  for (const Slot face : faces.touched) recorder_.note(face, true);
  work_.assign(faces.touched.begin(), faces.touched.end());
  // A group that met the change may have lost, gained or been split; its other faces, and groups across changed
  // edges, are asked again.
  for (const Slot edge : delaunay_.edge_changes().touched)
    for (const Slot face : delaunay_.edge(edge).f)
      if (crust_.is_cocircular(edge) || (!group_of_.empty() && group_of_.contains(face))) work_.push_back(face);
  if (!group_of_.empty()) {
    work_.insert(work_.end(), faces.removed.begin(), faces.removed.end());
    for (std::size_t next = 0; next < work_.size(); ++next) {
      const auto found = group_of_.find(work_[next]);
      if (found == group_of_.end()) continue;
      const auto group = groups_.find(found->second);
      for (const Slot member : group->second) {
        group_of_.erase(member);
        work_.push_back(member);
      }
      groups_.erase(group);
    }
  }
  for (const Slot face : work_) {
    if (!is_ball(face) || !has_cocircular_edge(face) || group_of_.contains(face)) continue;
    gather_group(face);
    for (const Slot member : groups_.at(group_of_.at(face))) recorder_.note(member, true);
  }
  for (const Slot face : work_) recorder_.note(face, true);
  recorder_.finish(changes_, [this](Slot face) { return delaunay_.face(face).is_alive(); });
  return true;
}

StatList InnerBalls::statistics() const {
  std::int64_t balls = 0;
  std::int64_t distinct = 0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  for (Slot face = 0; face < delaunay_.face_rows(); ++face) {
    if (!delaunay_.face(face).is_alive() || !is_ball(face)) continue;
    ++balls;
    distinct += ball(face) == face ? 1 : 0;
    smallest = std::min(smallest, delaunay_.circumradius(face));
    largest = std::max(largest, delaunay_.circumradius(face));
  }
  return {{"balls", balls}, {"distinct", distinct}, {"radius_min", smallest}, {"radius_max", largest}};
}

}  // namespace mes
