// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/certificate/axis_certificate.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/jobs/parallel.h"

namespace mes {

AxisCertificate::AxisCertificate(Delaunay& delaunay, Labels& labels, InnerBalls& balls)
    : Structure("axis-certificate", {&delaunay, &labels, &balls}),
      delaunay_(delaunay),
      labels_(labels),
      balls_(balls) {}

FaceSlot AxisCertificate::inner_face(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  return labels_.is_inside(row.f[0]) ? row.f[0] : row.f[1];
}

Corners AxisCertificate::corners_of(FaceSlot face) const {
  const FaceRow& row = delaunay_.face(face);
  return {delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]), delaunay_.site_position(row.v[2])};
}

Corners AxisCertificate::corners_beside(EdgeSlot edge) const {
  const FaceRow& row = delaunay_.face(inner_face(edge));
  const int i = row.index_of_edge(edge);
  return {delaunay_.site_position(row.v[i]), delaunay_.site_position(row.v[next3(i)]),
          delaunay_.site_position(row.v[prev3(i)])};
}

Box2 AxisCertificate::box_of_cap(EdgeSlot edge) const {
  constexpr double kRounding = 0x1p-46;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const auto [s, p, q] = corners_beside(edge);
  const Vec2 a = p - s;
  const Vec2 b = q - s;
  const Vec2 chord = q - p;
  const double half = 0.5 * length(chord);
  // With the angle at s, the cap is half * tan(angle / 2) high. If the angle is surely acute, the cap is as wide as the
  // chord, otherwise at most as wide as the circle.
  const double sides = length(a) * length(b);
  const double cosine = dot(a, b);
  const double sine = std::abs(cross(a, b));
  const double error = kRounding * sides;
  if (!(sides + cosine > 2.0 * error) || !(sine > 2.0 * error)) return {{-kFar, -kFar}, {kFar, kFar}};
  const double high = half * ((sine + error) / (sides + cosine - 2.0 * error));
  const double wide = cosine > error ? half : half * (sides / (sine - error));
  const Vec2 middle = 0.5 * p + 0.5 * q;
  const Vec2 along = (wide / half / 2.0) * chord;
  const Vec2 beyond = (high / half / 2.0) * Vec2{chord.y, -chord.x};
  const double margin = kRounding * (wide + high);
  const auto low = [&](double at, double to_side, double out) {
    const double value = at - std::abs(to_side) + std::min(0.0, out);
    return value - margin - kRounding * std::abs(at);
  };
  return {{low(middle.x, along.x, beyond.x), low(middle.y, along.y, beyond.y)},
          {-low(-middle.x, along.x, -beyond.x), -low(-middle.y, along.y, -beyond.y)}};
}

AxisCertificate::Cap AxisCertificate::cap_of(EdgeSlot edge) const {
  const auto below = [](double x) {
    constexpr double kMost = std::numeric_limits<float>::max();
    constexpr float kFar = std::numeric_limits<float>::infinity();
    if (!(x > -kMost)) return -kFar;
    return std::nextafter(static_cast<float>(std::min(x, kMost)), -kFar);
  };
  const Box2 box = box_of_cap(edge);
  return {edge, inner_face(edge), below(box.low.x), below(box.low.y), -below(-box.high.x), -below(-box.high.y)};
}

AxisCertificate::Verdict AxisCertificate::verdict_on_arc(EdgeSlot edge) const {
  // An arc near more caps than this stays uncertified; no dense sample comes near this bound.
  constexpr std::size_t kMostLookedAt = 16'384;
  const auto [s, p, q] = corners_beside(edge);
  const OuterArc arc{s, p, q};
  const ArcFilter filter(arc);
  const FaceSlot own_ball = balls_.ball(inner_face(edge));
  const Box2 box = box_of_cap(edge);
  std::size_t looked_at = 0;
  Verdict out;
  const auto may_hold = [&](const Box2& other, double) { return out.flag == 0 && overlap(other, box); };
  const auto look_at = [&](const Cap& cap) {
    if (out.flag != 0 || cap.edge == edge || !overlap(cap.box(), box)) return;
    if (++looked_at > kMostLookedAt) {
      out.flag = kTooLong;
      return;
    }
    const Corners corners = corners_of(cap.face);
    if (filter.misses(corners) || balls_.ball(cap.face) == own_ball) return;
    if (meets_arc(arc, corners)) out = {kBad, cap.edge};
  };
  doubtful_caps_.visit_where(may_hold, look_at);
  if ((edge_[edge] & kDoubtful) != 0) crust_caps_.visit_where(may_hold, look_at);
  return out;
}

void AxisCertificate::take(EdgeSlot edge, const Verdict& verdict) {
  edge_[edge] |= verdict.flag;
  too_long_edges_ += verdict.flag == kTooLong ? 1 : 0;
  if (verdict.flag != kBad) return;
  ++bad_edges_;
  met_by_[edge] = verdict.met;
  meets_.emplace(verdict.met, edge);
}

void AxisCertificate::forget_verdict(EdgeSlot edge) {
  if ((edge_[edge] & kTooLong) != 0) --too_long_edges_;
  if ((edge_[edge] & kBad) != 0) {
    --bad_edges_;
    const auto found = met_by_.find(edge);
    meets_.erase({found->second, edge});
    met_by_.erase(found);
  }
  edge_[edge] &= static_cast<std::uint8_t>(~(kBad | kTooLong));
}

void AxisCertificate::forget_searches() {
  is_searched_ = false;
  for (CapTree* caps : {&crust_caps_, &doubtful_caps_}) caps->clear();
  place_.clear();
  met_by_.clear();
  meets_.clear();
  if (too_long_edges_ == 0 && bad_edges_ == 0) return;
  for (std::uint8_t& edge : edge_) edge &= static_cast<std::uint8_t>(~(kBad | kTooLong));
  bad_edges_ = too_long_edges_ = 0;
}

