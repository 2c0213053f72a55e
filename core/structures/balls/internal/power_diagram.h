// SPDX-License-Identifier: GPL-3.0-or-later
// Regular triangulation and power diagram of a set of balls, in any number type.
#pragma once

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "core/structures/balls/internal/union_numbers.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/triangulation/regular_triangulation.h"

namespace mes {

/// Point of equal power; a's centre where there is none.
template <class Number>
PlacedPoint power_center(const BallOf<Number>& a, const BallOf<Number>& b, const BallOf<Number>& c,
                         const LocalFrame& frame) {
  const Number bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Number pb = bx * bx + by * by - b.w + a.w;
  const Number pc = cx * cx + cy * cy - c.w + a.w;
  const Number twice = Number(2) * (bx * cy - by * cx);
  if constexpr (std::is_same_v<Number, double>) {
    // With centres nearly in line, as of half planes along a straight side, rounding would carry the point anywhere.
    // Nor must products below the range of doubles decide.
    if (!(std::abs(twice) > 1e-6 * (std::abs(bx * cy) + std::abs(by * cx)) && std::abs(twice) > 0x1p-400)) {
      using Exact = CGAL::Exact_rational;
      const auto exact = [](const BallOf<double>& ball) { return BallOf<Exact>{ball.x, ball.y, ball.w}; };
      return power_center(exact(a), exact(b), exact(c), frame);
    }
  }
  if (twice == Number(0)) return placed(a.x, a.y, frame);  // naive triangulations have flat triangles
  return placed(Number(a.x + (pb * cy - pc * by) / twice), Number(a.y + (pc * bx - pb * cx) / twice), frame);
}

/// The point of equal power on the way from one centre to another, for balls alone on a line.
inline Vec2 power_foot(const PipelineBall& from, const PipelineBall& to, const LocalFrame& frame) {
  // The centres may be so close together that the square of their distance underflows.
  using Exact = CGAL::Exact_rational;
  const Exact x = Exact(to.disk.center.x) - Exact(from.disk.center.x);
  const Exact y = Exact(to.disk.center.y) - Exact(from.disk.center.y);
  const Exact r = Exact(from.radius()), s = Exact(to.radius());
  const Exact dd = x * x + y * y;
  if (dd == 0) return frame.to_document(from.disk.center);  // naive triangulations join equal centres
  const Exact t = (dd + r * r - s * s) / (2 * dd);
  return placed(Exact(from.disk.center.x + t * x), Exact(from.disk.center.y + t * y), frame).document;
}

template <class Kernel>
Table<PowerEdgeSlot, PowerEdge> power_diagram(const PipelineInput& input, JobControl& job) {
  Table<InputSlot, BallOf<typename Kernel::FT>> balls;
  balls.reserve(input.balls.size());
  for (const PipelineBall& ball : input.balls) balls.push_back(ball_in<typename Kernel::FT>(ball));
  const RegularTables rt = regular_triangulation<Kernel>(balls, job);
  const LocalFrame& frame = input.frame;
  Table<TriangleSlot, PlacedPoint> center(rt.faces.size());
  Table<TriangleSlot, bool> is_finite(rt.faces.size(), false);
  const auto comes_before = [&input](InputSlot a, InputSlot b) {
    return lexicographically_less(input.balls[a].disk.center, input.balls[b].disk.center);
  };
  for (const TriangleSlot f : rt.faces.rows()) {
    const auto& v = rt.faces[f].v;
    is_finite[f] = v[0] != kInfiniteBall && v[1] != kInfiniteBall && v[2] != kInfiniteBall;
    if (!is_finite[f]) continue;
    // The sample that three balls touch is their point of equal power, exactly.
    const TouchedSample* sample = common_sample(input.balls[v[0]], input.balls[v[1]], input.balls[v[2]]);
    // Rounding must not depend on the order in which the balls came.
    std::array<InputSlot, 3> order{v[0], v[1], v[2]};
    std::ranges::rotate(order, std::ranges::min_element(order, comes_before));
    center[f] = sample != nullptr ? PlacedPoint{sample->position, frame.to_document(sample->position)}
                                  : power_center(balls[order[0]], balls[order[1]], balls[order[2]], frame);
  }
  Table<PowerEdgeSlot, PowerEdge> out;
  out.reserve(rt.edges.size());
  for (const RegularTables::Edge& edge : rt.edges) {
    const PipelineBall& a = input.balls[edge.v[0]];
    const PipelineBall& b = input.balls[edge.v[1]];
    const Vec2 along = b.disk.center - a.disk.center;
    PowerEdge row{{a.row, b.row}};
    const bool left = edge.f[0] != kNoSlot && is_finite[edge.f[0]];
    const bool right = edge.f[1] != kNoSlot && is_finite[edge.f[1]];
    for (const std::size_t side : {0U, 1U})
      if (side == 0 ? left : right) row.face[side] = edge.f[side];
    if (left && right) {
      row.from = center[edge.f[0]].document;
      row.to = center[edge.f[1]].document;
      row.length = frame.to_document_length(distance(center[edge.f[0]].local, center[edge.f[1]].local));
    } else if (left || right) {
      row.kind = PowerEdge::Kind::ray;
      row.from = center[edge.f[left ? 0 : 1]].document;
      row.to = left ? -perpendicular(along) : perpendicular(along);
    } else {
      const bool in_order = comes_before(edge.v[0], edge.v[1]);
      const PipelineBall& from = in_order ? a : b;
      const PipelineBall& to = in_order ? b : a;
      const Vec2 way = to.disk.center - from.disk.center;
      row.kind = PowerEdge::Kind::line;
      row.from = power_foot(from, to, frame);
      row.to = perpendicular(way);
    }
    out.push_back(row);
  }
  return out;
}

}  // namespace mes
