// SPDX-License-Identifier: GPL-3.0-or-later
// Simple curves, and the pieces of curves.
#pragma once

#include <vector>

#include "core/curves/curve.h"
#include "tests/support/pi.h"

namespace mes::test {

inline PlaneCurve polygon(const std::vector<Vec2>& points, bool is_closed = true) {
  PlaneCurve curve(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) curve.line_to(points[i]);
  if (is_closed) curve.close();
  return curve;
}

inline PlaneCurve ellipse_around(Vec2 center, double a, double b) {
  PlaneCurve curve(center + Vec2{a, 0});
  curve.arc_to({center, {a, 0}, {0, b}, 0.0, 2.0 * kPi}, curve.start());
  curve.close();
  return curve;
}

inline PlaneCurve circle_around(Vec2 center, double radius) {
  return ellipse_around(center, radius, radius);
}

inline std::vector<Piece> pieces_of(const PlaneCurve& curve) {
  std::vector<Piece> out;
  curve.for_each_piece([&](const Piece& piece) { out.push_back(piece); });
  return out;
}

}  // namespace mes::test
