// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/one_step_crust.h"

#include <algorithm>
#include <atomic>

#include "core/base/parallel.h"
#include "core/base/prefetch.h"

namespace mes {

OneStepCrust::OneStepCrust(Delaunay& delaunay) : Structure("one-step-crust", {&delaunay}), delaunay_(delaunay) {}

EdgeCorners OneStepCrust::corners(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  // Which corner it is follows no pattern: looked up without a branch, which would be foreseen wrongly every other time.
  const auto apex = [this, edge](FaceSlot slot) {
    const FaceRow& face = delaunay_.face(slot);
    return face.v[(face.e[1] == edge ? 1U : 0U) | (face.e[2] == edge ? 2U : 0U)];
  };
  const SiteSlot left = apex(row.f[0]);
  const SiteSlot right = apex(row.f[1]);
  const Vec2 a = delaunay_.site_position(row.v[0]);
  const Vec2 b = delaunay_.site_position(row.v[1]);
  if (left == kInfiniteSite) return {delaunay_.site_position(right), b, a, {}};
  EdgeCorners corners{delaunay_.site_position(left), a, b, {}};
  if (right != kInfiniteSite) corners.s = delaunay_.site_position(right);
  return corners;
}

std::uint8_t OneStepCrust::flags_for(EdgeSlot edge, FilterCounts& counts) const {
  if (delaunay_.edge(edge).f[0] == kNoSlot) return kCrust;
  const EdgeClass result = classify_edge(corners(edge), counts);
  return static_cast<std::uint8_t>((result.is_crust ? kCrust : 0U) | (result.is_cocircular ? kCocircular : 0U));
}

void OneStepCrust::classify(EdgeSlot edge) {
  flags_[edge] = flags_for(edge, counts_);
  for (const FaceSlot face : delaunay_.edge(edge).f) {
    const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(delaunay_.face(face).index_of_edge(edge)));
    face_bits_[face] = static_cast<std::uint8_t>(is_crust(edge) ? face_bits_[face] | bit : face_bits_[face] & ~bit);
  }
}

void OneStepCrust::add_to_degree(SiteSlot site, int change) {
  odd_count_ -= is_odd(site) ? 1U : 0U;
  degree_[site] = static_cast<std::uint8_t>(degree_[site] + change);
  odd_count_ += is_odd(site) ? 1U : 0U;
}

void OneStepCrust::rebuild(JobControl& job) {
  clear_changes();
  counts_ = {};
  flags_.assign(delaunay_.edge_rows(), 0);
  face_bits_.assign(delaunay_.face_rows(), 0);
  degree_.assign(delaunay_.site_rows(), 0);
  struct Tally {
    FilterCounts filter;
    std::size_t cocircular = 0;
  };
  std::vector<Tally> tallies(chunk_count(delaunay_.edge_rows()));
  // Edges of different threads may have a site or a face in common.
  const auto add = [](std::uint8_t& sum, unsigned term) {
    std::atomic_ref(sum).fetch_add(static_cast<std::uint8_t>(term), std::memory_order_relaxed);
  };
  parallel_for(delaunay_.edge_rows(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    job.checkpoint();
    Tally own;  // not counted in place: the threads would take a cache line from each other all the time
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end)) {
      delaunay_.expect_faces_after(edge);
      const EdgeRow& row = delaunay_.edge(edge);
      if (!row.is_alive()) continue;
      flags_[edge] = flags_for(edge, own.filter);
      own.cocircular += is_cocircular(edge) ? 1U : 0U;
      if (!is_crust(edge)) continue;
      for (const SiteSlot site : row.v) add(degree_[site], 1);
      for (const FaceSlot face : row.f)
        if (face != kNoSlot)
          add(face_bits_[face], 1U << static_cast<unsigned>(delaunay_.face(face).index_of_edge(edge)));
    }
    tallies[chunk] = own;
  });
  cocircular_count_ = 0;
  for (const Tally& part : tallies) {
    counts_ += part.filter;
    cocircular_count_ += part.cocircular;
  }
  odd_count_ = 0;
  for (const SiteSlot site : degree_.rows()) odd_count_ += is_odd(site) ? 1U : 0U;
}

