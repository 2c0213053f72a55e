// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_exterior_vertices_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "v-exterior-vertices",
       .name = "v-point exterior vertices",
       .tooltip = "Voronoi vertices of the v-points outside the dual complex",
       .in_fit_box = false,
       .scalar = "radius",
       .style = {.color = palette::sky, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}},
      v_part({PrimitiveKind::point}, diagram, &UnionTables::v_faces, [](const VFace& face, Instance& out) {
        if (face.is_inside == 0) out.point(face.center, face.radius);
      }));
}

}  // namespace mes
