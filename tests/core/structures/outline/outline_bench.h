// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines for tests, and their exact axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/outline/outline_axis.h"
#include "tests/support/workbench.h"

namespace mes::test {

using Ring = std::vector<Vec2>;

inline SampleData data_of_rings(const std::vector<Ring>& rings) {
  SampleData data;
  for (const Ring& ring : rings) {
    SampleData::Contour& contour = data.contours.emplace_back();
    contour.points.resize(ring.size());
    std::iota(contour.points.begin(), contour.points.end(), static_cast<std::uint32_t>(data.positions.size()));
    data.positions.insert(data.positions.end(), ring.begin(), ring.end());
  }
  return data;
}

inline SampleData data_of_curves(const std::vector<PlaneCurve>& curves) {
  SampleData data;
  auto set = std::make_shared<CurveSet>();
  set->curves = curves;
  data.source = std::make_shared<const CurveSource>(CurveSource{.curves = set});
  data.positions = {{0.0, 0.0}};  // the samples do not matter
  return data;
}

struct AxisBench : TestBench {
  explicit AxisBench(const SampleData& data) {
    show({"outline-axis"});
    load(data);
  }
  const OutlineAxis& axis() const { return get<OutlineAxis>(); }
  double length() const {
    double out = 0.0;
    for (const OutlinePiece& piece : axis().pieces()) out += distance(piece.from, piece.to);
    return out;
  }
  /// Whether there is a node at the point, with this radius.
  bool has_node(Vec2 at, double radius) const {
    return std::ranges::any_of(axis().graph().nodes, [&](const OutlineNode& node) {
      return distance(node.center, at) < 1e-9 && std::abs(node.radius - radius) < 1e-9;
    });
  }
};

/// A piece without direction, for comparison.
using PlainPiece = std::array<double, 6>;
inline std::vector<PlainPiece> pieces_of(const OutlineAxis& axis, double unit) {
  std::vector<PlainPiece> out;
  for (const OutlinePiece& piece : axis.pieces()) {
    const PlainPiece there{unit * piece.from.x, unit * piece.from.y, unit * piece.radius_from,
                           unit * piece.to.x,   unit * piece.to.y,   unit * piece.radius_to};
    const PlainPiece back{there[3], there[4], there[5], there[0], there[1], there[2]};
    out.push_back(std::min(there, back));
  }
  std::ranges::sort(out);
  return out;
}

/// A polygon around the origin with vertices on integers, whose radii lie between `low` and `high`.
inline Ring star_polygon(Rng& rng, std::size_t count, double low, double high) {
  Ring out;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * std::numbers::pi * (static_cast<double>(i) + rng.uniform(0.1, 0.9)) / static_cast<double>(count);
    const double radius = rng.uniform(low, high);
    out.push_back({std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))});
  }
  return out;
}

}  // namespace mes::test
