// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/certificate/axis_certificate.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/base/jobs/parallel.h"

namespace mes {

AxisCertificate::AxisCertificate(Delaunay& delaunay, Labels& labels, InnerBalls& balls)
    : Structure("axis-certificate", {&delaunay, &labels, &balls}),
      delaunay_(delaunay),
      labels_(labels),
      balls_(balls) {}

Corners AxisCertificate::corners_of(FaceSlot face) const {
  const FaceRow& row = delaunay_.face(face);
  return {delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]), delaunay_.site_position(row.v[2])};
}

std::uint8_t AxisCertificate::verdict_on_arc(EdgeSlot edge, Search& search) const {
  // An arc with more faces than this stays uncertified; no dense sample comes near this bound.
  constexpr std::size_t kMostFaces = 4096;
  const EdgeRow& row = delaunay_.edge(edge);
  const FaceSlot inner = labels_.is_inside(row.f[0]) ? row.f[0] : row.f[1];
  const FaceSlot outer = row.f[0] == inner ? row.f[1] : row.f[0];
  const FaceRow& own = delaunay_.face(inner);
  const int i = own.index_of_edge(edge);
  const SiteSlot p = own.v[next3(i)];
  const SiteSlot q = own.v[prev3(i)];
  const OuterArc arc{delaunay_.site_position(own.v[i]), delaunay_.site_position(p), delaunay_.site_position(q)};
  const ArcFilter filter(arc);
  const FaceSlot own_ball = balls_.ball(inner);
  const bool is_crust = (edge_[edge] & kDoubtful) == 0;

  auto& [seen, queue, far] = search;
  seen.begin(delaunay_.face_rows());
  seen.insert(inner);
  seen.insert(outer);
  queue.assign(1, outer);
  far.clear();
  for (std::size_t next = 0; next < queue.size(); ++next) {
    if (queue.size() > kMostFaces) return kTooLong;
    const FaceSlot face = queue[next];
    const FaceRow& at = delaunay_.face(face);
    const auto touches = [&at](SiteSlot site) { return at.v[0] == site || at.v[1] == site || at.v[2] == site; };
    if (!forgoes_updates() && !touches(p) && !touches(q)) far.push_back(face);
    for (int side = 0; side < 3; ++side) {
      const FaceSlot other = at.n[side];
      if (!seen.insert(other)) continue;
      if (labels_.is_inside(other)) {
        // A ball on the arc of a crust edge can also be reached across a border edge that is no crust edge.
        if (is_crust && !labels_.is_conflict(at.e[side])) {
          seen.erase(other);
          continue;
        }
        if (balls_.ball(other) == own_ball) continue;
        const Corners corners = corners_of(other);
        if (!filter.misses(corners) && meets_arc(arc, corners)) return kBad;
      } else if (delaunay_.face(other).is_infinite()) {
        const FaceRow& row_of_other = delaunay_.face(other);
        const int at_infinity = row_of_other.index_of_site(kInfiniteSite);
        if (meets_arc_quickly(arc, delaunay_.site_position(row_of_other.v[next3(at_infinity)]),
                              delaunay_.site_position(row_of_other.v[prev3(at_infinity)])) != Meets::no)
          queue.push_back(other);
      } else {
        const Corners corners = corners_of(other);
        if (!filter.misses(corners) && meets_arc_quickly(arc, corners) != Meets::no) queue.push_back(other);
      }
    }
  }
  return 0;
}

void AxisCertificate::search(EdgeSlot edge) {
  const std::uint8_t verdict = verdict_on_arc(edge, search_);
  edge_[edge] |= verdict;
  bad_edges_ += verdict == kBad ? 1 : 0;
  too_long_edges_ += verdict == kTooLong ? 1 : 0;
  for (const FaceSlot face : search_.far) watch(edge, face);
}

void AxisCertificate::forget_searches() {
  is_searched_ = false;
  watches_.clear();
  free_watches_.clear();
  watches_of_edge_.clear();
  first_watch_.clear();
  if (too_long_edges_ == 0 && bad_edges_ == 0) return;
  for (std::uint8_t& edge : edge_) edge &= static_cast<std::uint8_t>(~(kBad | kTooLong));
  bad_edges_ = too_long_edges_ = 0;
}

