// SPDX-License-Identifier: GPL-3.0-or-later
// What a further sample would change in the Delaunay triangulation, the Voronoi diagram and the one-step crust.
//
// The faces that go are those whose circle has the place inside: they are one region around it, found from the face that
// the place is in. The sample would be joined to all corners of that region. A face that is the outside of a hull edge
// goes if the place is beyond the edge, or on it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/graph/explain.h"
#include "core/kernel/circumcircle.h"
#include "core/kernel/kernels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/explain_parts.h"

namespace mes {
namespace {

using Point = FastKernel::Point_2;

constexpr std::size_t kStepsBetween = 1024;  // two looks at the job

Point point(Vec2 p) {
  return {p.x, p.y};
}

/// The faces that go, and the edges around them.
class Zone {
 public:
  /// A side of the region, counter-clockwise, with the face beyond it; one end may be at infinity.
  struct Side {
    SiteSlot from;
    SiteSlot to;
    EdgeSlot edge;  // none where an end is at infinity
    FaceSlot beyond;
  };

  Zone(const Delaunay& delaunay, Vec2 at, JobControl& job);
  /// False: a sample is there already.
  bool is_free() const { return !faces_.empty(); }
  const std::set<FaceSlot>& faces() const { return faces_; }
  /// In the order around the region.
  const std::vector<Side>& sides() const { return sides_; }
  /// Between two faces that go.
  const std::vector<EdgeSlot>& inner_edges() const { return inner_; }

 private:
  CGAL::Orientation side_of(const FaceRow& row, int edge) const;
  bool goes(const FaceRow& row) const;
  std::optional<FaceSlot> locate(JobControl& job) const;
  void collect(FaceSlot first, JobControl& job);
  void sort_sides();