bool OneStepCrust::update(JobControl&) {
  flags_.resize(delaunay_.edge_rows());
  face_bits_.resize(delaunay_.face_rows());
  degree_.resize(delaunay_.site_rows());
  degrees_before_.clear();
  degree_marks_.begin(delaunay_.site_rows());
  const auto change_degree = [this](SiteSlot site, int change) {
    if (degree_marks_.insert(site)) degrees_before_.push_back({site, degree_[site]});
    add_to_degree(site, change);
  };
  const auto forget = [&](EdgeSlot edge, const EdgeRow& before) {
    cocircular_count_ -= is_cocircular(edge) ? 1U : 0U;
    if (!is_crust(edge)) return;
    change_degree(before.v[0], -1);
    change_degree(before.v[1], -1);
  };
  const ChangeSet<EdgeSlot>& edges = delaunay_.edge_changes();
  for (const EdgeSlot edge : edges.touched) {
    prefetch(flags_.address(edge));
    for (const FaceSlot face : delaunay_.edge(edge).f) {
      const SiteSlot apex = delaunay_.apex(face, edge);
      if (apex != kInfiniteSite) prefetch(delaunay_.site_positions().address(apex));
    }
  }
  for (std::size_t i = 0; i < edges.removed.size(); ++i) {
    forget(edges.removed[i], delaunay_.removed_edges_before()[i]);
    flags_[edges.removed[i]] = 0;
  }
  // A row may now be another triangle; its edges are all among the changed ones and set their bits below.
  for (const FaceSlot face : delaunay_.face_changes().removed) face_bits_[face] = 0;
  for (const FaceSlot face : delaunay_.face_changes().touched) face_bits_[face] = 0;
  for (std::size_t i = 0; i < edges.touched.size(); ++i) {
    const EdgeSlot edge = edges.touched[i];
    const EdgeRow& before = delaunay_.touched_edges_before()[i];
    const EdgeRow& now = delaunay_.edge(edge);
    const bool was_crust = is_crust(edge);
    const bool same_ends = before.v[0] == now.v[0] && before.v[1] == now.v[1];
    if (!same_ends) forget(edge, before);
    if (same_ends) cocircular_count_ -= is_cocircular(edge) ? 1U : 0U;
    classify(edge);
    cocircular_count_ += is_cocircular(edge) ? 1U : 0U;
    const int change = (is_crust(edge) ? 1 : 0) - (same_ends && was_crust ? 1 : 0);
    if (change == 0) continue;
    change_degree(now.v[0], change);
    change_degree(now.v[1], change);
  }
  site_recorder_.begin(delaunay_.site_rows());
  degree_changes_.clear();
  for (const SiteSlot site : delaunay_.site_changes().removed) site_recorder_.note(site, true);
  for (const SiteSlot site : delaunay_.site_changes().touched) site_recorder_.note(site, true);
  for (const auto& [site, before] : degrees_before_) {
    if (degree_[site] == before) continue;
    site_recorder_.note(site, true);
    if (delaunay_.is_site(site)) degree_changes_.push_back(site);
  }
  site_recorder_.finish(site_changes_, [this](SiteSlot site) { return delaunay_.is_site(site); });
  return true;
}

double OneStepCrust::confidence(EdgeSlot edge) const {
  return delaunay_.edge(edge).f[0] == kNoSlot ? 1.0 : edge_confidence(corners(edge));
}

StatList OneStepCrust::statistics() const {
  std::int64_t crust = 0;
  std::int64_t skeleton = 0;
  std::int64_t cocircular = 0;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!delaunay_.edge(edge).is_alive()) continue;
    (is_crust(edge) ? crust : skeleton) += 1;
    cocircular += is_cocircular(edge) ? 1 : 0;
  }
  std::vector<std::int64_t> histogram(4, 0);
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site)) ++histogram[static_cast<std::size_t>(std::min(degree(site), 3))];
  return {{"crust_edges", crust},
          {"skeleton_edges", skeleton},
          {"cocircular_edges", cocircular},
          {"odd_samples", static_cast<std::int64_t>(odd_count_)},
          {"degree", histogram},
          {"decided_by_static_filter", static_cast<std::int64_t>(counts_.static_filter)},
          {"decided_by_intervals", static_cast<std::int64_t>(counts_.interval)},
          {"decided_exactly", static_cast<std::int64_t>(counts_.exact)}};
}

void OneStepCrust::find(std::vector<Finding>& out) const {
  if (odd_count_ == 0) return;
  Finding& finding = out.emplace_back();
  finding.text = "samples with an odd number of curve edges: corners, noise, ends of strokes";
  finding.count = static_cast<std::int64_t>(odd_count_);
  for (const SiteSlot site : delaunay_.site_slots()) {
    if (finding.places.size() == kMostPlaces) break;
    if (delaunay_.is_site(site) && is_odd(site)) finding.places.push_back(delaunay_.site_position(site));
  }
}

}  // namespace mes
