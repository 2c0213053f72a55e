// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/axis_error.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_axis_error_layer(const StructureSet& set) {
  const auto& error = set.get<AxisError>();
  return make_layer(
      {.id = "axis-error",
       .name = "Error of the axis",
       .tooltip =
           "The medial axis of the samples and the axis of the outline, with the distance of each from the other",
       .group = LayerGroup::diagnostics,
       .scalar = "distance from the other axis",
       .style = {.color = palette::vermilion, .line_width_px = 2.5, .color_map = "cividis"},
       .kinds = {PrimitiveKind::segment}},
      {&error},
      table_part(
          {PrimitiveKind::segment}, [&error] { return error.pieces().size(); }, error.changes(),
          [&error](AxisError::PieceSlot row, Instance& out) {
            const AxisError::Piece& piece = error.pieces()[row];
            out.segment(piece.from, piece.to, piece.distance);
          }));
}

}  // namespace mes
