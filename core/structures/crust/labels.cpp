// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/labels.h"

#include "core/structures/crust/internal/side_search.h"

namespace mes {

Labels::Labels(Delaunay& delaunay, OneStepCrust& crust)
    : Structure("labels", {&delaunay, &crust}), delaunay_(delaunay), crust_(crust), join_(delaunay, crust) {}

void Labels::clear_changes() {
  face_changes_.clear();
  edge_changes_.clear();
}

void Labels::rebuild(JobControl& job) {
  clear_changes();
  join_.rebuild(job);
  constexpr std::uint8_t kUnknown = 2;
  inside_.assign(delaunay_.face_rows(), kUnknown);
  if (delaunay_.dimension() < 2) return;
  queue_.clear();
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.face(face).is_alive() || !delaunay_.face(face).is_infinite()) continue;
    inside_[face] = 0;
    queue_.push_back(face);
    break;
  }
  std::uint64_t done = 0;
  while (!queue_.empty()) {
    const FaceSlot face = queue_.back();
    queue_.pop_back();
    if ((++done & 0xffffU) == 0) job.checkpoint(done, delaunay_.face_rows());
    for (int i = 0; i < 3; ++i) {
      const FaceSlot other = delaunay_.face(face).n[i];
      if (inside_[other] != kUnknown) continue;
      inside_[other] = static_cast<std::uint8_t>(inside_[face] ^ (is_border(face, i) ? 1U : 0U));
      queue_.push_back(other);
    }
  }
}

void Labels::label_new_faces() {
  unlabelled_.begin(delaunay_.face_rows());
  for (const FaceSlot face : delaunay_.face_changes().touched) unlabelled_.insert(face);
  queue_.clear();
  const auto settle = [this](FaceSlot face, bool inside) {
    inside_[face] = inside ? 1 : 0;
    unlabelled_.erase(face);
    queue_.push_back(face);
  };
  for (const FaceSlot seed : delaunay_.face_changes().touched) {
    if (!unlabelled_.contains(seed)) continue;
    if (delaunay_.face(seed).is_infinite()) {
      settle(seed, false);
    } else {
      for (int i = 0; i < 3; ++i) {
        const FaceSlot other = delaunay_.face(seed).n[i];
        if (unlabelled_.contains(other)) continue;
        settle(seed, is_inside(other) != is_border(seed, i));
        break;
      }
    }
    while (!queue_.empty()) {
      const FaceSlot face = queue_.back();
      queue_.pop_back();
      for (int i = 0; i < 3; ++i) {
        const FaceSlot other = delaunay_.face(face).n[i];
        if (!unlabelled_.contains(other)) continue;
        settle(other, !delaunay_.face(other).is_infinite() && is_inside(face) != is_border(face, i));
      }
    }
  }
}

// Collects the edges that labels contradict, and turns over what must be.
bool Labels::repair(JobControl& job) {
  violations_.clear();
  for (const FaceSlot face : delaunay_.face_changes().touched)
    for (int i = 0; i < 3; ++i)
      if (is_violated(face, i)) violations_.push_back({face, delaunay_.face(face).n[i]});
  for (const EdgeSlot edge : conflict_edges_) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (is_violated(row.f[0], delaunay_.face(row.f[0]).index_of_edge(edge)))
      violations_.push_back({row.f[0], row.f[1]});
  }
  if (violations_.empty()) return true;
  std::vector<std::pair<FaceSlot, FaceSlot>> pairs;
  pairs.reserve(violations_.size());
  for (const Violation& v : violations_) pairs.emplace_back(v.face, v.other);
  SideSearch search;
  return search.run(
      pairs,
      [this](FaceSlot face, auto visit) {
        for (int i = 0; i < 3; ++i)
          if (!is_violated(face, i)) visit(delaunay_.face(face).n[i]);
      },
      [this](FaceSlot face) { return delaunay_.face(face).is_infinite(); },
      [this](FaceSlot face) {
        inside_[face] ^= 1U;
        turned_.push_back(face);
      },
      job);
}

bool Labels::update(JobControl& job) {
  inside_.resize(delaunay_.face_rows(), 0);
  turned_.clear();
  join_.update(job, conflict_edges_);
  label_new_faces();
  if (!repair(job)) return false;

  if (turned_.empty() && conflict_edges_.empty()) {
    // The usual case: labels differ only where the triangulation does.
    face_changes_ = delaunay_.face_changes();
    edge_changes_ = delaunay_.edge_changes();
    return true;
  }
  face_recorder_.begin(delaunay_.face_rows());
  edge_recorder_.begin(delaunay_.edge_rows());
  for (const FaceSlot face : delaunay_.face_changes().removed) face_recorder_.note(face, true);
  for (const FaceSlot face : delaunay_.face_changes().touched) face_recorder_.note(face, true);
  for (const EdgeSlot edge : delaunay_.edge_changes().removed) edge_recorder_.note(edge, true);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched) edge_recorder_.note(edge, true);
  for (const EdgeSlot edge : conflict_edges_) edge_recorder_.note(edge, true);
  for (const FaceSlot face : turned_) {
    face_recorder_.note(face, true);
    for (const EdgeSlot edge : delaunay_.face(face).e)
      if (edge != kNoSlot) edge_recorder_.note(edge, true);
  }
  face_recorder_.finish(face_changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  edge_recorder_.finish(edge_changes_, [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  return true;
}

StatList Labels::statistics() const {
  std::int64_t inside = 0;
  std::int64_t outside = 0;
  for (const FaceSlot face : delaunay_.face_slots())
    if (delaunay_.is_finite_face(face)) (is_inside(face) ? inside : outside) += 1;
  return {{"inside", inside},
          {"outside", outside},
          {"conflicts", static_cast<std::int64_t>(conflict_count())},
          {"open_strokes", static_cast<std::int64_t>(join_.stroke_count())},
          {"conflict_clusters", static_cast<std::int64_t>(join_.cluster_count())},
          {"largest_cluster", static_cast<std::int64_t>(join_.largest_cluster())}};
}

void Labels::find(std::vector<Finding>& out) const {
  if (conflict_count() == 0) return;
  Finding& finding = out.emplace_back();
  finding.text = "edges labelled against their crust test";
  finding.count = static_cast<std::int64_t>(conflict_count());
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (finding.places.size() == kMostPlaces) break;
    const EdgeRow& row = delaunay_.edge(edge);
    if (row.is_alive() && is_conflict(edge))
      finding.places.push_back(0.5 * (delaunay_.site_position(row.v[0]) + delaunay_.site_position(row.v[1])));
  }
}

}  // namespace mes
