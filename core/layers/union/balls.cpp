// SPDX-License-Identifier: GPL-3.0-or-later
// The balls themselves, and samples of them.
#include "core/layers/parts/family.h"

namespace mes {
namespace {

/// The balls of the family, as the kind of the descriptor.
Layer family_layer(const UnionFamily& family, LayerDescriptor descriptor) {
  const PrimitiveKind kind = descriptor.kinds.front();
  return union_layer(family, std::move(descriptor),
                     ball_part(kind, family.balls,
                               [kind](BallState, const Disk& disk, Instance& out) { draw_ball(kind, disk, out); }));
}

/// Balls sampled along something, as the kind of the descriptor.
Layer sampled_layer(const UnionFamily& family, const SampledBalls& balls, LayerDescriptor descriptor) {
  const PrimitiveKind kind = descriptor.kinds.front();
  return union_layer_of(
      family, family.sampling, std::move(descriptor),
      sampled_part({kind}, balls, [kind](const Disk& disk, Instance& out) { draw_ball(kind, disk, out); }));
}

}  // namespace

Layer make_union_inner_disks_layer(const UnionFamily& family) {
  return family_layer(family, {.id = "inner-disks",
                               .name = "disks",
                               .tooltip = "Disks whose union is analysed",
                               .scalar = "radius",
                               .style = {.color = palette::orange, .opacity = 0.2, .flat = true},
                               .kinds = {PrimitiveKind::disk}});
}

Layer make_union_inner_circles_layer(const UnionFamily& family) {
  return family_layer(family, {.id = "inner-circles",
                               .name = "circles",
                               .tooltip = "Circles of the analysed disks",
                               .scalar = "radius",
                               .style = {.color = palette::orange, .opacity = 0.6},
                               .kinds = {PrimitiveKind::circle}});
}

Layer make_union_inner_centers_layer(const UnionFamily& family) {
  return family_layer(family, {.id = "inner-centers",
                               .name = "centres",
                               .tooltip = "Centres of the analysed disks",
                               .scalar = "radius",
                               .style = {.color = palette::orange, .point_size_px = 4},
                               .kinds = {PrimitiveKind::point}});
}

Layer make_union_ball_convex_disks_layer(const UnionFamily& family) {
  return sampled_layer(family, family.sampling.convex(),
                       {.id = "ball-convex-disks",
                        .name = "disks along dual edges",
                        .tooltip = "Disks interpolated along singular and regular dual edges",
                        .scalar = "radius",
                        .style = {.color = palette::purple, .opacity = 0.15, .flat = true},
                        .kinds = {PrimitiveKind::disk}});
}

Layer make_union_ball_convex_circles_layer(const UnionFamily& family) {
  return sampled_layer(family, family.sampling.convex(),
                       {.id = "ball-convex-circles",
                        .name = "circles along dual edges",
                        .tooltip = "Circles interpolated along singular and regular dual edges",
                        .scalar = "radius",
                        .style = {.color = palette::purple, .opacity = 0.5},
                        .kinds = {PrimitiveKind::circle}});
}

Layer make_union_ball_convex_centers_layer(const UnionFamily& family) {
  return sampled_layer(family, family.sampling.convex(),
                       {.id = "ball-convex-centers",
                        .name = "centres along dual edges",
                        .tooltip = "Centres interpolated along singular and regular dual edges",
                        .scalar = "radius",
                        .style = {.color = palette::purple, .point_size_px = 3.0},
                        .kinds = {PrimitiveKind::point}});
}

Layer make_union_ball_medial_disks_layer(const UnionFamily& family) {
  return sampled_layer(family, family.sampling.medial(),
                       {.id = "ball-medial-disks",
                        .name = "disks along the axis",
                        .tooltip = "Disks sampled along the medial axis of the union",
                        .scalar = "radius",
                        .style = {.color = palette::vermilion, .opacity = 0.15, .flat = true},
                        .kinds = {PrimitiveKind::disk}});
}

Layer make_union_ball_medial_circles_layer(const UnionFamily& family) {
  return sampled_layer(family, family.sampling.medial(),
                       {.id = "ball-medial-circles",
                        .name = "circles along the axis",
                        .tooltip = "Circles sampled along the medial axis of the union",
                        .scalar = "radius",
                        .style = {.color = palette::vermilion, .opacity = 0.5},
                        .kinds = {PrimitiveKind::circle}});
}

Layer make_union_ball_medial_centers_layer(const UnionFamily& family) {
  return sampled_layer(family, family.sampling.medial(),
                       {.id = "ball-medial-centers",
                        .name = "centres along the axis",
                        .tooltip = "Centres sampled along the medial axis of the union",
                        .scalar = "radius",
                        .style = {.color = palette::vermilion, .point_size_px = 3.0},
                        .kinds = {PrimitiveKind::point}});
}

Layer make_union_isolated_layer(const UnionFamily& family) {
  return union_layer(
      family,
      {.id = "isolated",
       .name = "isolated balls",
       .tooltip = "Balls that meet no other: dual vertices without an edge",
       .scalar = "radius",
       .style = {.color = palette::green, .point_size_px = 7},
       .kinds = {PrimitiveKind::point}},
      ball_part(PrimitiveKind::point, family.balls, [](BallState state, const Disk& disk, Instance& out) {
        if (state == BallState::isolated) draw_ball(PrimitiveKind::point, disk, out);
      }));
}

}  // namespace mes
