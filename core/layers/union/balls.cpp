// SPDX-License-Identifier: GPL-3.0-or-later
// The balls themselves, and samples of them.
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_inner_disks_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "inner-disks",
       .name = "disks",
       .tooltip = "Disks whose union is analysed",

       .scalar = "radius",
       .style = {.color = palette::orange, .opacity = 0.2, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      table_part(
          {PrimitiveKind::disk}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] == BallState::none) return;
            const Disk disk = balls.family().disk(row);
            out.disk(disk.center, disk.radius, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

Layer make_union_inner_circles_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "inner-circles",
       .name = "circles",
       .tooltip = "Circles of the analysed disks",

       .scalar = "radius",
       .style = {.color = palette::orange, .opacity = 0.6},
       .kinds = {PrimitiveKind::circle}},
      table_part(
          {PrimitiveKind::circle}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] == BallState::none) return;
            const Disk disk = balls.family().disk(row);
            out.circle(disk.center, disk.radius, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

Layer make_union_inner_centers_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "inner-centers",
       .name = "centres",
       .tooltip = "Centres of the analysed disks",

       .scalar = "radius",
       .style = {.color = palette::orange, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}},
      table_part(
          {PrimitiveKind::point}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] == BallState::none) return;
            const Disk disk = balls.family().disk(row);
            out.point(disk.center, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

Layer make_union_ball_convex_disks_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-convex-disks",
       .name = "disks along dual edges",
       .tooltip = "Disks interpolated along singular and regular dual edges",
       .scalar = "radius",
       .style = {.color = palette::purple, .opacity = 0.15, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      sampled_part({PrimitiveKind::disk}, family.sampling.convex(),
                   [](const Disk& disk, Instance& out) { out.disk(disk.center, disk.radius, disk.radius); }));
}

Layer make_union_ball_convex_circles_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-convex-circles",
       .name = "circles along dual edges",
       .tooltip = "Circles interpolated along singular and regular dual edges",
       .scalar = "radius",
       .style = {.color = palette::purple, .opacity = 0.5},
       .kinds = {PrimitiveKind::circle}},
      sampled_part({PrimitiveKind::circle}, family.sampling.convex(),
                   [](const Disk& disk, Instance& out) { out.circle(disk.center, disk.radius, disk.radius); }));
}

Layer make_union_ball_convex_centers_layer(const UnionFamily& family) {
  return union_layer_of(family, family.sampling,
                        {.id = "ball-convex-centers",
                         .name = "centres along dual edges",
                         .tooltip = "Centres interpolated along singular and regular dual edges",
                         .scalar = "radius",
                         .style = {.color = palette::purple, .point_size_px = 3.0},
                         .kinds = {PrimitiveKind::point}},
                        sampled_part({PrimitiveKind::point}, family.sampling.convex(),
                                     [](const Disk& disk, Instance& out) { out.point(disk.center, disk.radius); }));
}

Layer make_union_ball_medial_disks_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-medial-disks",
       .name = "disks along the axis",
       .tooltip = "Disks sampled along the medial axis of the union",
       .scalar = "radius",
       .style = {.color = palette::vermilion, .opacity = 0.15, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      sampled_part({PrimitiveKind::disk}, family.sampling.medial(),
                   [](const Disk& disk, Instance& out) { out.disk(disk.center, disk.radius, disk.radius); }));
}

Layer make_union_ball_medial_circles_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-medial-circles",
       .name = "circles along the axis",
       .tooltip = "Circles sampled along the medial axis of the union",
       .scalar = "radius",
       .style = {.color = palette::vermilion, .opacity = 0.5},
       .kinds = {PrimitiveKind::circle}},
      sampled_part({PrimitiveKind::circle}, family.sampling.medial(),
                   [](const Disk& disk, Instance& out) { out.circle(disk.center, disk.radius, disk.radius); }));
}

Layer make_union_ball_medial_centers_layer(const UnionFamily& family) {
  return union_layer_of(family, family.sampling,
                        {.id = "ball-medial-centers",
                         .name = "centres along the axis",
                         .tooltip = "Centres sampled along the medial axis of the union",
                         .scalar = "radius",
                         .style = {.color = palette::vermilion, .point_size_px = 3.0},
                         .kinds = {PrimitiveKind::point}},
                        sampled_part({PrimitiveKind::point}, family.sampling.medial(),
                                     [](const Disk& disk, Instance& out) { out.point(disk.center, disk.radius); }));
}

Layer make_union_isolated_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "isolated",
       .name = "isolated balls",
       .tooltip = "Balls that meet no other: dual vertices without an edge",
       .in_paper = false,
       .scalar = "radius",
       .style = {.color = palette::green, .point_size_px = 7},
       .kinds = {PrimitiveKind::point}},
      table_part(
          {PrimitiveKind::point}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] != BallState::isolated) return;
            const Disk disk = balls.family().disk(row);
            out.point(disk.center, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

}  // namespace mes
