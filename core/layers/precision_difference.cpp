// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/precision_difference.h"
#include "core/layers/parts/helpers.h"

namespace mes {
namespace {

// First the rows of A, then those of B: a layer has one part of a kind.
using DifferenceSlot = Slot<struct DifferenceTag>;

void emit_face(const PrecisionDifference& difference, std::size_t row, Instance& out) {
  const PrecisionDifference::Face& face = difference.faces()[row];
  const BallFamily& family = difference.balls().family();
  out.triangle(family.disk(face.ball[0]).center, family.disk(face.ball[1]).center, family.disk(face.ball[2]).center,
               face.is_exact ? 1.0 : 2.0);
}
void emit_edge(const PrecisionDifference& difference, std::size_t row, Instance& out) {
  const PrecisionDifference::Edge& edge = difference.edges()[row];
  const BallFamily& family = difference.balls().family();
  out.segment(family.disk(edge.ball[0]).center, family.disk(edge.ball[1]).center,
              edge.chosen < 0 ? 1.0 : (edge.exact < 0 ? 2.0 : 3.0));
}

}  // namespace

Layer make_precision_difference_layer(const StructureSet& set) {
  const auto& a = set.get<APrecisionDifference>();
  const auto& b = set.get<BPrecisionDifference>();
  return make_layer(
      {.id = "precision-difference",
       .name = "Precision difference",
       .tooltip = "Dual edges and triangles of the unions of inner and own balls that the number type and exact "
                  "arithmetic judge differently",
       .group = LayerGroup::diagnostics,
       .scalar = "1: missed, 2: invented, 3: of another class",
       .style = {.color = palette::vermilion, .opacity = 0.7, .line_width_px = 3},
       .kinds = {PrimitiveKind::triangle, PrimitiveKind::segment}},
      {&a, &b},
      table_part(
          {PrimitiveKind::triangle}, [&] { return a.faces().size() + b.faces().size(); },
          no_changes<DifferenceSlot>(),
          [&](DifferenceSlot row, Instance& out) {
            const std::size_t of_a = a.faces().size();
            row.index() < of_a ? emit_face(a, row.index(), out) : emit_face(b, row.index() - of_a, out);
          }),
      table_part(
          {PrimitiveKind::segment}, [&] { return a.edges().size() + b.edges().size(); }, no_changes<DifferenceSlot>(),
          [&](DifferenceSlot row, Instance& out) {
            const std::size_t of_a = a.edges().size();
            row.index() < of_a ? emit_edge(a, row.index(), out) : emit_edge(b, row.index() - of_a, out);
          }));
}

}  // namespace mes