void AxisCertificate::search_all(JobControl& job) {
  forget_searches();
  constexpr std::size_t kPiece = 128;
  const std::size_t rows = delaunay_.edge_rows();
  const std::size_t pieces = (rows + kPiece - 1) / kPiece;
  std::vector<std::vector<std::pair<EdgeSlot, FaceSlot>>> watched(pieces);
  std::atomic<std::size_t> next_piece = 0;
  std::atomic<std::size_t> bad = 0;
  std::atomic<std::size_t> too_long = 0;
  run_tasks(std::min(worker_count(), pieces), [&](std::size_t) {
    Search search;
    for (std::size_t piece = next_piece++; piece < pieces; piece = next_piece++) {
      job.checkpoint(piece, pieces);
      for (const EdgeSlot edge : slots_between<EdgeSlot>(piece * kPiece, std::min(rows, (piece + 1) * kPiece))) {
        if ((edge_[edge] & kBorder) == 0) continue;
        const std::uint8_t verdict = verdict_on_arc(edge, search);
        edge_[edge] |= verdict;
        bad += verdict == kBad ? 1U : 0U;
        too_long += verdict == kTooLong ? 1U : 0U;
        for (const FaceSlot face : search.far) watched[piece].emplace_back(edge, face);
      }
    }
  });
  bad_edges_ = bad;
  too_long_edges_ = too_long;
  for (const auto& of_piece : watched)
    for (const auto& [edge, face] : of_piece) watch(edge, face);
  is_searched_ = true;
}

void AxisCertificate::forget_edge(EdgeSlot edge) {
  const std::uint8_t known = edge_[edge];
  border_edges_ -= (known & kBorder) != 0 ? 1 : 0;
  doubtful_edges_ -= (known & kDoubtful) != 0 ? 1 : 0;
  bad_edges_ -= (known & kBad) != 0 ? 1 : 0;
  too_long_edges_ -= (known & kTooLong) != 0 ? 1 : 0;
  edge_[edge] = 0;
  const auto found = watches_of_edge_.find(edge);
  if (found == watches_of_edge_.end()) return;
  for (const WatchSlot slot : found->second) {
    const Watch& left = watches_[slot];
    if (left.after != kNoSlot) watches_[left.after].before = left.before;
    if (left.before != kNoSlot)
      watches_[left.before].after = left.after;
    else if (left.after != kNoSlot)
      first_watch_[left.face] = left.after;
    else
      first_watch_.erase(left.face);
    free_watches_.push_back(slot);
  }
  watches_of_edge_.erase(found);
}

void AxisCertificate::watch(EdgeSlot edge, FaceSlot face) {
  WatchSlot slot = watches_.next();
  if (free_watches_.empty()) {
    watches_.emplace_back();
  } else {
    slot = free_watches_.back();
    free_watches_.pop_back();
  }
  WatchSlot& first = first_watch_[face];
  watches_[slot] = {edge, face, kNoSlot, first};
  if (first != kNoSlot) watches_[first].before = slot;
  first = slot;
  watches_of_edge_[edge].push_back(slot);
}

void AxisCertificate::judge_edge(EdgeSlot edge) {
  if (!delaunay_.edge(edge).is_alive() || !is_border(edge)) return;
  edge_[edge] = kBorder;
  ++border_edges_;
  if (labels_.is_conflict(edge)) {
    edge_[edge] |= kDoubtful;
    ++doubtful_edges_;
  }
  if (is_searched_) search(edge);
}

void AxisCertificate::judge_site(SiteSlot site) {
  if (bad_site_[site] != 0) --bad_sites_;
  bad_site_[site] = 0;
  if (!delaunay_.is_site(site) || delaunay_.dimension() < 2) return;
  int borders = 0;
  bool is_touched = false;
  delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot face) {
    borders += is_border(edge) ? 1 : 0;
    is_touched = is_touched || labels_.is_inside(face);
  });
  if (!is_touched || borders == 2) return;
  bad_site_[site] = 1;
  ++bad_sites_;
}

void AxisCertificate::rebuild(JobControl& job) {
  clear_changes();
  border_edges_ = bad_edges_ = doubtful_edges_ = too_long_edges_ = bad_sites_ = 0;
  edge_.assign(delaunay_.edge_rows(), 0);
  bad_site_.assign(delaunay_.site_rows(), 0);
  forget_searches();
  if (delaunay_.dimension() < 2) return;
  find_borders();
  if (doubtful_edges_ != 0) search_all(job);
}

void AxisCertificate::get_ready_to_update(JobControl& job) {
  if (!is_searched_ && delaunay_.dimension() == 2) search_all(job);
}

// Does the work of `judge_edge` and `judge_site` for all rows in one walk along the edges.
void AxisCertificate::find_borders() {
  // For each site, the number of border edges, up to three, and whether an inner ball touches it.
  constexpr std::uint8_t kMany = 3;
  constexpr std::uint8_t kTouched = 4;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (!row.is_alive()) continue;
    const bool left = labels_.is_inside(row.f[0]);
    const bool right = labels_.is_inside(row.f[1]);
    if (!left && !right) continue;
    if (left != right) {
      const bool is_doubtful = labels_.is_conflict(edge);
      edge_[edge] = is_doubtful ? kBorder | kDoubtful : kBorder;
      ++border_edges_;
      doubtful_edges_ += is_doubtful ? 1 : 0;
    }
    for (const SiteSlot site : row.v) {
      std::uint8_t& seen = bad_site_[site];
      if (left != right && (seen & kMany) != kMany) ++seen;
      seen |= kTouched;
    }
  }
  for (std::uint8_t& site : bad_site_) {
    site = (site & kTouched) != 0 && (site & kMany) != 2 ? 1 : 0;
    bad_sites_ += site;
  }
}

