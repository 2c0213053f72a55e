// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/filters/axis_center_lines.h"

namespace mes {
namespace {

/// A transect has two parts, which form an angle in bends.
using HalfSlot = Slot<struct TransectHalfTag>;

}  // namespace

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
  return make_layer(
      {.id = "transects",
       .name = "Transects",
       .tooltip = "Lines across the shapes in equal steps along the centre lines, with the width there",
       .group = LayerGroup::crust_axis,
       .scalar = "width",
       .style = {.color = palette::blue, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::segment}},
      {&lines},
      table_part(
          {PrimitiveKind::segment}, [&lines] { return 2 * lines.transects().size(); }, no_changes<HalfSlot>(),
          [&lines](HalfSlot row, Instance& out) {
            const AxisCenterLines::TransectSlot slot(row.index() / 2);
            const AxisCenterLines::Transect& at = lines.transects()[slot];
            out.segment(row.index() % 2 == 0 ? at.left : at.right, at.axis, at.width);
          }));
}

}  // namespace mes
