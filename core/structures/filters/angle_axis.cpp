// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/angle_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/base/geometry/angle.h"
#include "core/base/jobs/parallel.h"

namespace mes {

AngleAxis::AngleAxis(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels,
                     InnerBalls& balls, MedialAxis& axis)
    : AxisFilter("angle-axis", settings, delaunay, crust, labels, balls, axis, Parameter::angle_limit) {}

int AngleAxis::mode(const ComputationSettings& settings) const {
  return static_cast<int>(settings[Parameter::angle_mode]);
}

double AngleAxis::value(EdgeSlot edge) const {
  return angle_mode() == AngleMode::mean ? edge_angles(crust_.corners(edge)).mean() : largest(edge);
}

double AngleAxis::largest(EdgeSlot edge) const {
  return edge_angles(crust_.corners(edge)).largest();
}

double AngleAxis::end_value(EdgeSlot edge, int end) const {
  // The face to the left of the edge is that of the apex p.
  return edge_angles(crust_.corners(edge)).end(end == 0);
}

// Finds the two samples that are farthest apart: compares each with those next to the point opposite it.
double AngleAxis::group_value(FaceSlot node) const {
  const Vec2 center = delaunay_.circumcenter(node);
  std::vector<SiteSlot> sites;
  balls_.vertices().append_sites(node, sites);
  struct Place {
    double turn;
    Vec2 at;
  };
  std::vector<Place> around;
  for (const SiteSlot site : sites) {
    const Vec2 at = delaunay_.site_position(site);
    around.push_back({angle_of(at - center), at});
  }
  std::ranges::sort(around, [](const Place& a, const Place& b) {
    return a.turn != b.turn ? a.turn < b.turn : lexicographically_less(a.at, b.at);
  });
  double longest = 0.0;
  double height = 0.0;
  for (const Place& place : around) {
    const double opposite = place.turn > 0.0 ? place.turn - std::numbers::pi : place.turn + std::numbers::pi;
    const auto after = std::ranges::lower_bound(around, opposite, {}, &Place::turn) - around.begin();
    const auto count = std::ssize(around);
    for (const auto i : {(after + count - 1) % count, after % count}) {
      const Vec2 other = around[static_cast<std::size_t>(i)].at;
      const double chord = distance(place.at, other);
      if (chord <= longest) continue;
      longest = chord;
      height = distance({0.5 * place.at.x + 0.5 * other.x, 0.5 * place.at.y + 0.5 * other.y}, center);
    }
  }
  return angle_of({height, 0.5 * longest}) * (180.0 / std::numbers::pi);
}

double AngleAxis::value(FaceSlot node) const {
  double out = 0.0;
  for_each_face_of(node, [&](FaceSlot face) {
    const FaceRow& row = delaunay_.face(face);
    for (int i = 0; i < 3; ++i)
      out = std::max(out, folded(angle_at(delaunay_.site_position(row.v[i]), delaunay_.site_position(row.v[next3(i)]),
                                          delaunay_.site_position(row.v[prev3(i)]))));
  });
  return balls_.group(node) == nullptr ? out : std::max(out, group_value(node));
}

void AngleAxis::take(const Wish& wish) {
  limit_ = AngleLimit(wish.limit);
}

// The largest angle on an edge is 90 degrees if the edge crosses the segment between its two samples, that is, if
// neither opposite corner is obtuse; else it is at one of the ends.
AngleAxis::Reached AngleAxis::reached(CornerBits at_p, CornerBits at_s) const {
  const CornerBits not_cut = angle_mode() == AngleMode::clip ? CornerBits{0} : kAngleReaches;
  return {(((at_p | at_s) & kAngleReaches) | (at_p & at_s & kNotObtuse)) != 0,
          {((at_p | not_cut) & kAngleReaches) != 0, ((at_s | not_cut) & kAngleReaches) != 0}};
}

AngleAxis::Reached AngleAxis::reached(EdgeSlot edge) const {
  if (wish().limit <= 0.0) return {true, {true, true}};
  if (angle_mode() == AngleMode::mean) return {value(edge) >= wish().limit, {true, true}};
  // The face to the left of the edge is that of the apex p.
  const EdgeCorners at = crust_.corners(edge);
  return reached(limit_.corner(at.p, at.q, at.r), limit_.corner(*at.s, at.r, at.q));
}

bool AngleAxis::reaches(EdgeSlot edge) const {
  return reached(edge).anywhere;
}

// The two corners opposite an edge are in scattered rows of faces, so each face is read once and hands its corners to
// its edges.
void AngleAxis::begin_all() {
  end_all();  // a run that failed may have left them
  if (wish().limit <= 0.0 || angle_mode() == AngleMode::mean) return;
  corners_ = std::make_unique_for_overwrite<CornerBits[]>(2 * delaunay_.edge_rows());
  nodes_ = std::make_unique_for_overwrite<CornerBits[]>(delaunay_.face_rows());
  parallel_for(delaunay_.face_rows(), [this](std::size_t begin, std::size_t end, std::size_t) {
    for (const FaceSlot face : slots_between<FaceSlot>(begin, end)) {
      if (!balls_.is_ball(face)) continue;
      const FaceRow& row = delaunay_.face(face);
      const std::array<CornerBits, 3> bits = limit_.corners(
          delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]), delaunay_.site_position(row.v[2]));
      for (int i = 0; i < 3; ++i) {
        // Reading from the edge's row which of its faces this is would be a cache miss.
        const std::size_t side = face < row.n[i] ? 0 : 1;
        corners_[2 * std::size_t{row.e[i].index()} + side] = bits[static_cast<std::size_t>(i)];
      }
      nodes_[face.index()] = static_cast<CornerBits>(bits[0] | bits[1] | bits[2]);
    }
  });
}

