// SPDX-License-Identifier: GPL-3.0-or-later
// The user's own balls.
#include "core/layers/parts/helpers.h"
#include "core/structures/inputs/scaled_user_balls.h"

namespace mes {
namespace {

/// The balls as the kind of the descriptor. Those of radius 0 are points only.
Layer own_layer(const StructureSet& set, LayerDescriptor descriptor) {
  const auto& balls = set.get<ScaledUserBalls>();
  const PrimitiveKind kind = descriptor.kinds.front();
  return make_layer(std::move(descriptor), {&balls},
                    table_part(
                        {kind}, [&balls] { return balls.row_count(); }, balls.changes(),
                        [&balls, kind](BallSlot row, Instance& out) {
                          if (!balls.is_alive(row)) return;
                          const Disk disk = balls.disk(row);
                          if (disk.radius > 0.0 || kind == PrimitiveKind::point) draw_ball(kind, disk, out);
                        },
                        ElementType{ElementKind::own_ball}));
}

}  // namespace

Layer make_b_inner_disks_layer(const StructureSet& set) {
  return own_layer(set, {.id = "b-inner-disks",
                         .name = "Own balls: disks",
                         .tooltip = "Disks of your own balls",
                         .group = LayerGroup::union_b,
                         .of_any_family = "inner-disks",
                         .visible_at_start = true,
                         .scalar = "radius",
                         .style = {.color = palette::orange, .opacity = 0.2},
                         .kinds = {PrimitiveKind::disk}});
}

Layer make_b_inner_circles_layer(const StructureSet& set) {
  return own_layer(set, {.id = "b-inner-circles",
                         .name = "Own balls: circles",
                         .tooltip = "Circles of your own balls",
                         .group = LayerGroup::union_b,
                         .of_any_family = "inner-circles",
                         .visible_at_start = true,
                         .scalar = "radius",
                         .style = {.color = palette::orange, .opacity = 0.6},
                         .kinds = {PrimitiveKind::circle}});
}

Layer make_b_inner_centers_layer(const StructureSet& set) {
  return own_layer(
      set,
      {.id = "b-inner-centers",
       .name = "Own balls: centres",
       .tooltip = "Centres of your own balls; drag one to move its ball, turn the wheel on it to change the radius",
       .group = LayerGroup::union_b,
       .data = LayerData::balls,
       .of_any_family = "inner-centers",
       .visible_at_start = true,
       .scalar = "radius",
       .style = {.color = palette::orange, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}});
}

}  // namespace mes
