// SPDX-License-Identifier: GPL-3.0-or-later
// The balls grown by one amount, and the components and holes that live then.
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_alpha_disks_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-disks",
       .name = "alpha disks",
       .tooltip = "The balls with squared radii grown by the square of alpha-radius; hidden ones are "
                  "left out",
       .style = {.color = palette::sky, .opacity = 0.25, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      table_part(
          {PrimitiveKind::disk}, [&] { return complex.filtration().corners().size(); }, complex.corner_changes(),
          [&complex](GrownCornerSlot corner, Instance& out) {
            const Disk disk = complex.disk(corner);
            if (disk.radius > 0.0) out.disk(disk.center, disk.radius);
          },
          ElementType{ElementKind::alpha_corner, &complex}));
}

Layer make_union_alpha_triangles_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(family,
                     {.id = "alpha-triangles",
                      .name = "alpha triangles",
                      .tooltip = "Triangles of the dual complex of the grown balls",
                      .scalar = "growth",
                      .style = {.color = palette::green, .opacity = 0.35},
                      .kinds = {PrimitiveKind::triangle}},
                     table_part(
                         {PrimitiveKind::triangle}, [&] { return complex.filtration().triangles().size(); },
                         complex.triangle_changes(),
                         [&complex](GrownTriangleSlot triangle, Instance& out) {
                           if (!complex.holds(triangle)) return;
                           const BallFiltration& of = complex.filtration();
                           const BallBirths::Triangle& row = of.triangles()[triangle];
                           out.triangle(of.disk(row.v[0]).center, of.disk(row.v[1]).center, of.disk(row.v[2]).center,
                                        of.growth(row.rank));
                         },
                         ElementType{ElementKind::alpha_triangle, &complex}));
}

Layer make_union_alpha_edges_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-edges",
       .name = "alpha edges",
       .tooltip = "Edges of the dual complex of the grown balls",
       .scalar = "growth",
       .style = {.color = palette::green, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::segment}},
      table_part(
          {PrimitiveKind::segment}, [&] { return complex.filtration().edges().size(); }, complex.edge_changes(),
          [&complex](GrownEdgeSlot edge, Instance& out) {
            if (!complex.holds(edge)) return;
            const BallFiltration& of = complex.filtration();
            const BallBirths::Edge& row = of.edges()[edge];
            out.segment(of.disk(row.v[0]).center, of.disk(row.v[1]).center, of.growth(row.rank));
          },
          ElementType{ElementKind::alpha_edge, &complex}));
}

Layer make_union_alpha_boundary_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-boundary",
       .name = "alpha boundary",
       .tooltip = "Boundary of the union of the grown balls",
       .style = {.color = palette::blue, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::arc, PrimitiveKind::circle}},
      table_part(
          {PrimitiveKind::arc}, [&] { return 2 * complex.filtration().edges().size(); }, complex.end_changes(),
          [&complex](GrownEndSlot row, Instance& out) {
            if (const auto arc = complex.drawn(row)) out.arc(*arc);
          },
          ElementType{ElementKind::alpha_end, &complex}),
      table_part(
          {PrimitiveKind::circle}, [&] { return complex.filtration().corners().size(); }, complex.corner_changes(),
          [&complex](GrownCornerSlot corner, Instance& out) {
            const Disk disk = complex.disk(corner);
            if (complex.is_alone(corner) && disk.radius > 0.0) out.circle(disk.center, disk.radius);
          },
          ElementType{ElementKind::alpha_corner, &complex}));
}

Layer make_union_alpha_holes_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-holes",
       .name = "alpha holes",
       .tooltip =
           "The circle orthogonal to the three balls that meet last in each hole: it fills when alpha-radius is "
           "the radius of the circle",
       .scalar = "persistence",
       .style = {.color = palette::purple, .line_width_px = 2.0},
       .kinds = {PrimitiveKind::circle}},
      table_part(
          {PrimitiveKind::circle}, [&] { return complex.filtration().classes().size(); }, complex.class_changes(),
          [&complex](GrownClassSlot row, Instance& out) {
            const BallFiltration& of = complex.filtration();
            const BallFiltration::Class& one = of.classes()[row.index()];
            if (!one.is_hole || !complex.is_alive(one)) return;
            out.circle(of.triangles()[one.triangle].center, of.growth(one.death),
                       of.growth(one.death) - of.growth(one.birth));
          },
          ElementType{ElementKind::alpha_class, &complex}));
}

Layer make_union_alpha_components_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-components",
       .name = "alpha components",
       .tooltip = "The ball that represents each component of the grown balls in the persistence diagram",
       .style = {.color = palette::vermilion, .point_size_px = 9.0},
       .kinds = {PrimitiveKind::point}},
      table_part(
          {PrimitiveKind::point}, [&] { return complex.filtration().classes().size(); }, complex.class_changes(),
          [&complex](GrownClassSlot row, Instance& out) {
            const BallFiltration& of = complex.filtration();
            const BallFiltration::Class& one = of.classes()[row.index()];
            if (!one.is_hole && complex.is_alive(one)) out.point(of.disk(one.corner).center);
          },
          ElementType{ElementKind::alpha_class, &complex}));
}

}  // namespace mes
