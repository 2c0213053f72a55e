// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/one_step_crust.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/base/jobs/parallel.h"
#include "core/base/jobs/prefetch.h"

namespace mes {

OneStepCrust::OneStepCrust(Delaunay& delaunay) : Structure("one-step-crust", {&delaunay}), delaunay_(delaunay) {}

OneStepCrust::OneStepCrust(Delaunay& delaunay, SharedBorders& borders)
    : Structure("one-step-crust", {&delaunay, &borders}), delaunay_(delaunay), borders_(&borders) {}

EdgeCorners OneStepCrust::corners(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  // The corner follows no pattern, so it is found without a branch, which would be mispredicted every other time.
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

// Samples at one position are one site: any two of them may share the border.
std::uint8_t OneStepCrust::flags_of_contours(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  std::uint8_t out = 0;
  for (SampleSlot a = delaunay_.site_sample(row.v[0]); a != kNoSlot; a = delaunay_.next_duplicate(a))
    for (SampleSlot b = delaunay_.site_sample(row.v[1]); b != kNoSlot; b = delaunay_.next_duplicate(b)) {
      if (borders_->is_between(a, b)) return kShared;
      if (borders_->is_seam(a, b)) out = kCrust;
    }
  return out;
}

std::uint8_t OneStepCrust::flags_for(EdgeSlot edge, FilterCounts& counts) const {
  const unsigned known = has_borders() ? flags_of_contours(edge) : 0U;
  if (delaunay_.edge(edge).f[0] == kNoSlot) return static_cast<std::uint8_t>(kCrust | known);
  const EdgeClass result = classify_edge(corners(edge), counts);
  return static_cast<std::uint8_t>((result.is_crust ? kCrust : 0U) | (result.is_cocircular ? kCocircular : 0U) |
                                   known);
}

// If samples have exchanged positions, sites and edges are unchanged, but their samples are others.
bool OneStepCrust::shares_what_it_should() const {
  bool out = true;
  FilterCounts uncounted;
  for (const SampleSlot sample : borders_->samples().changes().touched)
    delaunay_.for_each_edge_at(delaunay_.site_of_sample(sample), [&](EdgeSlot edge, SiteSlot, FaceSlot) {
      out = out && flags_[edge] == flags_for(edge, uncounted);
    });
  return out;
}

void OneStepCrust::classify(EdgeSlot edge) {
  flags_[edge] = flags_for(edge, counts_);
  for (const FaceSlot face : delaunay_.edge(edge).f) {
    const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(delaunay_.face(face).index_of_edge(edge)));
    face_bits_[face] = static_cast<std::uint8_t>(is_wall(edge) ? face_bits_[face] | bit : face_bits_[face] & ~bit);
  }
}

void OneStepCrust::add_to_degrees(SiteSlot site, int crust, int shared) {
  odd_count_ -= is_odd(site) ? 1U : 0U;
  joined_count_ -= degree_[site] != 0 ? 1U : 0U;
  degree_[site] = static_cast<std::uint8_t>(degree_[site] + crust);
  joined_count_ += degree_[site] != 0 ? 1U : 0U;
  if (shared != 0) shared_degree_[site] = static_cast<std::uint8_t>(shared_degree_[site] + shared);
  odd_count_ += is_odd(site) ? 1U : 0U;
}

void OneStepCrust::rebuild(JobControl& job) {
  clear_changes();
  had_duplicates_ = has_duplicates();
  counts_ = {};
  flags_.assign(delaunay_.edge_rows(), 0);
  face_bits_.assign(delaunay_.face_rows(), 0);
  degree_.assign(delaunay_.site_rows(), 0);
  shared_degree_.assign(has_borders() ? delaunay_.site_rows() : 0, 0);
  struct Tally {
    FilterCounts filter;
    std::size_t cocircular = 0;
  };
  std::vector<Tally> tallies(chunk_count(delaunay_.edge_rows()));
  // Edges of different threads may share a site or a face.
  const auto add = [](std::uint8_t& sum, unsigned term) {
    std::atomic_ref(sum).fetch_add(static_cast<std::uint8_t>(term), std::memory_order_relaxed);
  };
  parallel_for(delaunay_.edge_rows(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    job.checkpoint();
    Tally own;  // a local count: counting in place, threads would keep taking a cache line from each other
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end)) {
      delaunay_.expect_faces_after(edge);
      const EdgeRow& row = delaunay_.edge(edge);
      if (!row.is_alive()) continue;
      flags_[edge] = flags_for(edge, own.filter);
      own.cocircular += is_cocircular(edge) ? 1U : 0U;
      if (!is_crust(edge)) continue;
      for (const SiteSlot site : row.v) add(degree_[site], 1);
      if (is_shared(edge)) {
        for (const SiteSlot site : row.v) add(shared_degree_[site], 1);
        continue;
      }
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
  joined_count_ = 0;
  for (const SiteSlot site : degree_.rows()) {
    odd_count_ += is_odd(site) ? 1U : 0U;
    joined_count_ += degree_[site] != 0 ? 1U : 0U;
  }
}

bool OneStepCrust::update(JobControl&) {
  // A sample that joins others at their position, or leaves them, may change what untouched edges share.
  const bool had_duplicates = std::exchange(had_duplicates_, has_duplicates());
  if (borders_ != nullptr && borders_->has_changed()) return false;
  if (has_borders() && (had_duplicates || had_duplicates_)) return false;
  flags_.resize(delaunay_.edge_rows());
  face_bits_.resize(delaunay_.face_rows());
  degree_.resize(delaunay_.site_rows());
  if (has_borders()) shared_degree_.resize(delaunay_.site_rows());
  degrees_before_.clear();
  degree_marks_.begin(delaunay_.site_rows());
  const auto change_degrees = [this](SiteSlot site, int crust, int shared) {
    if (degree_marks_.insert(site))
      degrees_before_.push_back({site, degree_[site], static_cast<std::uint8_t>(wall_degree(site))});
    add_to_degrees(site, crust, shared);
  };
  const auto forget = [&](EdgeSlot edge, const EdgeRow& before) {
    cocircular_count_ -= is_cocircular(edge) ? 1U : 0U;
    if (!is_crust(edge)) return;
    for (const SiteSlot site : before.v) change_degrees(site, -1, is_shared(edge) ? -1 : 0);
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
    const bool was_shared = was_crust && is_shared(edge);
    const bool same_ends = before.v[0] == now.v[0] && before.v[1] == now.v[1];
    if (!same_ends) forget(edge, before);
    if (same_ends) cocircular_count_ -= is_cocircular(edge) ? 1U : 0U;
    classify(edge);
    cocircular_count_ += is_cocircular(edge) ? 1U : 0U;
    const int crust = (is_crust(edge) ? 1 : 0) - (same_ends && was_crust ? 1 : 0);
    const int shared = (is_crust(edge) && is_shared(edge) ? 1 : 0) - (same_ends && was_shared ? 1 : 0);
    if (crust == 0 && shared == 0) continue;
    for (const SiteSlot site : now.v) change_degrees(site, crust, shared);
  }
  if (has_borders() && !shares_what_it_should()) return false;
  site_recorder_.begin(delaunay_.site_rows());
  degree_changes_.clear();
  for (const SiteSlot site : delaunay_.site_changes().removed) site_recorder_.note(site, true);
  for (const SiteSlot site : delaunay_.site_changes().touched) site_recorder_.note(site, true);
  for (const auto& [site, degree, wall_degree_before] : degrees_before_) {
    if (degree_[site] == degree && wall_degree(site) == wall_degree_before) continue;
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
  std::int64_t shared = 0;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!delaunay_.edge(edge).is_alive()) continue;
    (is_crust(edge) ? crust : skeleton) += 1;
    cocircular += is_cocircular(edge) ? 1 : 0;
    shared += is_shared(edge) ? 1 : 0;
  }
  std::vector<std::int64_t> histogram(4, 0);
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site)) ++histogram[static_cast<std::size_t>(std::min(degree(site), 3))];
  StatList out{{"crust_edges", crust},
               {"skeleton_edges", skeleton},
               {"cocircular_edges", cocircular},
               {"odd_samples", static_cast<std::int64_t>(odd_count_)},
               {"degree", histogram},
               {"decided_by_static_filter", static_cast<std::int64_t>(counts_.static_filter)},
               {"decided_by_intervals", static_cast<std::int64_t>(counts_.interval)},
               {"decided_exactly", static_cast<std::int64_t>(counts_.exact)}};
  // Nothing to report where no curve is shared.
  if (has_borders()) out.push_back({"shared_edges", shared});
  return out;
}

void OneStepCrust::find(std::vector<Finding>& out) const {
  const auto add = [&](FindingLevel level, std::string text, std::size_t count, const auto& is_meant) {
    if (count == 0) return;
    Finding& finding = out.emplace_back();
    finding.level = level;
    finding.text = std::move(text);
    finding.count = static_cast<std::int64_t>(count);
    for (const SiteSlot site : delaunay_.site_slots()) {
      if (finding.places.size() == kMostPlaces) break;
      if (delaunay_.is_site(site) && is_meant(site)) finding.places.push_back(delaunay_.site_position(site));
    }
  };
  add(FindingLevel::doubt,
      "samples with an odd number of curve edges instead of two: corners, noise, ends of strokes", odd_count_,
      [this](SiteSlot site) { return is_odd(site); });
  add(FindingLevel::note, "samples on no curve", lone_count(), [this](SiteSlot site) { return degree(site) == 0; });
}

}  // namespace mes
