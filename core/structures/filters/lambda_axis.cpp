// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/lambda_axis.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/geometry/infinity.h"
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

// The triangles of a node cover the polygon of its samples. If the centre lies in the polygon, it lies in one of them,
// which is not obtuse. Otherwise all are obtuse, and their longest side joins the two samples that are farthest apart.
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

void LambdaAxis::reached_each(std::span<const EdgeSlot> edges, std::span<Reached> out) const {
  for (std::size_t i = 0; i < edges.size(); ++i) out[i] = {LambdaAxis::reaches(edges[i]), {true, true}};
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

// The centre of a circle lies in the closed polygon of its samples if it lies in one of the closed triangles: inside
// it, or on a side of it, which is then a diameter.
std::optional<double> LambdaAxis::critical_value(FaceSlot node) const {
  std::optional<double> out;
  for_each_face_of(node, [&](FaceSlot face) {
    const std::array<Vec2, 3> corner = corners(face);
    std::array<int, 3> sign{};
    for (std::size_t i = 0; i < 3; ++i) sign[i] = sign_of_corner(corner[i], corner[(i + 1) % 3], corner[(i + 2) % 3]);
    if (std::ranges::min(sign) > 0) out = delaunay_.circumradius(node);
    if (std::ranges::min(sign) != 0) return;
    const auto right = static_cast<std::size_t>(std::ranges::find(sign, 0) - sign.begin());
    // Computed as for a crossed edge, so that both give one value.
    out = 0.5 * distance(corner[(right + 1) % 3], corner[(right + 2) % 3]);
  });
  return out;
}

std::vector<double> LambdaAxis::critical_values() const {
  std::vector<double> out;
  for (const FaceSlot node : delaunay_.face_slots()) {
    if (!delaunay_.face(node).is_alive() || !axis_.is_node(node)) continue;
    if (const auto value = critical_value(node)) out.push_back(*value);
  }
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    // Includes edges of length zero: diagonals of samples on one circle are crossed where the centre lies on them.
    if (!delaunay_.edge(edge).is_alive() || !axis_.is_axis_edge(edge)) continue;
    const EdgeCorners at = crust_.corners(edge);
    if (at.s && sign_of_corner(at.p, at.q, at.r) >= 0 && sign_of_corner(*at.s, at.r, at.q) >= 0)
      out.push_back(value(edge));
  }
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

void LambdaAxis::add_statistics(StatList& out) const {
  double largest = 0.0;
  for (const FaceSlot node : delaunay_.face_slots())
    if (delaunay_.face(node).is_alive() && axis_.is_node(node)) largest = std::max(largest, value(node));
  const std::vector<double> critical = critical_values();
  out.push_back({"largest", largest > 0.0 ? largest : kInfinity});
  out.push_back({"critical_values", static_cast<std::int64_t>(critical.size())});
  out.push_back({"weak_feature_size", critical.empty() ? kInfinity : critical.front()});
}

}  // namespace mes
