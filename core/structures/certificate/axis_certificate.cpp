// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/certificate/axis_certificate.h"

#include <algorithm>

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

bool AxisCertificate::is_arc_free(EdgeSlot edge) {
  // More faces than this on one arc make it uncertified; a bound that no dense sample comes near.
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

  seen_.begin(delaunay_.face_rows());
  seen_.insert(inner);
  seen_.insert(outer);
  queue_.assign(1, outer);
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    if (queue_.size() > kMostFaces) return false;
    const FaceSlot face = queue_[next];
    const FaceRow& at = delaunay_.face(face);
    const auto touches = [&at](SiteSlot site) { return at.v[0] == site || at.v[1] == site || at.v[2] == site; };
    if (!forgoes_updates() && !touches(p) && !touches(q)) {
      far_faces_[edge].push_back(face);
      watchers_[face].push_back(edge);
    }
    for (const FaceSlot other : at.n) {
      if (!seen_.insert(other)) continue;
      if (labels_.is_inside(other)) {
        if (balls_.ball(other) == own_ball) continue;
        const Corners corners = corners_of(other);
        if (!filter.misses(corners) && meets_arc(arc, corners)) return false;
      } else if (delaunay_.face(other).is_infinite()) {
        const FaceRow& row_of_other = delaunay_.face(other);
        const int far = row_of_other.index_of_site(kInfiniteSite);
        if (meets_arc_quickly(arc, delaunay_.site_position(row_of_other.v[next3(far)]),
                              delaunay_.site_position(row_of_other.v[prev3(far)])) != Meets::no)
          queue_.push_back(other);
      } else {
        const Corners corners = corners_of(other);
        if (!filter.misses(corners) && meets_arc_quickly(arc, corners) != Meets::no) queue_.push_back(other);
      }
    }
  }
  return true;
}

void AxisCertificate::forget_edge(EdgeSlot edge) {
  if ((edge_[edge] & kBorder) != 0) --border_edges_;
  if ((edge_[edge] & kBad) != 0) --bad_edges_;
  edge_[edge] = 0;
  const auto far = far_faces_.find(edge);
  if (far == far_faces_.end()) return;
  for (const FaceSlot face : far->second) {
    const auto watch = watchers_.find(face);
    if (watch == watchers_.end()) continue;
    std::erase(watch->second, edge);
    if (watch->second.empty()) watchers_.erase(watch);
  }
  far_faces_.erase(far);
}

void AxisCertificate::judge_edge(EdgeSlot edge) {
  if (!delaunay_.edge(edge).is_alive() || !is_border(edge)) return;
  edge_[edge] = kBorder;
  ++border_edges_;
  if (is_arc_free(edge)) return;
  edge_[edge] |= kBad;
  ++bad_edges_;
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
  far_faces_.clear();
  watchers_.clear();
  border_edges_ = bad_edges_ = bad_sites_ = 0;
  edge_.assign(delaunay_.edge_rows(), 0);
  bad_site_.assign(delaunay_.site_rows(), 0);
  if (delaunay_.dimension() < 2) return;
  judge_all_sites();
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if ((edge.index() & 0x3ffU) == 0) job.checkpoint(edge.index(), delaunay_.edge_rows());
    judge_edge(edge);
  }
}

// As `judge_site` for each, from one walk along the edges.
void AxisCertificate::judge_all_sites() {
  // How many border edges there are, up to three; and whether an inner ball touches it.
  constexpr std::uint8_t kMany = 3;
  constexpr std::uint8_t kTouched = 4;
  for (const EdgeRow& row : delaunay_.edges()) {
    if (!row.is_alive()) continue;
    const bool left = labels_.is_inside(row.f[0]);
    const bool right = labels_.is_inside(row.f[1]);
    if (!left && !right) continue;
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
    if (watchers_.empty()) return;
    const auto found = watchers_.find(face);
    if (found == watchers_.end()) return;
    for (const EdgeSlot edge : found->second) note_edge(edge);
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
  // Faces that went need no note. A search came to such a face through a chain of neighbours that begins beside its
  // edge. Of the first face in the chain that went or changed, the one before it has a changed neighbour now, and is
  // watched or at an end of the edge; or it is the face beside the edge, and that one's place is taken by a changed face.
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
  edge_recorder_.finish(edge_changes_, [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  site_recorder_.finish(site_changes_, [this](SiteSlot site) { return delaunay_.is_site(site); });
  return true;
}

StatList AxisCertificate::statistics() const {
  return {{"certified", std::int64_t{is_certified() ? 1 : 0}},
          {"border_edges", static_cast<std::int64_t>(border_edges_)},
          {"arcs_met", static_cast<std::int64_t>(bad_edges_)},
          {"samples_not_on_one_border", static_cast<std::int64_t>(bad_sites_)}};
}

void AxisCertificate::find(std::vector<Finding>& out) const {
  if (bad_edges_ != 0) {
    Finding& finding = out.emplace_back();
    finding.text = "curve edges beyond which another inner ball shows: the sample is not dense enough there";
    finding.count = static_cast<std::int64_t>(bad_edges_);
    for (const EdgeSlot edge : edge_.rows()) {
      if (finding.places.size() == kMostPlaces) break;
      if (!is_bad_edge(edge)) continue;
      const EdgeRow& row = delaunay_.edge(edge);
      finding.places.push_back(0.5 * (delaunay_.site_position(row.v[0]) + delaunay_.site_position(row.v[1])));
    }
  }
  if (bad_sites_ != 0) {
    Finding& finding = out.emplace_back();
    finding.text = "samples inside the shape or where its border meets itself";
    finding.count = static_cast<std::int64_t>(bad_sites_);
    for (const SiteSlot site : bad_site_.rows()) {
      if (finding.places.size() == kMostPlaces) break;
      if (is_bad_site(site)) finding.places.push_back(delaunay_.site_position(site));
    }
  }
}

}  // namespace mes
