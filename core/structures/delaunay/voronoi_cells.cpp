// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/delaunay/voronoi_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/kernel/point_predicates.h"

namespace mes {
namespace {

/// A corner of a cell: a point, or the direction in which an unbounded cell has no end.
struct CellCorner {
  Vec2 at{};
  bool is_direction = false;
  SiteSlot across{};      ///< the side to the next corner is on the bisector with this site; none: on the box
  double box_side = 0.0;  ///< of a direction along a side of the box that was cut there: the coordinate of this side
};
using CellCorners = std::vector<CellCorner>;

/// A line along the Voronoi edge of two sites. It is the same for both, to the last bit.
struct Bisector {
  Vec2 through{}, along{};
  Bisector(Vec2 a, Vec2 b) {
    if (lexicographically_less(b, a)) std::swap(a, b);
    through = {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
    along = perpendicular(b - a);
  }
};

/// A side of the box: a coordinate is at most, or at least, the limit.
struct BoxSide {
  double Vec2::*coordinate;
  double Vec2::*other;
  double limit;
  bool is_upper;

  /// Not positive on the inner side. Directions along the side are there.
  double excess(const CellCorner& corner) const {
    const double value = corner.at.*coordinate - (corner.is_direction ? 0.0 : limit);
    return is_upper ? value : -value;
  }
};

class CellClipper {
 public:
  CellClipper(const Delaunay& delaunay, SiteSlot site) : delaunay_(delaunay), site_(site) {}

  /// The part of a convex polygon on the inner side.
  CellCorners clipped(const CellCorners& corners, const BoxSide& side) const {
    CellCorners out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const CellCorner& from = corners[i];
      const CellCorner& to = corners[(i + 1) % corners.size()];
      const bool is_inside = side.excess(from) <= 0.0;
      if (is_inside) out.push_back(from);
      if (is_inside == (side.excess(to) <= 0.0)) continue;
      out.push_back(crossing(from, to, side));
      if (is_inside) out.back().across = kNoSlot;
    }
    return out;
  }

 private:
  /// Where a side of the cell crosses a side of the box.
  CellCorner crossing(const CellCorner& from, const CellCorner& to, const BoxSide& side) const {
    CellCorner out{.at = {}, .across = from.across};
    const Vec2 a = from.at;
    const Vec2 b = to.at;
    if (from.is_direction && to.is_direction) {
      if (a.*side.other == 0.0 && b.*side.other == 0.0) {
        // Opposite directions along one side of the box.
        out.at.*side.coordinate = side.limit;
        out.at.*side.other = from.box_side;
        return out;
      }
      out.is_direction = true;
      out.box_side = side.limit;
      out.at.*side.other =
          a.*side.other * std::abs(b.*side.coordinate) + b.*side.other * std::abs(a.*side.coordinate);
      return out;
    }
    for (const CellCorner& end : {from, to})
      if (end.is_direction && end.at.*side.coordinate == 0.0) return {end.at, true, from.across};
    out.at.*side.coordinate = side.limit;
    if (from.across == kNoSlot) {
      // Along another side of the box.
      out.at.*side.other = (from.is_direction ? b : a).*side.other;
      return out;
    }
    const Bisector line(delaunay_.site_position(site_), delaunay_.site_position(from.across));
    double place = line.through.*side.other + (side.limit - line.through.*side.coordinate) /
                                                  line.along.*side.coordinate * line.along.*side.other;
    // A line nearly along the side has a place that is known badly, but not beyond its ends.
    if (!from.is_direction && !to.is_direction) {
      const auto [low, high] = std::minmax(a.*side.other, b.*side.other);
      place = std::isnan(place) ? low : std::clamp(place, low, high);
    }
    out.at.*side.other = place;
    return out;
  }

  const Delaunay& delaunay_;
  SiteSlot site_;
};

/// A neighbour of the site, and the Voronoi vertex to the left of the line to it; none: it is at infinity.
struct Neighbor {
  SiteSlot site{};
  FaceSlot left{};
};

/// The corners of the whole cell, counter-clockwise.
class CellBuilder {
 public:
  CellBuilder(const Delaunay& delaunay, const Table<FaceSlot, Vec2>& vertex, SiteSlot site)
      : delaunay_(delaunay), vertex_(vertex), at_(delaunay.site_position(site)) {
    delaunay.for_each_edge_at(site, [this](EdgeSlot, SiteSlot other, FaceSlot left) {
      neighbors_.push_back({other, left});
    });
  }

  CellCorners corners() {
    if (delaunay_.dimension() < 2)
      add_parallel_lines();
    else
      for (std::size_t i = 0; i < neighbors_.size(); ++i)
        add_vertex(neighbors_[i], neighbors_[(i + 1) % neighbors_.size()]);
    return std::move(corners_);
  }

