// SPDX-License-Identifier: GPL-3.0-or-later
// The list of layers, in default stacking order: first = bottom. A new layer is a file that defines its `make`
// function, and two lines here.
#include "core/layers/layers.h"

#include <functional>
#include <vector>

#include "core/layers/parts/family.h"
#include "core/structures/poles/polar_union.h"

namespace mes {

Layer make_image_layer(const StructureSet&);
std::vector<Layer> make_sample_ball_disk_layers(const StructureSet&);
std::vector<Layer> make_filtered_disk_layers(const StructureSet&);
std::vector<Layer> make_scale_axis_disk_layers(const StructureSet&);
Layer make_b_inner_disks_layer(const StructureSet&);
Layer make_alpha_disks_layer(const StructureSet&);
Layer make_alpha_triangles_layer(const StructureSet&);
Layer make_last_change_layer(const StructureSet&);
Layer make_delaunay_layer(const StructureSet&);
Layer make_voronoi_layer(const StructureSet&);
Layer make_alpha_edges_layer(const StructureSet&);
Layer make_a_regular_triangulation_layer(const StructureSet&);
Layer make_a_power_diagram_layer(const StructureSet&);
Layer make_polar_triangulation_layer(const StructureSet&);
Layer make_polar_power_diagram_layer(const StructureSet&);
Layer make_anti_crust_edges_layer(const StructureSet&);
std::vector<Layer> make_sample_ball_circle_layers(const StructureSet&);
std::vector<Layer> make_filtered_circle_layers(const StructureSet&);
Layer make_b_inner_circles_layer(const StructureSet&);
Layer make_scale_axis_circles_layer(const StructureSet&);
Layer make_all_medial_axis_layer(const StructureSet&);
Layer make_curve_normals_layer(const StructureSet&);
Layer make_contours_layer(const StructureSet&);
Layer make_voronoi_crust_layer(const StructureSet&);
Layer make_power_crust_layer(const StructureSet&);
Layer make_curve_layer(const StructureSet&);
Layer make_sampling_epsilon_layer(const StructureSet&);
Layer make_medial_axis_layer(const StructureSet&);
Layer make_outline_axis_layer(const StructureSet&);
Layer make_transects_layer(const StructureSet&);
Layer make_center_lines_layer(const StructureSet&);
std::vector<Layer> make_kept_boundary_layers(const StructureSet&);
std::vector<Layer> make_removed_axis_layers(const StructureSet&);
std::vector<Layer> make_filtered_axis_layers(const StructureSet&);
Layer make_scale_axis_boundary_layer(const StructureSet&);
Layer make_scale_axis_layer(const StructureSet&);
Layer make_alpha_boundary_layer(const StructureSet&);
Layer make_alpha_holes_layer(const StructureSet&);
Layer make_label_conflicts_layer(const StructureSet&);
std::vector<Layer> make_sample_ball_center_layers(const StructureSet&);
Layer make_axis_nodes_layer(const StructureSet&);
Layer make_cover_dates_layer(const StructureSet&);
Layer make_alpha_components_layer(const StructureSet&);
Layer make_b_inner_centers_layer(const StructureSet&);
Layer make_points_layer(const StructureSet&);
Layer make_feature_size_layer(const StructureSet&);
Layer make_indices_layer(const StructureSet&);
Layer make_curve_defects_layer(const StructureSet&);
Layer make_theorem_check_layer(const StructureSet&);
Layer make_axis_difference_layer(const StructureSet&);
Layer make_axis_deviation_layer(const StructureSet&);
Layer make_precision_difference_layer(const StructureSet&);

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
void add_union_layers(Registry& registry, const FamilyOf& family_of, bool is_from_samples) {
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

void add_layers(Registry& registry) {
  registry.add_layer(make_image_layer);
  registry.add_layers(make_sample_ball_disk_layers);
  registry.add_layers(make_filtered_disk_layers);
  registry.add_layers(make_scale_axis_disk_layers);
  registry.add_layer(make_b_inner_disks_layer);
  registry.add_layer(make_alpha_disks_layer);
  registry.add_layer(make_alpha_triangles_layer);
  registry.add_layer(make_last_change_layer);
  registry.add_layer(make_delaunay_layer);
  registry.add_layer(make_voronoi_layer);
  registry.add_layer(make_alpha_edges_layer);
  registry.add_layer(make_a_regular_triangulation_layer);
  registry.add_layer(make_a_power_diagram_layer);
  registry.add_layer(make_polar_triangulation_layer);
  registry.add_layer(make_polar_power_diagram_layer);
  registry.add_layer(make_anti_crust_edges_layer);
  registry.add_layers(make_sample_ball_circle_layers);
  registry.add_layers(make_filtered_circle_layers);
  registry.add_layer(make_b_inner_circles_layer);
  registry.add_layer(make_scale_axis_circles_layer);
  registry.add_layer(make_all_medial_axis_layer);
  registry.add_layer(make_curve_normals_layer);
  registry.add_layer(make_contours_layer);
  registry.add_layer(make_voronoi_crust_layer);
  registry.add_layer(make_power_crust_layer);
  registry.add_layer(make_curve_layer);
  registry.add_layer(make_sampling_epsilon_layer);
  registry.add_layer(make_medial_axis_layer);
  registry.add_layer(make_outline_axis_layer);
  registry.add_layer(make_transects_layer);
  registry.add_layer(make_center_lines_layer);
  registry.add_layers(make_kept_boundary_layers);
  registry.add_layers(make_removed_axis_layers);
  registry.add_layers(make_filtered_axis_layers);
  registry.add_layer(make_scale_axis_boundary_layer);
  registry.add_layer(make_scale_axis_layer);
  registry.add_layer(make_alpha_boundary_layer);
  registry.add_layer(make_alpha_holes_layer);
  registry.add_layer(make_label_conflicts_layer);
  registry.add_layers(make_sample_ball_center_layers);
  registry.add_layer(make_axis_nodes_layer);
  registry.add_layer(make_cover_dates_layer);
  registry.add_layer(make_alpha_components_layer);
  registry.add_layer(make_b_inner_centers_layer);
  registry.add_layer(make_points_layer);
  registry.add_layer(make_feature_size_layer);
  registry.add_layer(make_indices_layer);
  registry.add_layer(make_curve_defects_layer);
  registry.add_layer(make_theorem_check_layer);
  registry.add_layer(make_axis_difference_layer);
  registry.add_layer(make_axis_deviation_layer);
  registry.add_layer(make_precision_difference_layer);
  add_union_layers(registry, inner_family, true);
  add_union_layers(registry, polar_family, true);
  add_union_layers(registry, own_family, false);
}

}  // namespace mes
