// SPDX-License-Identifier: GPL-3.0-or-later
// The balls grown by a factor, and the axis that this leaves.
#include "core/layers/parts/family.h"

namespace mes {
namespace {

/// Balls along the scale axis, with their radii divided by the factor again, as the kind of the descriptor.
Layer shrunk_layer(const UnionFamily& family, LayerDescriptor descriptor) {
  const AxisBallUnion& balls = family.scaled;
  const PrimitiveKind kind = descriptor.kinds.front();
  Layer layer = scale_layer(family, balls, std::move(descriptor),
                            sampled_part(
                                {kind}, family.scaled_sampling.medial(),
                                [&balls, kind](const Disk& disk, Instance& out) {
                                  draw_ball(kind, {disk.center, disk.radius / balls.factor()}, out);
                                },
                                &family.scaled_sampling));
  layer.structures.push_back(&family.scaled_sampling);
  layer.descriptor.structures.emplace_back(family.scaled_sampling.id());
  return layer;
}

}  // namespace

Layer make_union_scale_axis_disks_layer(const UnionFamily& family) {
  return shrunk_layer(family,
                      {.id = "scale-axis-disks",
                       .name = "scale axis disks",
                       .tooltip = "Disks along the scale axis, with their radii divided by scale-axis-factor again",
                       .scalar = "radius",
                       .style = {.color = palette::blue, .opacity = 0.15},
                       .kinds = {PrimitiveKind::disk}});
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
                       draw_ball(PrimitiveKind::disk, disk, out);
                     }));
}

Layer make_union_scale_axis_circles_layer(const UnionFamily& family) {
  return shrunk_layer(family,
                      {.id = "scale-axis-circles",
                       .name = "scale axis circles",
                       .tooltip = "Circles along the scale axis, with their radii divided by scale-axis-factor again",
                       .scalar = "radius",
                       .style = {.color = palette::blue, .opacity = 0.6},
                       .kinds = {PrimitiveKind::circle}});
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
