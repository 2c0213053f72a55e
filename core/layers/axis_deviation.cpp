// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/axis_deviation.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_axis_deviation_layer(const StructureSet& set) {
  const auto& deviation = set.get<AxisDeviation>();
  return make_layer(
      {.id = "axis-deviation",
       .name = "Deviation of the axis",
       .tooltip =
           "The medial axis of the samples and the axis of the outline, with the distance of each from the other",
       .group = LayerGroup::diagnostics,
       .scalar = "distance from the other axis",
       .style = {.color = palette::vermilion, .line_width_px = 2.5, .color_map = "cividis"},
       .kinds = {PrimitiveKind::segment}},
      {&deviation},
      table_part(
          {PrimitiveKind::segment}, [&deviation] { return deviation.pieces().size(); }, deviation.changes(),
          [&deviation](AxisDeviation::PieceSlot row, Instance& out) {
            const AxisDeviation::Piece& piece = deviation.pieces()[row];
            out.segment(piece.from, piece.to, piece.distance);
          }));
}

}  // namespace mes
