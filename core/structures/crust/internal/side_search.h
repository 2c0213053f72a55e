// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which sides of a set of violated edges must be turned over.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Violated edges cut the faces into regions. Every violated edge has two different regions on its sides, and exactly
/// one of the two must be turned over; regions with a face at infinity stay. `SideSearch` finds the regions by
/// searching from all violated edges in lock-step. It stops when all but one are known completely, so that the largest
/// region, usually the rest of the plane, is hardly visited.
///
/// Cost: O(faces of all regions but the largest, times the number of fronts still open).
class SideSearch {
 public:
  /// `for_each_open_neighbour(face, visit)` calls `visit(neighbour)` across edges that are not violated;
  /// `is_infinite(face)` tells faces at infinity. `turn(face)` is called once for every face to be turned over. Faces
  /// are rows below `face_rows`. False if the demands contradict each other; nothing has been turned then.
  template <class ForEachOpenNeighbour, class IsInfinite, class Turn>
  bool run(const std::vector<std::pair<FaceSlot, FaceSlot>>& violated, ForEachOpenNeighbour for_each_open_neighbour,
           IsInfinite is_infinite, Turn turn, std::size_t face_rows, JobControl& job);

 private:
  struct Front {
    std::uint32_t parent = 0;
    std::vector<FaceSlot> faces;  // reached faces; those from `next` on have yet to be searched from
    std::size_t next = 0;
    bool anchored = false;  // holds a face at infinity
    bool is_exhausted() const { return next == faces.size(); }
  };
  std::uint32_t root(std::uint32_t front) {
    while (fronts_[front].parent != front) {
      fronts_[front].parent = fronts_[fronts_[front].parent].parent;
      front = fronts_[front].parent;
    }
    return front;
  }
  // True if no front had reached the face.
  bool reach(FaceSlot face, std::uint32_t front) {
    if (!reached_.insert(face)) return false;
    front_of_[face] = front;
    return true;
  }
  std::uint32_t start(FaceSlot face) {
    if (reach(face, static_cast<std::uint32_t>(fronts_.size()))) {
      fronts_.push_back({});
      fronts_.back().parent = static_cast<std::uint32_t>(fronts_.size() - 1);
      fronts_.back().faces.push_back(face);
    }
    return front_of_[face];
  }
  // The smaller joins the larger. Faces of either that have not been searched from remain to be.
  std::uint32_t merge(std::uint32_t a, std::uint32_t b) {
    if (fronts_[a].faces.size() < fronts_[b].faces.size()) std::swap(a, b);
    Front& large = fronts_[a];
    Front& small = fronts_[b];
    small.parent = a;
    large.anchored = large.anchored || small.anchored;
    // Searched faces go to the front part, the others to the back, so `next` keeps its meaning.
    large.faces.insert(large.faces.begin() + static_cast<std::ptrdiff_t>(large.next), small.faces.begin(),
                       small.faces.begin() + static_cast<std::ptrdiff_t>(small.next));
    large.next += small.next;
    large.faces.insert(large.faces.end(), small.faces.begin() + static_cast<std::ptrdiff_t>(small.next),
                       small.faces.end());
    small.faces.clear();
    small.next = 0;
    return a;
  }

  std::vector<Front> fronts_;
  SlotMarks<FaceSlot> reached_;
  Table<FaceSlot, std::uint32_t> front_of_;  // for reached faces
};

template <class ForEachOpenNeighbour, class IsInfinite, class Turn>
bool SideSearch::run(const std::vector<std::pair<FaceSlot, FaceSlot>>& violated,
                     ForEachOpenNeighbour for_each_open_neighbour, IsInfinite is_infinite, Turn turn,
                     std::size_t face_rows, JobControl& job) {
  fronts_.clear();
  reached_.begin(face_rows);
  if (front_of_.size() < face_rows) front_of_.resize(face_rows + face_rows / 4);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> demands;
  demands.reserve(violated.size());
  for (const auto& [a, b] : violated) {
    const std::uint32_t front_a = start(a);
    const std::uint32_t front_b = start(b);
    demands.push_back({front_a, front_b});
  }
  std::vector<std::uint32_t> open;
  for (std::uint32_t f = 0; f < fronts_.size(); ++f) open.push_back(f);
  std::uint64_t steps = 0;
  while (open.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      std::uint32_t self = open[k];
      if (fronts_[self].parent != self || fronts_[self].is_exhausted()) continue;
      if ((++steps & 4095U) == 0) job.checkpoint();
      const FaceSlot face = fronts_[self].faces[fronts_[self].next++];
      fronts_[self].anchored = fronts_[self].anchored || is_infinite(face);
      for_each_open_neighbour(face, [&](FaceSlot neighbour) {
        if (reach(neighbour, self)) {
          fronts_[self].faces.push_back(neighbour);
          return;
        }
        const std::uint32_t other = root(front_of_[neighbour]);
        if (other != self) self = merge(self, other);
      });
      open[kept++] = self;
    }
    // Two entries may have become one front.
    open.resize(kept);
    std::size_t distinct = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const std::uint32_t front = open[k];
      if (fronts_[front].parent != front || fronts_[front].is_exhausted()) continue;
      bool seen = false;
      for (std::size_t j = 0; j < distinct && !seen; ++j) seen = open[j] == front;
      if (!seen) open[distinct++] = front;
    }
    open.resize(distinct);
  }

  // Colour the regions: neighbours across a violated edge differ. Anchored regions stay; in a component without one,
  // the region that was not searched completely stays.
  std::vector<std::vector<std::uint32_t>> across(fronts_.size());
  for (auto& [a, b] : demands) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    across[a].push_back(b);
    across[b].push_back(a);
  }
  std::vector<int> colour(fronts_.size(), -1);
  std::vector<std::uint32_t> stack;
  const auto spread = [&](std::uint32_t seed) {
    if (colour[seed] != -1) return true;
    colour[seed] = 0;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const std::uint32_t at = stack.back();
      stack.pop_back();
      for (const std::uint32_t to : across[at]) {
        if (colour[to] == colour[at]) return false;
        if (colour[to] != -1) continue;
        colour[to] = 1 - colour[at];
        stack.push_back(to);
      }
    }
    return true;
  };
  bool consistent = true;
  for (const bool anchored_pass : {true, false})
    for (std::uint32_t f = 0; f < fronts_.size() && consistent; ++f)
      if (root(f) == f && (anchored_pass ? fronts_[f].anchored : !fronts_[f].is_exhausted())) consistent = spread(f);
  for (std::uint32_t f = 0; f < fronts_.size() && consistent; ++f)
    if (root(f) == f) consistent = colour[f] != -1 && !(fronts_[f].anchored && colour[f] == 1);
  if (!consistent) return false;

  for (std::uint32_t f = 0; f < fronts_.size(); ++f) {
    if (root(f) != f || colour[f] != 1) continue;
    // The one region that is not known completely may have to be turned as well: then the rest of it is searched now.
    while (!fronts_[f].is_exhausted()) {
      if ((++steps & 4095U) == 0) job.checkpoint();
      const FaceSlot face = fronts_[f].faces[fronts_[f].next++];
      if (is_infinite(face)) return false;
      for_each_open_neighbour(face, [&](FaceSlot neighbour) {
        if (reach(neighbour, f)) fronts_[f].faces.push_back(neighbour);
      });
    }
  }
  for (std::uint32_t f = 0; f < fronts_.size(); ++f) {
    if (root(f) != f || colour[f] != 1) continue;
    for (const FaceSlot face : fronts_[f].faces) turn(face);
  }
  return true;
}

}  // namespace mes