bool AxisCertificate::update(JobControl& job) {
  const bool was_doubtful = doubtful_edges_ != 0;
  edge_.resize(delaunay_.edge_rows(), 0);
  bad_site_.resize(delaunay_.site_rows(), 0);
  edge_recorder_.begin(delaunay_.edge_rows());
  site_recorder_.begin(delaunay_.site_rows());
  judged_sites_.begin(delaunay_.site_rows());
  judged_edges_.begin(delaunay_.edge_rows());
  std::vector<EdgeSlot> edges;
  const auto note_edge = [&](EdgeSlot edge) {
    if (judged_edges_.insert(edge)) edges.push_back(edge);
  };
  const auto note_watchers = [&](FaceSlot face) {
    if (first_watch_.empty()) return;
    const auto found = first_watch_.find(face);
    if (found == first_watch_.end()) return;
    for (WatchSlot at = found->second; at != kNoSlot; at = watches_[at].after) note_edge(watches_[at].edge);
  };
  const auto note_site = [&](SiteSlot site) {
    if (site == kInfiniteSite || !judged_sites_.insert(site)) return;
    judge_site(site);
    site_recorder_.note(site, true);
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) {
      if (is_border(edge) || edge_[edge] != 0) note_edge(edge);
    });
  };
  const auto note_face = [&](FaceSlot face) {
    note_watchers(face);
    for (const SiteSlot site : delaunay_.face(face).v) note_site(site);
  };
  // Removed faces need no note. A search reached such a face through a chain of neighbours that begins beside its edge.
  // Take the first face in the chain that was removed or changed. The face before it has a changed neighbour now, and
  // is watched or at an end of the edge. If none is before it, it was beside the edge, where a changed face is now.
  const auto note_around = [&](const ChangeSet<FaceSlot>& faces) {
    for (const FaceSlot face : faces.touched) {
      note_face(face);
      for (const FaceSlot other : delaunay_.face(face).n) note_face(other);
    }
  };
  note_around(labels_.face_changes());
  // Groups of equal balls change with these.
  note_around(balls_.changes());
  for (const SiteSlot site : delaunay_.site_changes().removed) {
    if (bad_site_[site] != 0) --bad_sites_;
    bad_site_[site] = 0;
    site_recorder_.note(site, true);
  }
  for (const EdgeSlot edge : labels_.edge_changes().removed) note_edge(edge);
  for (const EdgeSlot edge : labels_.edge_changes().touched)
    if (edge_[edge] != 0 || is_border(edge)) note_edge(edge);
  job.checkpoint();
  for (const EdgeSlot edge : edges) {
    forget_edge(edge);
    judge_edge(edge);
    edge_recorder_.note(edge, true);
  }
  // Rebuild if searches have become necessary, or if the verdict on arcs that are too long changes.
  const bool is_doubtful = doubtful_edges_ != 0;
  if (is_doubtful && !is_searched_) return false;
  if (is_doubtful != was_doubtful && too_long_edges_ != 0) return false;
  edge_recorder_.finish(edge_changes_, [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  site_recorder_.finish(site_changes_, [this](SiteSlot site) { return delaunay_.is_site(site); });
  return true;
}

StatList AxisCertificate::statistics() const {
  return {{"certified", std::int64_t{is_certified() ? 1 : 0}},
          {"border_edges", static_cast<std::int64_t>(border_edges_)},
          {"arcs_met", static_cast<std::int64_t>(bad_edge_count())},
          {"samples_not_on_one_border", static_cast<std::int64_t>(bad_sites_)}};
}

void AxisCertificate::find(std::vector<Finding>& out) const {
  if (bad_edge_count() != 0) {
    Finding& finding = out.emplace_back();
    finding.text = "curve edges beyond which another inner ball shows: the sample is not dense enough there";
    finding.count = static_cast<std::int64_t>(bad_edge_count());
    for (const EdgeSlot edge : edge_.rows()) {
      if (finding.places.size() == kMostPlaces) break;
      if (!is_bad_edge(edge)) continue;
      const EdgeRow& row = delaunay_.edge(edge);
      finding.places.push_back(0.5 * (delaunay_.site_position(row.v[0]) + delaunay_.site_position(row.v[1])));
    }
  }
  if (bad_sites_ != 0) {
    Finding& finding = out.emplace_back();
    finding.text = "samples inside the shape, on borders that regions share, or where its border meets itself";
    finding.count = static_cast<std::int64_t>(bad_sites_);
    for (const SiteSlot site : bad_site_.rows()) {
      if (finding.places.size() == kMostPlaces) break;
      if (is_bad_site(site)) finding.places.push_back(delaunay_.site_position(site));
    }
  }
}

}  // namespace mes
