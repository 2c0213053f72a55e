// SPDX-License-Identifier: GPL-3.0-or-later
// The balls grown by a factor, and the axis that this leaves.
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_scale_axis_disks_layer(const UnionFamily& family) {
  const AxisBallUnion& balls = family.scaled;
  Layer layer =
      scale_layer(family, balls,
                  {.id = "scale-axis-disks",
                   .name = "scale axis disks",
                   .tooltip = "Disks along the scale axis, with their radii divided by scale-axis-factor again",
                   .scalar = "radius",
                   .style = {.color = palette::blue, .opacity = 0.15},
                   .kinds = {PrimitiveKind::disk}},
                  sampled_part(
                      {PrimitiveKind::disk}, family.scaled_sampling.medial(),
                      [&balls](const Disk& disk, Instance& out) {
                        const double radius = disk.radius / balls.factor();
                        out.disk(disk.center, radius, radius);
                      },
                      &family.scaled_sampling));
  layer.structures.push_back(&family.scaled_sampling);
  layer.descriptor.structures.emplace_back(family.scaled_sampling.id());
  return layer;
}

Layer make_union_scale_axis_grown_disks_layer(const UnionFamily& family) {
  return scale_layer(family, family.scaled,
                     {.id = "scale-axis-grown-disks",
                      .name = "scaled disks along the axis",
                      .tooltip = "Disks along the medial axis of the union, radii multiplied by scale-axis-factor",
                      .scalar = "radius",
                      .style = {.color = palette::sky, .opacity = 0.25, .flat = true},
                      .kinds = {PrimitiveKind::disk}},
                     ball_part(PrimitiveKind::disk, family.scaled, [](BallState, const Disk& disk, Instance& out) {
                       out.disk(disk.center, disk.radius, disk.radius);
                     }));
}

Layer make_union_scale_axis_circles_layer(const UnionFamily& family) {
  const AxisBallUnion& balls = family.scaled;
  Layer layer =
      scale_layer(family, balls,
                  {.id = "scale-axis-circles",
                   .name = "scale axis circles",
                   .tooltip = "Circles along the scale axis, with their radii divided by scale-axis-factor again",
                   .scalar = "radius",
                   .style = {.color = palette::blue, .opacity = 0.6},
                   .kinds = {PrimitiveKind::circle}},
                  sampled_part(
                      {PrimitiveKind::circle}, family.scaled_sampling.medial(),
                      [&balls](const Disk& disk, Instance& out) {
                        const double radius = disk.radius / balls.factor();
                        out.circle(disk.center, radius, radius);
                      },
                      &family.scaled_sampling));
  layer.structures.push_back(&family.scaled_sampling);
  layer.descriptor.structures.emplace_back(family.scaled_sampling.id());
  return layer;
}

Layer make_union_scale_axis_boundary_layer(const UnionFamily& family) {
  return scale_layer(
      family, family.scaled,
      {.id = "scale-axis-boundary",
       .name = "scaled boundary",
       .tooltip = "Boundary arcs of the union of the balls along the axis, radii multiplied by scale-axis-factor",
       .style = {.color = palette::sky, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::arc}},
      scale_axis_arcs(family.scaled));
}

Layer make_union_scale_axis_layer(const UnionFamily& family) {
  return scale_layer(
      family, family.scaled,
      {.id = "scale-axis",
       .name = "scale axis",
       .tooltip = "Medial axis of the union of the balls along the axis, radii multiplied by scale-axis-factor, "
                  "without spurious branches of the sampling, radii divided by it again",
       .scalar = "radius",
       .style = {.color = palette::vermilion, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::point}},
      scale_axis_pieces(family.scaled), scale_axis_points(family.scaled));
}

Layer make_union_scale_skeleton_layer(const UnionFamily& family) {
  return scale_layer(
      family, family.skeleton,
      {.id = "scale-skeleton",
       .name = "scale skeleton",
       .tooltip = "Scale axis reached in steps: after each, the balls along it replace the previous ones",
       .scalar = "radius",
       .style = {.color = palette::purple, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::point}},
      scale_axis_pieces(family.skeleton), scale_axis_points(family.skeleton));
}

}  // namespace mes