void AxisCertificate::build_caps(CapTree& caps, std::uint8_t flags) {
  std::vector<Cap> all;
  for (const EdgeSlot edge : edge_.rows())
    if ((edge_[edge] & (kBorder | kDoubtful)) == flags) all.push_back({.edge = edge});
  parallel_for(all.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) all[i] = cap_of(all[i].edge);
  });
  caps.build(std::span<const Cap>(all), bounds_of, take_place());
}

void AxisCertificate::search_all(JobControl& job) {
  forget_searches();
  constexpr std::size_t kPiece = 128;
  const std::size_t rows = delaunay_.edge_rows();
  place_.assign(rows, 0);
  build_caps(crust_caps_, kBorder);
  build_caps(doubtful_caps_, kBorder | kDoubtful);
  if (doubtful_edges_ != 0) {
    const std::size_t pieces = (rows + kPiece - 1) / kPiece;
    std::vector<std::vector<std::pair<EdgeSlot, Verdict>>> found(pieces);
    std::atomic<std::size_t> next_piece = 0;
    run_tasks(std::min(worker_count(), pieces), [&](std::size_t) {
      for (std::size_t piece = next_piece++; piece < pieces; piece = next_piece++) {
        job.checkpoint(piece, pieces);
        for (const EdgeSlot edge : slots_between<EdgeSlot>(piece * kPiece, std::min(rows, (piece + 1) * kPiece))) {
          if ((edge_[edge] & kBorder) == 0) continue;
          if (const Verdict verdict = verdict_on_arc(edge); verdict.flag != 0)
            found[piece].emplace_back(edge, verdict);
        }
      }
    });
    for (const auto& piece : found)
      for (const auto& [edge, verdict] : piece) take(edge, verdict);
  }
  is_searched_ = true;
}

void AxisCertificate::forget_edge(EdgeSlot edge) {
  if ((edge_[edge] & kBorder) == 0) return;
  forget_verdict(edge);
  --border_edges_;
  if ((edge_[edge] & kDoubtful) != 0) --doubtful_edges_;
  if (is_searched_) caps_of(edge).remove(place_[edge], take_place());
  edge_[edge] = 0;
}

void AxisCertificate::judge_edge(EdgeSlot edge) {
  if (!delaunay_.edge(edge).is_alive() || !is_border(edge)) return;
  edge_[edge] = kBorder;
  ++border_edges_;
  if (labels_.is_conflict(edge)) {
    edge_[edge] |= kDoubtful;
    ++doubtful_edges_;
  }
  if (is_searched_) caps_of(edge).insert(cap_of(edge), bounds_of, take_place());
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
  const auto note_site = [&](SiteSlot site) {
    if (site == kInfiniteSite || !judged_sites_.insert(site)) return;
    judge_site(site);
    site_recorder_.note(site, true);
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) {
      if (is_border(edge) || edge_[edge] != 0) note_edge(edge);
    });
  };
  const auto note_face = [&](FaceSlot face) {
    for (const SiteSlot site : delaunay_.face(face).v) note_site(site);
  };
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
  // An arc near too many caps may be near fewer now; nothing records which arcs a removed cap was near.
  if (too_long_edges_ != 0 && !edges.empty()) return false;
  const std::size_t changed = edges.size();
  if (is_searched_) {
    place_.resize(delaunay_.edge_rows(), 0);
    for (std::size_t i = 0; i < changed; ++i)
      for (auto met = meets_.lower_bound({edges[i], EdgeSlot(0)}); met != meets_.end() && met->first == edges[i];
           ++met)
        note_edge(met->second);
  }
  for (std::size_t i = 0; i < changed; ++i) forget_edge(edges[i]);
  for (std::size_t i = 0; i < changed; ++i) judge_edge(edges[i]);
  // If searches have become necessary.
  if (doubtful_edges_ != 0 && !is_searched_) return false;
  if (is_searched_) {
    for (std::size_t i = 0; i < changed; ++i) {
      if ((edge_[edges[i]] & kBorder) == 0) continue;
      const Box2 box = box_of_cap(edges[i]);
      const auto note_near = [&](CapTree& caps) {
        caps.visit_where([&box](const Box2& other, double) { return overlap(other, box); },
                         [&](const Cap& cap) {
                           if (overlap(cap.box(), box)) note_edge(cap.edge);
                         });
      };
      note_near(doubtful_caps_);
      if ((edge_[edges[i]] & kDoubtful) != 0) note_near(crust_caps_);
    }
    for (const EdgeSlot edge : edges) {
      forget_verdict(edge);
      if ((edge_[edge] & kBorder) != 0) take(edge, verdict_on_arc(edge));
    }
    if (crust_caps_.is_worn()) build_caps(crust_caps_, kBorder);
    if (doubtful_caps_.is_worn()) build_caps(doubtful_caps_, kBorder | kDoubtful);
  }
  for (const EdgeSlot edge : edges) edge_recorder_.note(edge, true);
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
    finding.text = "curve edges that another inner ball protrudes beyond: too few samples there";
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
    finding.text = "samples inside the shape, on shared borders, or where its border meets itself";
    finding.count = static_cast<std::int64_t>(bad_sites_);
    for (const SiteSlot site : bad_site_.rows()) {
      if (finding.places.size() == kMostPlaces) break;
      if (is_bad_site(site)) finding.places.push_back(delaunay_.site_position(site));
    }
  }
}

}  // namespace mes
