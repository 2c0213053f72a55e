// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "core/layers/parts/helpers.h"
#include "core/structures/outline/outline_axis.h"

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
       .kinds = {PrimitiveKind::segment, PrimitiveKind::parabola}},
      {&axis},
      table_part(
          {PrimitiveKind::segment, PrimitiveKind::parabola}, [&axis] { return axis.graph().edges.size(); },
          axis.changes(),
          [&axis](OutlineEdgeSlot row, Instance& out) {
            const OutlineEdge& edge = axis.graph().edges[row];
            const OutlineNode& from = axis.graph().nodes[edge.nodes[0]];
            const OutlineNode& to = axis.graph().nodes[edge.nodes[1]];
            const double radius = 0.5 * (from.radius + to.radius);
            if (const std::optional<Vec2> control = axis.control(row))
              out.parabola({from.center, *control, to.center}, radius);
            else
              out.segment(from.center, to.center, radius);
          },
          ElementType{ElementKind::axis_piece, &axis}));
}

}  // namespace mes
