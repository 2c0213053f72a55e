// SPDX-License-Identifier: GPL-3.0-or-later
// The alpha complex of the samples, its disks, and the live components and holes.
#include "core/structures/alpha/alpha_complex.h"
#include "core/layers/parts/helpers.h"

namespace mes {
namespace {

LayerDescriptor descriptor_of(const char* id, const char* name, const char* tooltip, const std::string& scalar,
                              LayerStyle style, std::vector<PrimitiveKind> kinds) {
  return {.id = id,
          .name = name,
          .tooltip = tooltip,
          .group = LayerGroup::delaunay_voronoi,
          .of_any_family = id,
          .scalar = scalar,
          .style = std::move(style),
          .kinds = std::move(kinds)};
}

/// Part over the live persistence pairs: `emit(class, instance)`.
template <class Emit>
auto classes_part(PrimitiveKind kind, const AlphaFiltration& filtration, const AlphaComplex& complex, Emit emit) {
  return table_part(
      {kind}, [&filtration] { return filtration.classes().size(); }, complex.class_changes(),
      [&filtration, &complex, emit](ClassSlot row, Instance& out) {
        const AlphaFiltration::Class& one = filtration.classes()[row.index()];
        if (complex.is_alive(one)) emit(one, out);
      },
      ElementType{ElementKind::alpha_class, &complex});
}

}  // namespace

Layer make_alpha_disks_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& complex = set.get<AlphaComplex>();
  return make_layer(
      descriptor_of("alpha-disks", "Alpha disks", "Disks of radius alpha-radius about the samples", {},
                    {.color = palette::sky, .opacity = 0.25, .flat = true}, {PrimitiveKind::disk}),
      {&delaunay, &complex},
      sites_part({PrimitiveKind::disk}, delaunay, complex.site_changes(), [&](SiteSlot site, Instance& out) {
        if (complex.radius() > 0.0) out.disk(delaunay.site_position(site), complex.radius());
      }));
}

Layer make_alpha_triangles_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& filtration = set.get<AlphaFiltration>();
  const auto& complex = set.get<AlphaComplex>();
  return make_layer(
      descriptor_of("alpha-triangles", "Alpha triangles",
                    "Delaunay triangles whose circumradius is at most alpha-radius", "radius",
                    {.color = palette::green, .opacity = 0.35}, {PrimitiveKind::triangle}),
      {&delaunay, &filtration, &complex},
      faces_part({PrimitiveKind::triangle}, delaunay, complex.face_changes(), [&](FaceSlot face, Instance& out) {
        if (!complex.holds(face)) return;
        const SiteSlot* const v = delaunay.face(face).v;
        out.triangle(delaunay.site_position(v[0]), delaunay.site_position(v[1]), delaunay.site_position(v[2]),
                     filtration.radius(filtration.rank(face)));
      }));
}

Layer make_alpha_edges_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& filtration = set.get<AlphaFiltration>();
  const auto& complex = set.get<AlphaComplex>();
  return make_layer(
      descriptor_of("alpha-edges", "Alpha edges",
                    "Delaunay edges whose alpha disks meet within the Voronoi cells of both samples", "radius",
                    {.color = palette::green, .line_width_px = 1.5}, {PrimitiveKind::segment}),
      {&delaunay, &filtration, &complex},
      edges_part({PrimitiveKind::segment}, delaunay, complex.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (complex.holds(edge)) emit_edge(delaunay, edge, out, filtration.radius(filtration.rank(edge)));
      }));
}

Layer make_alpha_boundary_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& complex = set.get<AlphaComplex>();
  return make_layer(
      descriptor_of("alpha-boundary", "Alpha boundary", "Boundary of the union of the alpha disks", {},
                    {.color = palette::blue, .line_width_px = 1.5}, {PrimitiveKind::arc, PrimitiveKind::circle}),
      {&delaunay, &complex},
      table_part(
          {PrimitiveKind::arc}, [&delaunay] { return 2 * delaunay.edge_rows(); }, complex.end_changes(),
          [&complex](EdgeEndSlot row, Instance& out) {
            if (const auto arc = complex.arc(row)) out.arc(*arc);
          },
          ElementType{ElementKind::alpha_end, &complex}),
      sites_part({PrimitiveKind::circle}, delaunay, complex.site_changes(), [&](SiteSlot site, Instance& out) {
        if (complex.radius() > 0.0 && complex.is_alone(site))
          out.circle(delaunay.site_position(site), complex.radius());
      }));
}

Layer make_alpha_components_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& filtration = set.get<AlphaFiltration>();
  const auto& complex = set.get<AlphaComplex>();
  return make_layer(
      descriptor_of("alpha-components", "Alpha components",
                    "The sample that represents each component of the alpha complex in the persistence diagram", {},
                    {.color = palette::vermilion, .point_size_px = 9.0}, {PrimitiveKind::point}),
      {&delaunay, &filtration, &complex},
      classes_part(PrimitiveKind::point, filtration, complex,
                   [&delaunay](const AlphaFiltration::Class& one, Instance& out) {
                     if (!one.is_hole) out.point(delaunay.site_position(one.site));
                   }));
}

Layer make_alpha_holes_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& filtration = set.get<AlphaFiltration>();
  const auto& complex = set.get<AlphaComplex>();
  return make_layer(
      descriptor_of(
          "alpha-holes", "Alpha holes",
          "The largest empty circle in each hole of the alpha complex: it fills when the disks have its radius",
          "persistence", {.color = palette::purple, .line_width_px = 2.0}, {PrimitiveKind::circle}),
      {&delaunay, &filtration, &complex},
      classes_part(PrimitiveKind::circle, filtration, complex,
                   [&delaunay, &filtration](const AlphaFiltration::Class& one, Instance& out) {
                     if (one.is_hole)
                       out.circle(delaunay.circumcenter(one.face), delaunay.circumradius(one.face),
                                  filtration.radius(one.death) - filtration.radius(one.birth));
                   }));
}

}  // namespace mes