  const Delaunay& delaunay_;
  Vec2 at_;
  std::set<FaceSlot> faces_;
  std::vector<Side> sides_;
  std::vector<EdgeSlot> inner_;
};

// On which side of the edge opposite a corner of a finite face the place is; positive is the inside of the face.
CGAL::Orientation Zone::side_of(const FaceRow& row, int edge) const {
  return CGAL::orientation(point(delaunay_.site_position(row.v[next3(edge)])),
                           point(delaunay_.site_position(row.v[prev3(edge)])), point(at_));
}

// A face that has the place on the inner side of all its edges, or the outside of a hull edge that it is beyond; nothing
// where a sample is there. The walk through a Delaunay triangulation ends: towards the place the powers of the circles
// decrease from face to face.
std::optional<FaceSlot> Zone::locate(JobControl& job) const {
  FaceSlot face;
  for (const FaceSlot slot : delaunay_.face_slots()) {
    if (!delaunay_.is_finite_face(slot)) continue;
    face = slot;
    break;
  }
  if (face == kNoSlot) return std::nullopt;
  for (std::size_t steps = 1; !delaunay_.face(face).is_infinite(); ++steps) {
    if (steps % kStepsBetween == 0) job.checkpoint();
    const FaceRow& row = delaunay_.face(face);
    int i = 0;
    while (i < 3 && side_of(row, i) != CGAL::NEGATIVE) ++i;
    if (i == 3) break;
    face = row.n[i];
  }
  for (const SiteSlot site : delaunay_.face(face).v)
    if (site != kInfiniteSite && delaunay_.site_position(site) == at_) return std::nullopt;
  return face;
}

bool Zone::goes(const FaceRow& row) const {
  const auto at = [&](int i) { return point(delaunay_.site_position(row.v[i])); };
  if (!row.is_infinite())
    return CGAL::side_of_oriented_circle(at(0), at(1), at(2), point(at_)) == CGAL::ON_POSITIVE_SIDE;
  const int infinite = row.index_of_site(kInfiniteSite);
  const Point a = at(next3(infinite));
  const Point b = at(prev3(infinite));
  const CGAL::Orientation side = CGAL::orientation(a, b, point(at_));
  if (side != CGAL::COLLINEAR) return side == CGAL::LEFT_TURN;
  return CGAL::collinear_are_strictly_ordered_along_line(a, point(at_), b);
}

void Zone::collect(FaceSlot first, JobControl& job) {
  std::vector<FaceSlot> stack{first};
  faces_.insert(first);
  while (!stack.empty()) {
    if (faces_.size() % kStepsBetween == 0) job.checkpoint();
    const FaceRow& row = delaunay_.face(stack.back());
    stack.pop_back();
    for (const FaceSlot next : row.n)
      if (!faces_.contains(next) && goes(delaunay_.face(next))) {
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

void Zone::sort_sides() {
  // Around the region each corner, infinity included, is met once.
  std::unordered_map<SiteSlot, std::size_t> from;
  for (std::size_t i = 0; i < sides_.size(); ++i) from.emplace(sides_[i].from, i);
  std::vector<Side> sorted;
  sorted.reserve(sides_.size());
  for (std::size_t i = 0; sorted.size() < sides_.size(); i = from.at(sides_[i].to)) sorted.push_back(sides_[i]);
  sides_ = std::move(sorted);
}

Zone::Zone(const Delaunay& delaunay, Vec2 at, JobControl& job) : delaunay_(delaunay), at_(at) {
  const auto first = locate(job);
  if (!first) return;
  collect(*first, job);
  sort_sides();
}

// The Voronoi edge between the new sample and the corner after a side; of the two faces there one may be infinite.
void add_cell_edge(ProvenanceShapes& cell, const Delaunay& delaunay, Vec2 at, const Zone::Side& before,
                   const Zone::Side& after) {
  const Vec2 corner = delaunay.site_position(before.to);
  const auto center = [&](const Zone::Side& side) -> std::optional<Vec2> {
    if (side.from == kInfiniteSite || side.to == kInfiniteSite) return std::nullopt;
    return circumcircle(at, delaunay.site_position(side.from), delaunay.site_position(side.to)).center;
  };
  const auto right = center(before);
  const auto left = center(after);
  if (left && right) cell.segment(*right, *left);
  if (left && !right) cell.ray(*left, -perpendicular(corner - at));
  if (right && !left) cell.ray(*right, perpendicular(corner - at));
}

void say_curve_edges(const Delaunay& delaunay, const OneStepCrust& crust, const Zone& zone, Vec2 at,
                     Explanation& out) {
  ProvenanceShapes gone, come;
  std::size_t goes = 0, comes = 0;
  const auto position = [&](SiteSlot site) { return delaunay.site_position(site); };
  const auto apex = [&](SiteSlot site) {
    return site == kInfiniteSite ? std::nullopt : std::optional(position(site));
  };
  FilterCounts counts;
  // With the apex that is finite on the left.
  const auto is_curve = [&](Vec2 from, Vec2 to, std::optional<Vec2> left, std::optional<Vec2> right) {
    if (!left) return right && classify_edge({*right, to, from, {}}, counts).is_crust;
    return classify_edge({*left, from, to, right}, counts).is_crust;
  };
  for (const EdgeSlot edge : zone.inner_edges()) {
    if (!crust.is_crust(edge)) continue;
    gone.segment(position(delaunay.edge(edge).v[0]), position(delaunay.edge(edge).v[1]));
    ++goes;
  }
  const auto& sides = zone.sides();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Zone::Side& side = sides[i];
    const Zone::Side& after = sides[(i + 1) % sides.size()];
    if (side.to != kInfiniteSite && is_curve(at, position(side.to), apex(after.to), apex(side.from))) {
      come.segment(at, position(side.to));
      ++comes;
    }
    if (side.edge == kNoSlot) continue;
    const Vec2 from = position(side.from);
    const Vec2 to = position(side.to);
    const bool was = crust.is_crust(side.edge);
    const bool is = is_curve(from, to, at, apex(delaunay.apex(side.beyond, side.edge)));
    if (was && !is) {
      gone.segment(from, to);
      ++goes;
    }
    if (is && !was) {
      come.segment(from, to);
      ++comes;
    }
  }
  if (goes != 0)
    out.say(ProvenanceRole::origin, count_text(goes, "edge of the curve goes", "edges of the curve go"), gone, true);
  if (comes != 0)
    out.say(ProvenanceRole::product, count_text(comes, "edge of the curve comes", "edges of the curve come"), come,
            true);
}

}  // namespace

std::vector<ProvenanceLine> explain_insertion(const StructureSet& set,
                                              const std::function<bool(const Structure&)>& is_current, Vec2 at,
                                              JobControl& job) {
  Explanation out(set, is_current, job);
  const Delaunay* const delaunay = out.current<Delaunay>();
  if (delaunay == nullptr || delaunay->dimension() < 2 || !std::isfinite(at.x) || !std::isfinite(at.y)) return {};
  const Zone zone(*delaunay, at, job);
  if (!zone.is_free()) return {};
  ProvenanceShapes itself, triangles, edges;
  itself.point(at);
  const auto& sides = zone.sides();
  std::size_t neighbours = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i].to == kInfiniteSite) continue;
    add_cell_edge(itself, *delaunay, at, sides[i], sides[(i + 1) % sides.size()]);
    edges.segment(at, delaunay->site_position(sides[i].to));
    ++neighbours;
  }
  std::size_t finite = 0;
  for (const FaceSlot face : zone.faces()) {
    if (!delaunay->is_finite_face(face)) continue;
    add_triangle(triangles, *delaunay, face);
    ++finite;
  }
  out.say(ProvenanceRole::itself, "Sample at " + place_text(at) + ", with its Voronoi cell", itself);
  if (finite != 0)
    out.say(ProvenanceRole::origin, count_text(finite, "Delaunay triangle goes", "Delaunay triangles go"), triangles);
  out.say(ProvenanceRole::product, count_text(neighbours, "Delaunay edge comes", "Delaunay edges come"), edges);
  if (const OneStepCrust* const crust = out.current<OneStepCrust>())
    say_curve_edges(*delaunay, *crust, zone, at, out);
  return out.take();
}

}  // namespace mes