 private:
  void add_vertex(const Neighbor& from, const Neighbor& to) {
    if (is_finite(vertex_[from.left])) {
      corners_.push_back({vertex_[from.left], false, to.site});
      return;
    }
    const Vec2 a = delaunay_.site_position(from.site);
    const Vec2 b = delaunay_.site_position(to.site);
    // The centre of an obtuse triangle lies beyond its longest side.
    const bool is_face = delaunay_.is_finite_face(from.left);
    const double to_left = is_face && dot(at_ - b, a - b) < 0.0 ? -1.0 : 1.0;
    const double to_right = is_face && dot(at_ - a, b - a) < 0.0 ? -1.0 : 1.0;
    corners_.push_back({to_left * perpendicular(a - at_), true});
    turn_to(-to_right * perpendicular(b - at_), to.site);
  }

  void add_parallel_lines() {
    for (std::size_t i = 0; i < neighbors_.size(); ++i) {
      const SiteSlot other = neighbors_[i].site;
      const Vec2 at = delaunay_.site_position(other);
      const Vec2 left = perpendicular(at - at_);
      corners_.push_back({-left, true, other});
      corners_.push_back({Bisector(at_, at).through, false, other});
      corners_.push_back({left, true});
    }
    if (neighbors_.size() == 1) turn_to(corners_.front().at, corners_.front().across);
  }

  /// Adds the directions of the axes that come after the last one, counter-clockwise, and then `to`. Unbounded cells
  /// turn by half a turn at most.
  void turn_to(Vec2 to, SiteSlot across) {
    const Vec2 from = corners_.back().at;
    const bool is_half = cross(from, to) <= 0.0 && dot(from, to) < 0.0;
    const auto is_between = [&](Vec2 d) { return cross(from, d) > 0.0 && (is_half || cross(d, to) > 0.0); };
    constexpr std::array<Vec2, 4> kAxes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      if (!is_between(kAxes[i]) || is_between(kAxes[(i + 3) % 4])) continue;
      for (std::size_t k = i; is_between(kAxes[k % 4]) && k < i + 4; ++k) corners_.push_back({kAxes[k % 4], true});
      break;
    }
    corners_.push_back({to, true, across});
  }

  const Delaunay& delaunay_;
  const Table<FaceSlot, Vec2>& vertex_;
  Vec2 at_;
  std::vector<Neighbor> neighbors_;
  CellCorners corners_;
};

}  // namespace

// Circumcentres of faces on one circle are rounded differently. The lexicographically smallest stands for all.
VoronoiCells::VoronoiCells(const Delaunay& delaunay) : delaunay_(delaunay) {
  DisjointSets<FaceSlot> circles(delaunay.face_rows());
  const auto corner = [&delaunay](const FaceRow& face, int i) { return delaunay.site_position(face.v[i]); };
  for (const FaceSlot face : delaunay.face_slots()) {
    if (!delaunay.is_finite_face(face)) continue;
    const FaceRow& row = delaunay.face(face);
    for (const FaceSlot next : row.n) {
      if (next < face || !delaunay.is_finite_face(next)) continue;
      const FaceRow& other = delaunay.face(next);
      const Vec2 apex = corner(other, other.index_of_neighbour(face));
      if (side_of_circle(corner(row, 0), corner(row, 1), corner(row, 2), apex) == 0)
        circles.join(circles.root(face), circles.root(next));
    }
  }
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  vertex_.resize(delaunay.face_rows(), Vec2{kNowhere, kNowhere});
  for (const FaceSlot face : delaunay.face_slots()) {
    if (!delaunay.is_finite_face(face)) continue;
    Vec2& place = vertex_[circles.root(face)];
    if (lexicographically_less(delaunay.circumcenter(face), place)) place = delaunay.circumcenter(face);
  }
  for (const FaceSlot face : delaunay.face_slots())
    if (delaunay.is_finite_face(face)) vertex_[face] = vertex_[circles.root(face)];
}

std::vector<Vec2> VoronoiCells::cell(SiteSlot site, const Box2& box) const {
  std::vector<Vec2> out;
  if (delaunay_.dimension() < 1) {
    out = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    return out;
  }
  CellCorners corners = CellBuilder(delaunay_, vertex_, site).corners();
  const CellClipper clipper(delaunay_, site);
  for (const BoxSide& side :
       {BoxSide{&Vec2::x, &Vec2::y, box.high.x, true}, BoxSide{&Vec2::x, &Vec2::y, box.low.x, false},
        BoxSide{&Vec2::y, &Vec2::x, box.high.y, true}, BoxSide{&Vec2::y, &Vec2::x, box.low.y, false}})
    corners = clipper.clipped(corners, side);
  for (const CellCorner& corner : corners)
    if (!corner.is_direction && (out.empty() || out.back() != corner.at)) out.push_back(corner.at);
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

}  // namespace mes
