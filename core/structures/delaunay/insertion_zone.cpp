// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/delaunay/insertion_zone.h"

#include <unordered_map>
#include <utility>

#include "core/kernel/kernels.h"

namespace mes {
namespace {

using Point = FastKernel::Point_2;

Point point(Vec2 p) {
  return {p.x, p.y};
}

// The side of a position relative to the edge opposite a corner of a finite face; positive is inside the face.
CGAL::Orientation side_of(const Delaunay& delaunay, const FaceRow& row, int edge, Vec2 place) {
  return CGAL::orientation(point(delaunay.site_position(row.v[next3(edge)])),
                           point(delaunay.site_position(row.v[prev3(edge)])), point(place));
}

bool goes(const Delaunay& delaunay, const FaceRow& row, Vec2 place) {
  const auto at = [&](int i) { return point(delaunay.site_position(row.v[i])); };
  if (!row.is_infinite())
    return CGAL::side_of_oriented_circle(at(0), at(1), at(2), point(place)) == CGAL::ON_POSITIVE_SIDE;
  const int infinite = row.index_of_site(kInfiniteSite);
  const Point a = at(next3(infinite));
  const Point b = at(prev3(infinite));
  const CGAL::Orientation side = CGAL::orientation(a, b, point(place));
  if (side != CGAL::COLLINEAR) return side == CGAL::LEFT_TURN;
  return CGAL::collinear_are_strictly_ordered_along_line(a, point(place), b);
}

}  // namespace

// Finds a face that has the position on the inner side of all its edges, or the outside of a hull edge that the
// position is beyond; nothing if a sample is there. The walk through a Delaunay triangulation ends, since the powers of
// the circles decrease from face to face towards the position.
std::optional<FaceSlot> InsertionZone::locate(Explanation& out) const {
  FaceSlot face;
  for (const FaceSlot slot : delaunay_.face_slots()) {
    if (!delaunay_.is_finite_face(slot)) continue;
    face = slot;
    break;
  }
  if (face == kNoSlot) return std::nullopt;
  while (!delaunay_.face(face).is_infinite()) {
    out.look();
    const FaceRow& row = delaunay_.face(face);
    int i = 0;
    while (i < 3 && side_of(delaunay_, row, i, at_) != CGAL::NEGATIVE) ++i;
    if (i == 3) break;
    face = row.n[i];
  }
  for (const SiteSlot site : delaunay_.face(face).v)
    if (site != kInfiniteSite && delaunay_.site_position(site) == at_) return std::nullopt;
  return face;
}

void InsertionZone::collect(FaceSlot first, Explanation& out) {
  std::vector<FaceSlot> stack{first};
  faces_.insert(first);
  while (!stack.empty()) {
    out.look();
    const FaceRow& row = delaunay_.face(stack.back());
    stack.pop_back();
    for (const FaceSlot next : row.n)
      if (!faces_.contains(next) && goes(delaunay_, delaunay_.face(next), at_)) {
        faces_.insert(next);
        stack.push_back(next);
      }
  }
  for (const FaceSlot face : faces_) {
    const FaceRow& row = delaunay_.face(face);
    for (int i = 0; i < 3; ++i) {
      if (!faces_.contains(row.n[i]))
        sides_.push_back({row.v[next3(i)], row.v[prev3(i)], row.e[i], row.n[i]});
      else if (face < row.n[i] && row.e[i] != kNoSlot)
        inner_.push_back(row.e[i]);
    }
  }
}

void InsertionZone::sort_sides() {
  // Around the region, each corner, including infinity, occurs once.
  std::unordered_map<SiteSlot, std::size_t> from;
  for (std::size_t i = 0; i < sides_.size(); ++i) from.emplace(sides_[i].from, i);
  std::vector<Side> sorted;
  sorted.reserve(sides_.size());
  for (std::size_t i = 0; sorted.size() < sides_.size(); i = from.at(sides_[i].to)) sorted.push_back(sides_[i]);
  sides_ = std::move(sorted);
}

InsertionZone::InsertionZone(const Delaunay& delaunay, Vec2 at, Explanation& out) : delaunay_(delaunay), at_(at) {
  const auto first = locate(out);
  if (!first) return;
  collect(*first, out);
  sort_sides();
}

}  // namespace mes
