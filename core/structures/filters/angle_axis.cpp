// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/angle_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace mes {
namespace {

/// The Voronoi edge crosses the edge of its two samples: no angle opposite is obtuse.
bool crosses(const EdgeCorners& at) {
  const double at_p = dot(at.q - at.p, at.r - at.p);
  const double at_s = dot(at.r - *at.s, at.q - *at.s);
  constexpr double kLeast = 1e-280;  // below, products may have lost their sign
  if (std::min(std::abs(at_p), std::abs(at_s)) > kLeast) return at_p > 0.0 && at_s > 0.0;
  const EdgeAngles angles = edge_angles(at);
  return angles.at_p <= 90.0 && angles.at_s <= 90.0;
}

}  // namespace

AngleAxis::AngleAxis(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels,
                     InnerBalls& balls, MedialAxis& axis)
    : AxisFilter("angle-axis", settings, delaunay, crust, labels, balls, axis, Parameter::angle_limit) {}

int AngleAxis::mode(const ComputationSettings& settings) const {
  return static_cast<int>(settings[Parameter::angle_mode]);
}

double AngleAxis::value(EdgeSlot edge) const {
  const EdgeAngles angles = edge_angles(crust_.corners(edge));
  return angle_mode() == AngleMode::mean ? angles.mean() : angles.largest();
}

double AngleAxis::end_value(EdgeSlot edge, int end) const {
  // The left face of the row is that of p.
  return edge_angles(crust_.corners(edge)).end(end == 0);
}

// The two samples that are farthest apart: for each, the ones next to the opposite of it.
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
    around.push_back({std::atan2(at.y - center.y, at.x - center.x), at});
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
  return std::atan2(0.5 * longest, height) * (180.0 / std::numbers::pi);
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

// The largest angle on an edge is 90 degrees where it crosses the edge of its two samples, so that both corners opposite
// are not obtuse; else it is at one of the ends.
bool AngleAxis::reaches(EdgeSlot edge) const {
  if (wish().limit <= 0.0) return true;
  if (angle_mode() == AngleMode::mean) return value(edge) >= wish().limit;
  const EdgeCorners at = crust_.corners(edge);
  return limit_.is_reached_at(at.p, at.q, at.r) || limit_.is_reached_at(*at.s, at.r, at.q) || crosses(at);
}

AngleAxis::Reached AngleAxis::reached(EdgeSlot edge) const {
  if (wish().limit <= 0.0) return {true, {true, true}};
  if (angle_mode() != AngleMode::clip) return {reaches(edge), {true, true}};
  // The left face of the row is that of p.
  const EdgeCorners at = crust_.corners(edge);
  const bool at_p = limit_.is_reached_at(at.p, at.q, at.r);
  const bool at_s = limit_.is_reached_at(*at.s, at.r, at.q);
  return {at_p || at_s || crosses(at), {at_p, at_s}};
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
  const FaceRow& row = delaunay_.face(node);
  const Vec2 a = delaunay_.site_position(row.v[0]);
  const Vec2 b = delaunay_.site_position(row.v[1]);
  const Vec2 c = delaunay_.site_position(row.v[2]);
  return limit_.is_reached_at(a, b, c) || limit_.is_reached_at(b, c, a) || limit_.is_reached_at(c, a, b);
}

int AngleAxis::compare(EdgeSlot a, EdgeSlot b) const {
  const double at_a = value(a);
  const double at_b = value(b);
  return at_a < at_b ? -1 : (at_b < at_a ? 1 : 0);
}

void AngleAxis::add_statistics(StatList& out) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const FaceSlot node : delaunay_.face_slots())
    if (delaunay_.face(node).is_alive() && axis_.is_node(node)) largest = std::max(largest, value(node));
  for (const EdgeSlot edge : delaunay_.edge_slots())
    if (is_edge(edge)) largest = std::max(largest, value(edge));
  out.push_back({"largest", largest});
}

}  // namespace mes
