// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/delaunay/delaunay.h"

#include <algorithm>

#include "core/base/geometry/quick_length.h"
#include "core/structures/delaunay/internal/delaunay_mirror.h"

namespace mes {
namespace {

constexpr std::size_t kFew = 16;

// Samples that are moved together lie along the curve in the order of their rows. If they were inserted into empty
// space in that order, each would take most of the Voronoi cell of the one before, which borders half a shape; in a
// random order their cells are small from the beginning. The same holds for removals.
std::vector<SampleSlot> edit_order(const std::vector<SampleSlot>& touched, const Samples& samples) {
  if (touched.size() <= kFew) return touched;
  Box2 extent;
  for (const SampleSlot sample : touched) extent.add(samples.position(sample));
  std::vector<SampleSlot> out;
  out.reserve(touched.size());
  for (const Keyed<SampleSlot>& item :
       insertion_order(touched, extent, [&samples](SampleSlot sample) { return samples.position(sample); }))
    out.push_back(item.slot);
  return out;
}

}  // namespace

Delaunay::Delaunay(Samples& samples)
    : Structure("delaunay", {&samples}),
      samples_(samples),
      mirror_(std::make_unique<Mirror<FilteredKernel>>(*this)) {}

Delaunay::~Delaunay() = default;

void Delaunay::clear_tables() {
  dimension_ = -1;
  site_count_ = 0;
  site_position_.clear();
  site_sample_.clear();
  site_face_.clear();
  free_sites_.clear();
  site_of_sample_.assign(samples_.row_count(), kNoSlot);
  next_duplicate_.assign(samples_.row_count(), kNoSlot);
  face_.clear();
  free_faces_.clear();
  edge_.clear();
  free_edges_.clear();
  line_edges_.clear();
}

void Delaunay::compute_circumcircle(FaceSlot face) {
  FaceRow& row = face_[face];
  if (row.is_infinite()) return;
  set_circumcircle(row, {site_position_[row.v[0]], site_position_[row.v[1]], site_position_[row.v[2]]});
}

double Delaunay::dual_length(EdgeSlot edge) const {
  const EdgeRow& row = edge_[edge];
  const Vec2 p = site_position_[row.v[0]];
  const Vec2 q = site_position_[row.v[1]];
  // A circumcentre lies before the edge, at half its length times the cotangent of the opposite angle.
  double cotangents = 0.0;
  for (const FaceSlot face : row.f) {
    const Vec2 apex = site_position_[face_[face].v[face_[face].index_of_edge(edge)]];
    cotangents += dot(p - apex, q - apex) / std::abs(cross(p - apex, q - apex));
  }
  const double length = 0.5 * quick_length(q - p) * std::abs(cotangents);
  // Products leave the range of doubles before distances do.
  return std::isnormal(length) ? length : distance(face_[row.f[0]].center, face_[row.f[1]].center);
}

SiteSlot Delaunay::new_site(Vec2 position) {
  SiteSlot site = site_position_.next();
  if (free_sites_.empty()) {
    site_position_.push_back(position);
    site_sample_.push_back(kNoSlot);
    site_face_.push_back(kNoSlot);
  } else {
    site = free_sites_.back();
    free_sites_.pop_back();
    site_position_[site] = position;
  }
  ++site_count_;
  return site;
}

void Delaunay::attach_sample(SampleSlot sample, SiteSlot site) {
  if (!site_of_sample_.has(sample)) {
    site_of_sample_.resize(sample.index() + std::size_t{1}, kNoSlot);
    next_duplicate_.resize(sample.index() + std::size_t{1}, kNoSlot);
  }
  site_of_sample_[sample] = site;
  next_duplicate_[sample] = site_sample_[site];
  site_sample_[site] = sample;
}

bool Delaunay::detach_sample(SampleSlot sample) {
  const SiteSlot site = site_of_sample_[sample];
  SampleSlot* link = &site_sample_[site];
  while (*link != sample) link = &next_duplicate_[*link];
  *link = next_duplicate_[sample];
  site_of_sample_[sample] = kNoSlot;
  next_duplicate_[sample] = kNoSlot;
  return site_sample_[site] == kNoSlot;
}

void Delaunay::rebuild(JobControl& job) {
  clear_changes();
  clear_tables();
  mirror_->clear();

  std::vector<SampleSlot> alive;
  alive.reserve(samples_.count());
  for (const SampleSlot sample : slots_below<SampleSlot>(samples_.row_count()))
    if (samples_.is_alive(sample)) alive.push_back(sample);
  mirror_->build(std::move(alive), job);
}

bool Delaunay::update(JobControl& job) {
  const ChangeSet<SampleSlot>& changes = samples_.changes();
  // Above some share of the sites, sorting and rebuilding is cheaper than inserting one by one.
  if (dimension_ != 2 || changes.size() > 64 + site_count_ / 8) return false;
  site_recorder_.begin(site_position_.size());
  noted_faces_.clear();
  noted_edges_.clear();
  zone_faces_ = 0;
  for (const SampleSlot sample : changes.removed)
    if (!mirror_->remove(sample) || is_too_much()) return false;
  const std::vector<SampleSlot> touched = edit_order(changes.touched, samples_);
  if (touched.size() > kFew && !mirror_->move_together(touched, job)) return false;
  std::uint64_t done = 0;
  for (const SampleSlot sample : touched) {
    if ((++done & 255U) == 0) job.checkpoint(done, changes.touched.size());
    if (is_too_much()) return false;
    const SiteSlot site = site_of_sample(sample);
    const Vec2 target = samples_.position(sample);
    if (site == kNoSlot) {
      if (!mirror_->insert(sample, target)) return false;
    } else if (site_position_[site] != target) {
      if (!mirror_->move(sample, target)) return false;
    }
  }
  site_recorder_.finish(site_changes_, [this](SiteSlot site) { return is_site(site); });
  finish_face_changes();
  finish_edge_changes();
  return true;
}

std::uint32_t Delaunay::new_mark() {
  if (++last_mark_ == 0) {
    for (FaceRow& row : face_) row.mark = 0;
    for (EdgeRow& row : edge_) row.mark = 0;
    last_mark_ = 1;
  }
  return last_mark_;
}

void Delaunay::finish_face_changes() {
  face_changes_.clear();
  const std::uint32_t seen = new_mark();
  for (const NotedFace& note : noted_faces_) {
    FaceRow& row = face_[note.face];
    if (row.mark == seen) continue;
    row.mark = seen;
    if (row.is_alive()) {
      face_changes_.touched.push_back(note.face);
    } else if (note.was_alive) {
      face_changes_.removed.push_back(note.face);
    }
  }
}

void Delaunay::finish_edge_changes() {
  edge_changes_.clear();
  touched_edges_before_.clear();
  removed_edges_before_.clear();
  const std::uint32_t seen = new_mark();
  for (const NotedEdge& note : noted_edges_) {
    EdgeRow& row = edge_[note.edge];
    if (row.mark == seen) continue;
    row.mark = seen;
    if (row.is_alive()) {
      edge_changes_.touched.push_back(note.edge);
      touched_edges_before_.push_back(note.before);
    } else if (note.before.is_alive()) {
      edge_changes_.removed.push_back(note.edge);
      removed_edges_before_.push_back(note.before);
    }
  }
}

void Delaunay::clear_changes() {
  site_changes_.clear();
  face_changes_.clear();
  edge_changes_.clear();
}

StatList Delaunay::statistics() const {
  std::int64_t faces = 0;
  std::int64_t edges = 0;
  std::int64_t hull = 0;
  for (const FaceRow& row : face_) {
    if (!row.is_alive()) continue;
    (row.is_infinite() ? hull : faces) += 1;
  }
  for (const EdgeRow& row : edge_) edges += row.is_alive() ? 1 : 0;
  return {{"vertices", static_cast<std::int64_t>(site_count_)},
          {"edges", edges},
          {"faces", faces},
          {"hull_edges", hull},
          {"duplicates", static_cast<std::int64_t>(samples_.count() - site_count_)},
          {"dimension", std::int64_t{dimension_}}};
}

}  // namespace mes