void AngleAxis::end_all() {
  corners_.reset();
  nodes_.reset();
}

void AngleAxis::reached_each(std::span<const EdgeSlot> edges, std::span<Reached> out) const {
  if (!corners_) return AxisFilter::reached_each(edges, out);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const CornerBits* const at = &corners_[2 * std::size_t{edges[i].index()}];
    const FaceSlot* const face = delaunay_.edge(edges[i]).f;
    const std::size_t left = face[0] < face[1] ? 0 : 1;
    out[i] = reached(at[left], at[1 - left]);
  }
}

Vec2 AngleAxis::cut_place(EdgeSlot edge, int end) const {
  const EdgeRow& row = delaunay_.edge(edge);
  const Vec2 q = delaunay_.site_position(row.v[0]);
  const Vec2 r = delaunay_.site_position(row.v[1]);
  // The end lies on the side of its apex, or beyond the middle where the angle there is obtuse.
  const EdgeAngles angles = edge_angles(crust_.corners(edge));
  const bool is_left = (end == 0) == ((end == 0 ? angles.at_p : angles.at_s) <= 90.0);
  return is_left ? place_of_angle(q, r, wish().limit) : place_of_angle(r, q, wish().limit);
}

bool AngleAxis::node_reaches(FaceSlot node) const {
  if (wish().limit <= 0.0) return true;
  if (balls_.group(node) != nullptr) return value(node) >= wish().limit;
  if (nodes_) return (nodes_[node.index()] & kAngleReaches) != 0;
  const FaceRow& row = delaunay_.face(node);
  const std::array<CornerBits, 3> bits = limit_.corners(
      delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]), delaunay_.site_position(row.v[2]));
  return ((bits[0] | bits[1] | bits[2]) & kAngleReaches) != 0;
}

int AngleAxis::compare(EdgeSlot a, EdgeSlot b) const {
  const double at_a = value(a);
  const double at_b = value(b);
  return at_a < at_b ? -1 : (at_b < at_a ? 1 : 0);
}

void AngleAxis::add_statistics(StatList& out) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const FaceSlot node : delaunay_.face_slots())
    if (delaunay_.face(node).is_alive() && axis_.is_node(node)) most = std::max(most, value(node));
  for (const EdgeSlot edge : delaunay_.edge_slots())
    if (is_edge(edge)) most = std::max(most, largest(edge));
  out.push_back({"largest", most});
}

}  // namespace mes
