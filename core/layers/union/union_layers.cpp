// SPDX-License-Identifier: GPL-3.0-or-later
// The list of layers of a union of balls, in default stacking order: first = bottom.
#include "core/layers/union/union_layers.h"

#include <functional>

#include "core/graph/registry.h"
#include "core/layers/parts/family.h"
#include "core/structures/poles/polar_union.h"

namespace mes {

Layer make_union_ball_convex_disks_layer(const UnionFamily&);
Layer make_union_ball_medial_disks_layer(const UnionFamily&);
Layer make_union_scale_axis_grown_disks_layer(const UnionFamily&);
Layer make_union_scale_axis_disks_layer(const UnionFamily&);
Layer make_union_inner_disks_layer(const UnionFamily&);
Layer make_union_alpha_disks_layer(const UnionFamily&);
Layer make_union_ball_convex_circles_layer(const UnionFamily&);
Layer make_union_ball_medial_circles_layer(const UnionFamily&);
Layer make_union_scale_axis_circles_layer(const UnionFamily&);
Layer make_union_inner_circles_layer(const UnionFamily&);
Layer make_union_alpha_triangles_layer(const UnionFamily&);
Layer make_union_dual_faces_layer(const UnionFamily&);
Layer make_union_degenerate_dual_faces_layer(const UnionFamily&);
Layer make_union_v_origin_triangle_layer(const UnionFamily&);
Layer make_union_power_diagram_layer(const UnionFamily&);
Layer make_union_ball_triangulation_layer(const UnionFamily&);
Layer make_union_v_delaunay_layer(const UnionFamily&);
Layer make_union_v_voronoi_layer(const UnionFamily&);
Layer make_union_alpha_edges_layer(const UnionFamily&);
Layer make_union_dual_interior_edges_layer(const UnionFamily&);
Layer make_union_dual_regular_edges_layer(const UnionFamily&);
Layer make_union_dual_singular_edges_layer(const UnionFamily&);
Layer make_union_v_crossing_edges_layer(const UnionFamily&);
Layer make_union_v_alpha_edges_layer(const UnionFamily&);
Layer make_union_union_boundary_layer(const UnionFamily&);
Layer make_union_alpha_boundary_layer(const UnionFamily&);
Layer make_union_alpha_holes_layer(const UnionFamily&);
Layer make_union_ball_medial_axis_layer(const UnionFamily&);
Layer make_union_scale_axis_boundary_layer(const UnionFamily&);
Layer make_union_scale_axis_layer(const UnionFamily&);
Layer make_union_scale_skeleton_layer(const UnionFamily&);
Layer make_union_ball_convex_centers_layer(const UnionFamily&);
Layer make_union_ball_medial_centers_layer(const UnionFamily&);
Layer make_union_v_origin_edge_layer(const UnionFamily&);
Layer make_union_v_exterior_vertices_layer(const UnionFamily&);
Layer make_union_v_interior_vertices_layer(const UnionFamily&);
Layer make_union_inner_centers_layer(const UnionFamily&);
Layer make_union_alpha_components_layer(const UnionFamily&);
Layer make_union_isolated_layer(const UnionFamily&);
Layer make_union_v_points_layer(const UnionFamily&);

namespace {

using FamilyOf = std::function<UnionFamily(const StructureSet&)>;

/// Adds the layers of a union of balls. User balls have their own disk and circle layers elsewhere.
void add_family(Registry& registry, const FamilyOf& family_of, bool is_from_samples) {
  const auto add = [&](Layer (*make)(const UnionFamily&)) {
    registry.add_layer([family_of, make](const StructureSet& set) { return make(family_of(set)); });
  };
  add(make_union_ball_convex_disks_layer);
  add(make_union_ball_medial_disks_layer);
  add(make_union_scale_axis_grown_disks_layer);
  add(make_union_scale_axis_disks_layer);
  if (is_from_samples) add(make_union_inner_disks_layer);
  add(make_union_alpha_disks_layer);
  add(make_union_ball_convex_circles_layer);
  add(make_union_ball_medial_circles_layer);
  add(make_union_scale_axis_circles_layer);
  if (is_from_samples) add(make_union_inner_circles_layer);
  add(make_union_alpha_triangles_layer);
  add(make_union_dual_faces_layer);
  add(make_union_degenerate_dual_faces_layer);
  add(make_union_v_origin_triangle_layer);
  add(make_union_power_diagram_layer);
  add(make_union_ball_triangulation_layer);
  add(make_union_v_delaunay_layer);
  add(make_union_v_voronoi_layer);
  add(make_union_alpha_edges_layer);
  add(make_union_dual_interior_edges_layer);
  add(make_union_dual_regular_edges_layer);
  add(make_union_dual_singular_edges_layer);
  add(make_union_v_crossing_edges_layer);
  add(make_union_v_alpha_edges_layer);
  add(make_union_union_boundary_layer);
  add(make_union_alpha_boundary_layer);
  add(make_union_alpha_holes_layer);
  add(make_union_ball_medial_axis_layer);
  add(make_union_scale_axis_boundary_layer);
  add(make_union_scale_axis_layer);
  add(make_union_scale_skeleton_layer);
  add(make_union_ball_convex_centers_layer);
  add(make_union_ball_medial_centers_layer);
  add(make_union_v_origin_edge_layer);
  add(make_union_v_exterior_vertices_layer);
  add(make_union_v_interior_vertices_layer);
  if (is_from_samples) add(make_union_inner_centers_layer);
  add(make_union_alpha_components_layer);
  add(make_union_isolated_layer);
  add(make_union_v_points_layer);
}

UnionFamily inner_family(const StructureSet& set) {
  return {'A',
          set.get<AUnion>(),
          set.get<APowerDiagram>(),
          set.get<AVDiagram>(),
          set.get<ABallSampling>(),
          set.get<AGrownComplex>(),
          set.get<AScaleUnion>(),
          set.get<AScaleSampling>(),
          set.get<ASkeletonUnion>(),
          LayerGroup::union_a,
          true};
}
UnionFamily polar_family(const StructureSet& set) {
  return {'P',
          set.get<PUnion>(),
          set.get<PPowerDiagram>(),
          set.get<PVDiagram>(),
          set.get<PBallSampling>(),
          set.get<PGrownComplex>(),
          set.get<PScaleUnion>(),
          set.get<PScaleSampling>(),
          set.get<PSkeletonUnion>(),
          LayerGroup::union_p,
          true};
}
UnionFamily own_family(const StructureSet& set) {
  return {'B',
          set.get<BUnion>(),
          set.get<BPowerDiagram>(),
          set.get<BVDiagram>(),
          set.get<BBallSampling>(),
          set.get<BGrownComplex>(),
          set.get<BScaleUnion>(),
          set.get<BScaleSampling>(),
          set.get<BSkeletonUnion>(),
          LayerGroup::union_b,
          false};
}

}  // namespace

void add_union_layers(Registry& registry) {
  add_family(registry, inner_family, true);
  add_family(registry, polar_family, true);
  add_family(registry, own_family, false);
}

}  // namespace mes
