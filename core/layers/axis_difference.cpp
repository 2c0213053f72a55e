// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/axis_difference.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_axis_difference_layer(const StructureSet& set) {
  const auto& difference = set.get<AxisDifference>();
  return make_layer(
      {.id = "axis-difference",
       .name = "Axis difference",
       .tooltip = "Pieces of the medial axis or of that of the union of its balls, but not of both",
       .group = LayerGroup::diagnostics,
       .scalar = "1: only in the one-step axis, 2: only in that of the union",
       .style = {.color = palette::vermilion, .line_width_px = 4},
       .kinds = {PrimitiveKind::segment}},
      {&difference},
      table_part(
          {PrimitiveKind::segment}, [&difference] { return difference.pieces().size(); }, difference.changes(),
          [&difference](AxisDifference::PieceSlot row, Instance& out) {
            const AxisDifference::Piece& piece = difference.pieces()[row];
            out.segment(piece.a, piece.b, piece.only_one_step ? 1.0 : 2.0);
          }));
}

}  // namespace mes
