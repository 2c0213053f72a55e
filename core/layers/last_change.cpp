// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/delaunay/last_change.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_last_change_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& last = set.get<LastChange>();
  return make_layer(
      {.id = "last-change",
       .name = "Last change",
       .tooltip = "Faces and edges touched by the last edit",
       .group = LayerGroup::diagnostics,
       .in_fit_box = false,
       .style = {.color = palette::yellow, .opacity = 0.3},
       .kinds = {PrimitiveKind::triangle, PrimitiveKind::segment}},
      {&delaunay, &last},
      faces_part({PrimitiveKind::triangle}, delaunay, last.face_changes(),
                 [&](FaceSlot face, Instance& out) {
                   if (!last.is_touched_face(face)) return;
                   const FaceRow& row = delaunay.face(face);
                   out.triangle(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1]),
                                delaunay.site_position(row.v[2]));
                 }),
      edges_part({PrimitiveKind::segment}, delaunay, last.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (last.is_touched_edge(edge)) emit_edge(delaunay, edge, out);
      }));
}

}  // namespace mes
