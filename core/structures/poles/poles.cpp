// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/poles/poles.h"

namespace mes {
namespace {

// Calls `visit(face, right, left)` for the faces around the site, counter-clockwise; `right` and `left` are the face's
// other corners, seen from the site.
template <class Visit>
void for_each_face_at(const Delaunay& delaunay, SiteSlot site, Visit visit) {
  const FaceSlot start = delaunay.site_face(site);
  FaceSlot at = start;
  do {
    const FaceRow& row = delaunay.face(at);
    const int i = row.index_of_site(site);
    visit(at, row.v[next3(i)], row.v[prev3(i)]);
    at = row.n[next3(i)];
  } while (at != start);
}

}  // namespace

Poles::Poles(Delaunay& delaunay, VoronoiVertices& vertices)
    : Structure("poles", {&delaunay, &vertices}), delaunay_(delaunay), vertices_(vertices) {}

Poles::HullNeighbours Poles::hull_neighbours(SiteSlot site) const {
  HullNeighbours hull;
  for_each_face_at(delaunay_, site, [&hull](FaceSlot, SiteSlot right, SiteSlot left) {
    if (left == kInfiniteSite) hull.before = right;
    if (right == kInfiniteSite) hull.after = left;
  });
  return hull;
}

Poles::HullNeighbours Poles::gather_star(SiteSlot site) {
  star_.clear();
  HullNeighbours hull;
  const Vec2 p = delaunay_.site_position(site);
  for_each_face_at(delaunay_, site, [&](FaceSlot face, SiteSlot right, SiteSlot left) {
    if (left == kInfiniteSite) {
      hull.before = right;
    } else if (right == kInfiniteSite) {
      hull.after = left;
    } else {
      const StarTriangle triangle{p, delaunay_.site_position(right), delaunay_.site_position(left)};
      star_.push_back({face, triangle, radius_key(triangle)});
    }
  });
  return hull;
}

Vec2 Poles::direction_to_infinity(SiteSlot site) const {
  const HullNeighbours hull = hull_neighbours(site);
  return hull_direction(delaunay_.site_position(site), delaunay_.site_position(hull.before),
                        delaunay_.site_position(hull.after));
}

void Poles::find_poles(SiteSlot site) {
  const HullNeighbours hull = gather_star(site);
  const auto comes_before = [](const StarFace& f, const StarFace& g) {
    const int order = compare_pole_distance(f.triangle, f.key, g.triangle, g.key);
    return order != 0 ? order > 0 : compare_circumcenters(f.triangle, g.triangle) < 0;
  };
  const StarFace* plus = nullptr;
  if (hull.before == kNoSlot) {
    for (const StarFace& f : star_)
      if (plus == nullptr || comes_before(f, *plus)) plus = &f;
  }
  const auto is_opposite = [&](const StarFace& f) {
    if (plus != nullptr) return sign_of_side(f.triangle, plus->triangle) < 0;
    return sign_of_hull_side(f.triangle, delaunay_.site_position(hull.before), delaunay_.site_position(hull.after)) <
           0;
  };
  const StarFace* minus = nullptr;
  for (const StarFace& f : star_)
    if (&f != plus && is_opposite(f) && (minus == nullptr || comes_before(f, *minus))) minus = &f;
  assign(site, plus != nullptr ? vertices_.vertex(plus->face) : kInfinitePole,
         minus != nullptr ? vertices_.vertex(minus->face) : FaceSlot());
}

void Poles::use(FaceSlot pole, int change) {
  if (pole == kNoSlot || pole == kInfinitePole) return;
  uses_[pole] += static_cast<std::uint32_t>(change);
  if (is_recording_) recorder_.note(pole, true);
}

void Poles::assign(SiteSlot site, FaceSlot plus, FaceSlot minus) {
  // The slot may denote another face than before; then it is in the change set of the triangulation.
  use(plus_[site], -1);
  use(minus_[site], -1);
  plus_[site] = plus;
  minus_[site] = minus;
  use(plus, 1);
  use(minus, 1);
}

void Poles::rebuild(JobControl& job) {
  clear_changes();
  is_recording_ = false;
  plus_.assign(delaunay_.site_rows(), kNoSlot);
  minus_.assign(delaunay_.site_rows(), kNoSlot);
  uses_.assign(delaunay_.face_rows(), 0);
  if (delaunay_.dimension() < 2) return;
  for (const SiteSlot site : delaunay_.site_slots()) {
    if ((site.index() & 0x3ffU) == 0) job.checkpoint(site.index(), delaunay_.site_rows());
    if (delaunay_.is_site(site)) find_poles(site);
  }
}

bool Poles::update(JobControl&) {
  if (delaunay_.dimension() < 2) {
    if (!delaunay_.face_changes().is_empty()) return false;
    plus_.resize(delaunay_.site_rows(), kNoSlot);
    minus_.resize(delaunay_.site_rows(), kNoSlot);
    return true;
  }
  const ChangeSet<FaceSlot>& faces = vertices_.changes();
  plus_.resize(delaunay_.site_rows(), kNoSlot);
  minus_.resize(delaunay_.site_rows(), kNoSlot);
  uses_.resize(delaunay_.face_rows(), 0);
  is_recording_ = true;
  recorder_.begin(delaunay_.face_rows());
  for (const FaceSlot face : faces.removed) recorder_.note(face, true);
  site_marks_.begin(delaunay_.site_rows());
  sites_.clear();
  for (const SiteSlot site : delaunay_.site_changes().removed) assign(site, kNoSlot, kNoSlot);
  // A changed star has a new face or a face with a new slot.
  for (const FaceSlot face : faces.touched) {
    recorder_.note(face, true);
    for (const SiteSlot site : delaunay_.face(face).v)
      if (site != kInfiniteSite && site_marks_.insert(site)) sites_.push_back(site);
  }
  for (const SiteSlot site : sites_) find_poles(site);
  recorder_.finish(face_changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  return true;
}

StatList Poles::statistics() const {
  std::int64_t finite = 0;
  std::int64_t infinite = 0;
  std::int64_t missing = 0;
  std::int64_t faces = 0;
  for (const SiteSlot site : plus_.rows()) {
    if (!delaunay_.is_site(site) || plus_[site] == kNoSlot) continue;
    finite += (plus_[site] != kInfinitePole ? 1 : 0) + (minus_[site] != kNoSlot ? 1 : 0);
    infinite += plus_[site] == kInfinitePole ? 1 : 0;
    missing += minus_[site] == kNoSlot ? 1 : 0;
  }
  for (const std::uint32_t uses : uses_) faces += uses != 0 ? 1 : 0;
  return {{"finite", finite}, {"infinite", infinite}, {"without_minus", missing}, {"faces", faces}};
}

}  // namespace mes
