// SPDX-License-Identifier: GPL-3.0-or-later
// The list of layers, in default stacking order: first = bottom. A new layer is a function `make_NAME_layer`
// in the file of its subject, or in a file of its own, and two lines here.
#include "core/layers/layers.h"

#include <vector>

#include "core/graph/layer.h"
#include "core/layers/union/union_layers.h"

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
  add_union_layers(registry);
}

}  // namespace mes
