// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/lambda_axis.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/kernel/edge_predicates.h"
#include "core/kernel/enclosing_circle.h"

namespace mes {

LambdaAxis::LambdaAxis(SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels,
                       InnerBalls& balls, MedialAxis& axis)
    : AxisFilter("lambda-axis", settings, delaunay, crust, labels, balls, axis, Parameter::lambda_limit) {}

std::array<Vec2, 3> LambdaAxis::corners(FaceSlot face) const {
  const FaceRow& row = delaunay_.face(face);
  return {delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]), delaunay_.site_position(row.v[2])};
}

double LambdaAxis::value(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  return 0.5 * distance(delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]));
}

// The triangles of a node cover the polygon of its samples. If the centre lies in it, it lies in one of them, which is
// not obtuse; else all are obtuse, and the longest of their sides is that between the two samples that are farthest
// apart.
double LambdaAxis::value(FaceSlot node) const {
  double out = 0.0;
  for_each_face_of(node, [&](FaceSlot face) {
    const auto [a, b, c] = corners(face);
    const double side = half_longest_side(a, b, c);
    // Rounding must not take a circumradius below the half side.
    out = std::max({out, side, is_right_or_obtuse(a, b, c) ? side : delaunay_.circumradius(face)});
  });
  return out;
}

bool LambdaAxis::reaches(EdgeSlot edge) const {
  if (wish().limit <= 0.0) return true;
  const EdgeRow& row = delaunay_.edge(edge);
  return compare_half_distance(delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1]), wish().limit) >=
         0;
}

bool LambdaAxis::node_reaches(FaceSlot node) const {
  if (wish().limit <= 0.0) return true;
  bool out = false;
  for_each_face_of(node, [&](FaceSlot face) {
    const auto [a, b, c] = corners(face);
    out = out || compare_enclosing_radius(a, b, c, wish().limit) >= 0;
  });
  return out;
}

int LambdaAxis::compare(EdgeSlot a, EdgeSlot b) const {
  const EdgeRow& row_a = delaunay_.edge(a);
  const EdgeRow& row_b = delaunay_.edge(b);
  return compare_lengths(delaunay_.site_position(row_a.v[0]), delaunay_.site_position(row_a.v[1]),
                         delaunay_.site_position(row_b.v[0]), delaunay_.site_position(row_b.v[1]));
}

void LambdaAxis::add_statistics(StatList& out) const {
  double largest = 0.0;
  double critical = std::numeric_limits<double>::infinity();
  std::int64_t critical_values = 0;
  const auto add_critical = [&](double at) {
    ++critical_values;
    critical = std::min(critical, at);
  };
  for (const FaceSlot node : delaunay_.face_slots()) {
    if (!delaunay_.face(node).is_alive() || !axis_.is_node(node)) continue;
    largest = std::max(largest, value(node));
    bool is_maximum = false;
    for_each_face_of(node, [&](FaceSlot face) {
      const auto [a, b, c] = corners(face);
      is_maximum = is_maximum || !is_right_or_obtuse(a, b, c);
    });
    if (is_maximum) add_critical(delaunay_.circumradius(node));
  }
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!is_edge(edge)) continue;
    const EdgeCorners at = crust_.corners(edge);
    if (dot(at.q - at.p, at.r - at.p) >= 0.0 && at.s && dot(at.r - *at.s, at.q - *at.s) >= 0.0)
      add_critical(value(edge));
  }
  out.push_back({"largest", largest > 0.0 ? largest : std::numeric_limits<double>::infinity()});
  out.push_back({"critical_values", critical_values});
  out.push_back({"weak_feature_size", critical});
}

}  // namespace mes
