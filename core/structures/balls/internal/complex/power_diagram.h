// SPDX-License-Identifier: GPL-3.0-or-later
// Regular triangulation and power diagram of a set of balls, in any number type.
#pragma once

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/structures/balls/internal/numbers/number_parts.h"
#include "core/structures/balls/internal/numbers/union_numbers.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/triangulation/regular_triangulation.h"

namespace mes {

/// Point of equal power; a's centre if there is none.
template <class Number>
PlacedPoint power_center(const BallOf<Number>& a, const BallOf<Number>& b, const BallOf<Number>& c,
                         const LocalFrame& frame) {
  const Number bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Number pb = bx * bx + by * by - b.w + a.w;
  const Number pc = cx * cx + cy * cy - c.w + a.w;
  const Number twice = Number(2) * (bx * cy - by * cx);
  if constexpr (std::is_same_v<Number, double>) {
    // If centres are nearly in line, as for half planes along a straight side, rounding would carry the point anywhere.
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

/// The point of equal power on the line from one centre to another, for collinear balls.
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

/// The triangles of a regular triangulation as corners of power cells. Infinite triangles have no centre.
struct PowerCenters {
  Table<TriangleSlot, PlacedPoint> center;
  Table<TriangleSlot, std::uint8_t> is_finite;

  bool has(TriangleSlot face) const { return face != kNoSlot && is_finite[face] != 0; }
};

template <class Number>
PowerCenters power_centers(const PipelineInput& input, const Table<InputSlot, BallOf<Number>>& balls,
                           const RegularTables& rt, JobControl& job) {
  PowerCenters out{Table<TriangleSlot, PlacedPoint>(rt.faces.size()),
                   Table<TriangleSlot, std::uint8_t>(rt.faces.size(), 0)};
  const auto comes_before = [&input](InputSlot a, InputSlot b) {
    return lexicographically_less(input.balls[a].disk.center, input.balls[b].disk.center);
  };
  NumberParts<Number>::in_parts(rt.faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const TriangleSlot f : slots_between<TriangleSlot>(begin, end)) {
      if (f.index() % kRowsPerLook == 0) job.checkpoint();
      const auto& v = rt.faces[f].v;
      if (v[0] == kInfiniteBall || v[1] == kInfiniteBall || v[2] == kInfiniteBall) continue;
      out.is_finite[f] = 1;
      // The sample that three balls touch is their point of equal power, exactly.
      const TouchedSample* sample = common_sample(input.balls[v[0]], input.balls[v[1]], input.balls[v[2]]);
      if (sample != nullptr) {
        out.center[f] = {sample->position, input.frame.to_document(sample->position)};
        continue;
      }
      // Rounding must not depend on the order of the balls.
      std::array<InputSlot, 3> order{v[0], v[1], v[2]};
      std::ranges::rotate(order, std::ranges::min_element(order, comes_before));
      out.center[f] = power_center(balls[order[0]], balls[order[1]], balls[order[2]], input.frame);
    }
  });
  return out;
}

inline PowerEdge power_edge(const PipelineInput& input, const RegularTables::Edge& edge,
                            const PowerCenters& centers) {
  const PipelineBall& a = input.balls[edge.v[0]];
  const PipelineBall& b = input.balls[edge.v[1]];
  PowerEdge out{{a.row, b.row}};
  const bool left = centers.has(edge.f[0]);
  const bool right = centers.has(edge.f[1]);
  if (left) out.face[0] = edge.f[0];
  if (right) out.face[1] = edge.f[1];
  if (left && right) {
    const PlacedPoint& from = centers.center[edge.f[0]];
    const PlacedPoint& to = centers.center[edge.f[1]];
    out.from = from.document;
    out.to = to.document;
    out.length = input.frame.to_document_length(local_length(to.local - from.local));
  } else if (left || right) {
    const Vec2 along = b.disk.center - a.disk.center;
    out.kind = PowerEdge::Kind::ray;
    out.from = centers.center[edge.f[left ? 0 : 1]].document;
    out.to = left ? -perpendicular(along) : perpendicular(along);
  } else {
    const bool in_order = lexicographically_less(a.disk.center, b.disk.center);
    const PipelineBall& from = in_order ? a : b;
    const PipelineBall& to = in_order ? b : a;
    out.kind = PowerEdge::Kind::line;
    out.from = power_foot(from, to, input.frame);
    out.to = perpendicular(to.disk.center - from.disk.center);
  }
  return out;
}

template <class Kernel>
Table<PowerEdgeSlot, PowerEdge> power_diagram(const PipelineInput& input, JobControl& job) {
  using Number = typename Kernel::FT;
  using Parts = NumberParts<Number>;
  Table<InputSlot, BallOf<Number>> balls(input.balls.size());
  Parts::in_parts(balls.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const InputSlot i : slots_between<InputSlot>(begin, end)) {
      if (i.index() % kRowsPerLook == 0) job.checkpoint();
      balls[i] = ball_in<Number>(input.balls[i]);
    }
  });
  const RegularTables rt = regular_triangulation<Kernel>(balls, job);
  const PowerCenters centers = power_centers(input, balls, rt, job);
  Table<PowerEdgeSlot, PowerEdge> out(rt.edges.size());
  Parts::in_parts(rt.edges.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const RegularEdgeSlot e : slots_between<RegularEdgeSlot>(begin, end)) {
      if (e.index() % kRowsPerLook == 0) job.checkpoint();
      out[same_row<PowerEdgeSlot>(e)] = power_edge(input, rt.edges[e], centers);
    }
  });
  return out;
}

}  // namespace mes
