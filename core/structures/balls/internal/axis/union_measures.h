// SPDX-License-Identifier: GPL-3.0-or-later
// Last stage of the union pipeline: area and perimeter of the union, and the length of its medial axis.
#pragma once

#include <vector>

#include "core/base/sum.h"
#include "core/structures/balls/internal/axis/union_axis.h"
#include "core/structures/balls/internal/axis/union_centers.h"
#include "core/structures/balls/internal/complex/union_complex.h"
#include "core/structures/balls/internal/crossings/union_crossings.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// Sums in the coordinates of the frame. The union consists of the dual triangles, of the triangle between each dual
/// edge and each v-point that it made, and of the sectors of the free arcs; this follows from Green's formula by
/// cutting off the sectors and then these triangles. All of them are small and stay where they are: sums about one
/// origin would lose details that are small beside the distance from it.
template <class Balls, class Points>
class UnionMeter {
 public:
  explicit UnionMeter(const UnionBalls<Balls, Points>& balls) : balls_(balls) {}

  void add_arcs(const std::vector<InputArc>& arcs) {
    add_all<std::size_t>(arcs.size(), [&](std::size_t row, Totals& out) {
      const double r = balls_.input[arcs[row].ball].radius();
      out.perimeter.add(r * arcs[row].turn);
      out.area.add(0.5 * r * r * arcs[row].turn);
    });
  }
  void add_dual_edges(const RegularTables& tables, const DualComplex& complex, const VPoints<Points>& points) {
    add_all<RegularEdgeSlot>(tables.edges.size(), [&](RegularEdgeSlot e, Totals& out) {
      const DualEdgeSlot row = complex.row_of_edge[e];
      if (row == kNoSlot || complex.edges[row].kind == DualClass::interior) return;
      const auto& [a, b] = tables.edges[e].v;
      const Vec2 way = balls_.center(b) - balls_.center(a);
      for (const bool left : {true, false}) {
        const VPointSlot v = points.of_dual_edge[row][left ? 0 : 1];
        if (v == kNoSlot) continue;
        const double twice = cross(way, seen_from_center(balls_, points, a, b, left, v));
        out.area.add(left ? 0.5 * twice : -0.5 * twice);
      }
      if (complex.edges[row].kind == DualClass::singular) out.axis_length.add(local_length(way));
    });
  }
  void add_dual_faces(const RegularTables& tables, const DualComplex& complex) {
    add_all<TriangleSlot>(tables.faces.size(), [&](TriangleSlot f, Totals& out) {
      if (!complex.has(f)) return;
      const auto& v = tables.faces[f].v;
      const Vec2 corner = balls_.center(v[0]);
      out.area.add(0.5 * cross(balls_.center(v[1]) - corner, balls_.center(v[2]) - corner));
    });
  }
  void add_axis(const UnionAxis& axis) { totals_.axis_length.add(axis.length); }
  /// Returns measures in the coordinates of the document.
  UnionMeasures measures() const {
    const LocalFrame& frame = balls_.frame;
    UnionMeasures out;
    out.area = frame.to_document_length(frame.to_document_length(totals_.area.value()));
    out.perimeter = frame.to_document_length(totals_.perimeter.value());
    out.axis_length = frame.to_document_length(totals_.axis_length.value());
    out.left_out = totals_.area.left_out() + totals_.perimeter.left_out() + totals_.axis_length.left_out();
    return out;
  }

 private:
  struct Totals {
    Sum area, perimeter, axis_length;
    void add(const Totals& other) {
      area.add(other.area);
      perimeter.add(other.perimeter);
      axis_length.add(other.axis_length);
    }
  };
  // Calls `look(row, totals)` for the rows below `count`, in parallel, and adds up in their order.
  template <class Row, class Look>
  void add_all(std::size_t count, const Look& look) {
    std::vector<Totals> parts(balls_.part_count(count));
    balls_.in_parts(count, [&](std::size_t begin, std::size_t end, std::size_t part) {
      for (std::size_t row = begin; row < end; ++row) look(Row(row), parts[part]);
    });
    for (const Totals& part : parts) totals_.add(part);
  }

  const UnionBalls<Balls, Points>& balls_;
  Totals totals_;
};

}  // namespace mes
