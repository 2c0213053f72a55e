// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/outline_axis.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_outline_axis_layer(const StructureSet& set) {
  const auto& axis = set.get<OutlineAxis>();
  return make_layer(
      {.id = "outline-axis",
       .name = "Axis of the outline",
       .tooltip = "Exact medial axis of the contours or curves inside them, without samples: straight edges and arcs "
                  "of parabolas",
       .group = LayerGroup::crust_axis,
       .scalar = "radius",
       .style = {.color = palette::blue, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::segment}},
      {&axis},
      table_part(
          {PrimitiveKind::segment}, [&axis] { return axis.pieces().size(); }, axis.changes(),
          [&axis](OutlinePieceSlot row, Instance& out) {
            const OutlinePiece& piece = axis.pieces()[row];
            out.segment(piece.from, piece.to, 0.5 * (piece.radius_from + piece.radius_to));
          },
          ElementType{ElementKind::axis_piece, &axis}));
}

}  // namespace mes
