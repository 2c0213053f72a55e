// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/internal/straight_shapes.h"

#include <algorithm>
#include <span>
#include <utility>

#include "app/store/texts/internal/line_areas.h"
#include "app/store/texts/internal/round_shapes.h"
#include "app/store/texts/internal/segment_chains.h"
#include "core/draw/primitive_values.h"
#include "core/graph/registry.h"

namespace mes {
namespace {

StraightShape shape_of(PrimitiveKind kind, const double* v) {
  const Vec2 first{v[0], v[1]};
  switch (kind) {
    case PrimitiveKind::point: return {StraightKind::point, kind, {first}};
    case PrimitiveKind::circle: return {StraightKind::chain, kind, corners_of(Disk{first, v[2]}), Disk{first, v[2]}};
    case PrimitiveKind::disk: return {StraightKind::polygon, kind, corners_of(Disk{first, v[2]}), Disk{first, v[2]}};
    case PrimitiveKind::arc: return {StraightKind::chain, kind, corners_of(arc_of(v)), Disk{first, v[2]}};
    case PrimitiveKind::triangle: {
      std::vector<Vec2> corners{first, {v[2], v[3]}, {v[4], v[5]}};
      if (cross(corners[1] - first, corners[2] - first) < 0.0) std::swap(corners[1], corners[2]);
      corners.push_back(first);
      return {StraightKind::polygon, kind, std::move(corners)};
    }
    default: return {};
  }
}

void add_chains(std::span<const double> segments, bool has_scalar, std::vector<StraightShape>& out) {
  constexpr std::size_t kStride = stride_of(PrimitiveKind::segment);
  const SegmentChains found = chains_of(segments);
  for (const SegmentChain& chain : found.chains) {
    StraightShape& shape = out.emplace_back(StraightKind::chain, PrimitiveKind::segment);
    for (const std::uint32_t point : chain.points) shape.corners.push_back(found.points[point]);
    if (chain.closed) shape.corners.push_back(shape.corners.front());
    if (!has_scalar) continue;
    for (const std::uint32_t segment : chain.segments)
      shape.scalars.push_back(segments[segment * kStride + kStride - 1]);
  }
}

}  // namespace

std::vector<StraightShape> straight_shapes_of(const LayerGeometry& geometry, LayerIndex layer,
                                              std::uint64_t& left_out) {
  const LayerDescriptor& descriptor = geometry.registry.layers()[layer];
  const bool has_scalar = !descriptor.scalar.empty();
  bool has_chains = false;
  std::vector<StraightShape> out;
  for (const PrimitiveKind kind : descriptor.kinds) {
    const std::span<const double> instances = geometry.mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    if (kind == PrimitiveKind::ray || kind == PrimitiveKind::line) {
      left_out += instances.size() / stride;
      continue;
    }
    if (kind == PrimitiveKind::segment || kind == PrimitiveKind::parabola) {
      if (!std::exchange(has_chains, true))
        add_chains(segments_of(geometry.mirror, layer, ParabolasAs::chains), has_scalar, out);
      continue;
    }
    for (std::size_t at = 0; at < instances.size(); at += stride) {
      const double* const values = instances.data() + at;
      StraightShape& shape = out.emplace_back(shape_of(kind, values));
      if (has_scalar) shape.scalar = values[stride - 1];
    }
  }
  return out;
}

std::vector<StraightShape> area_shapes_of(const LayerGeometry& geometry, LayerIndex layer, LayerText& text) {
  std::vector<StraightShape> out = straight_shapes_of(geometry, layer, text.left_out);
  std::vector<std::vector<Vec2>> lines;
  for (StraightShape& shape : out)
    if (shape.kind == StraightKind::chain) lines.push_back(std::move(shape.corners));
  std::erase_if(out, [](const StraightShape& shape) { return shape.kind == StraightKind::chain; });
  LineAreas areas = areas_of(std::move(lines));
  text.without_area += areas.left_out;
  for (LineArea& area : areas.areas)
    out.push_back({.kind = StraightKind::polygon,
                   .of = PrimitiveKind::segment,
                   .corners = std::move(area.outer),
                   .holes = std::move(area.holes)});
  return out;
}

}  // namespace mes
