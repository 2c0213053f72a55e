// SPDX-License-Identifier: GPL-3.0-or-later
// The scale axis with its balls, and the underlying union of grown balls.
#include <vector>

#include "core/layers/parts/family.h"
#include "core/structures/balls/scale_axis.h"

namespace mes {
namespace {

LayerDescriptor descriptor_of(const char* id, const char* name, const char* tooltip, LayerStyle style,
                              std::vector<PrimitiveKind> kinds) {
  return {.id = id,
          .name = name,
          .tooltip = tooltip,
          .group = LayerGroup::scale_axis,
          .of_any_family = id,
          .scalar = "radius",
          .style = std::move(style),
          .kinds = std::move(kinds)};
}

Layer grown_disks(const StructureSet& set) {
  const auto& balls = set.get<ScaleUnion>();
  return make_layer(descriptor_of("scale-axis-grown-disks", "Scaled disks",
                                  "Disks along the medial axis, radii multiplied by scale-axis-factor",
                                  {.color = palette::sky, .opacity = 0.25, .flat = true}, {PrimitiveKind::disk}),
                    {&balls}, ball_part(PrimitiveKind::disk, balls, [](BallState, const Disk& disk, Instance& out) {
                      out.disk(disk.center, disk.radius, disk.radius);
                    }));
}

Layer shrunk_disks(const StructureSet& set) {
  const auto& balls = set.get<ScaleUnion>();
  const auto& sampling = set.get<ScaleBallSampling>();
  return make_layer(descriptor_of("scale-axis-disks", "Scale axis disks",
                                  "Disks along the scale axis, with their radii divided by scale-axis-factor again",
                                  {.color = palette::blue, .opacity = 0.15}, {PrimitiveKind::disk}),
                    {&balls, &sampling},
                    sampled_part(
                        {PrimitiveKind::disk}, sampling.medial(),
                        [&balls](const Disk& disk, Instance& out) {
                          const double radius = disk.radius / balls.factor();
                          out.disk(disk.center, radius, radius);
                        },
                        &sampling));
}

}  // namespace

std::vector<Layer> make_scale_axis_disk_layers(const StructureSet& set) {
  std::vector<Layer> out;
  out.push_back(grown_disks(set));
  out.push_back(shrunk_disks(set));
  return out;
}

Layer make_scale_axis_circles_layer(const StructureSet& set) {
  const auto& balls = set.get<ScaleUnion>();
  const auto& sampling = set.get<ScaleBallSampling>();
  return make_layer(descriptor_of("scale-axis-circles", "Scale axis circles",
                                  "Circles along the scale axis, with their radii divided by scale-axis-factor again",
                                  {.color = palette::blue, .opacity = 0.6}, {PrimitiveKind::circle}),
                    {&balls, &sampling},
                    sampled_part(
                        {PrimitiveKind::circle}, sampling.medial(),
                        [&balls](const Disk& disk, Instance& out) {
                          const double radius = disk.radius / balls.factor();
                          out.circle(disk.center, radius, radius);
                        },
                        &sampling));
}

Layer make_scale_axis_boundary_layer(const StructureSet& set) {
  const auto& balls = set.get<ScaleUnion>();
  LayerDescriptor descriptor =
      descriptor_of("scale-axis-boundary", "Scaled boundary", "Boundary arcs of the union of the scaled disks",
                    {.color = palette::sky, .line_width_px = 1.5}, {PrimitiveKind::arc});
  descriptor.scalar = {};
  return make_layer(std::move(descriptor), {&balls}, scale_axis_arcs(balls));
}

Layer make_scale_axis_layer(const StructureSet& set) {
  const auto& balls = set.get<ScaleUnion>();
  return make_layer(descriptor_of("scale-axis", "Scale axis",
                                  "Medial axis of the union of the scaled disks without spurious branches of the "
                                  "sampling, radii divided by scale-axis-factor again",
                                  {.color = palette::vermilion, .line_width_px = 2.5},
                                  {PrimitiveKind::segment, PrimitiveKind::point}),
                    {&balls}, scale_axis_pieces(balls), scale_axis_points(balls));
}

}  // namespace mes
