// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/filters/axis_center_lines.h"

namespace mes {

Layer make_center_lines_layer(const StructureSet& set) {
  const auto& lines = set.get<AxisCenterLines>();
  return make_layer({.id = "center-lines",
                     .name = "Centre lines",
                     .tooltip = "The longest lines of the pruned medial axis, smoothed inside the shapes",
                     .group = LayerGroup::crust_axis,
                     .style = {.color = palette::vermilion, .line_width_px = 3},
                     .kinds = {PrimitiveKind::segment}},
                    {&lines},
                    table_part(
                        {PrimitiveKind::segment}, [&lines] { return lines.pieces().size(); },
                        no_changes<AxisCenterLines::PieceSlot>(),
                        [&lines](AxisCenterLines::PieceSlot row, Instance& out) {
                          const AxisCenterLines::Piece& piece = lines.pieces()[row];
                          out.segment(piece.from, piece.to);
                        }));
}

Layer make_transects_layer(const StructureSet& set) {
  const auto& lines = set.get<AxisCenterLines>();
  const auto half = [&lines](Vec2 AxisCenterLines::Transect::*bank) {
    return table_part(
        {PrimitiveKind::segment}, [&lines] { return lines.transects().size(); },
        no_changes<AxisCenterLines::TransectSlot>(),
        [&lines, bank](AxisCenterLines::TransectSlot row, Instance& out) {
          const AxisCenterLines::Transect& at = lines.transects()[row];
          out.segment(at.*bank, at.axis, at.width);
        });
  };
  return make_layer({.id = "transects",
                     .name = "Transects",
                     .tooltip = "Lines across the shapes in equal steps along the centre lines, with the width there",
                     .group = LayerGroup::crust_axis,
                     .scalar = "width",
                     .style = {.color = palette::blue, .line_width_px = 1.5},
                     .kinds = {PrimitiveKind::segment}},
                    {&lines}, half(&AxisCenterLines::Transect::left), half(&AxisCenterLines::Transect::right));
}

}  // namespace mes
