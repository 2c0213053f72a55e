// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>
#include <vector>

#include "app/store/internal/dxf_text.h"
#include "app/store/internal/layer_writers.h"
#include "app/store/internal/segment_chains.h"
#include "app/store/internal/shapes_on_earth.h"
#include "app/store/internal/straight_shapes.h"
#include "core/draw/primitive_values.h"

namespace mes {
namespace {

void append_chains(DxfText& dxf, std::span<const double> segments) {
  const SegmentChains found = chains_of(segments);
  std::vector<Vec2> corners;
  for (const SegmentChain& chain : found.chains) {
    corners.clear();
    for (const std::uint32_t point : chain.points) corners.push_back(found.points[point]);
    dxf.polyline(corners, chain.closed);
  }
}

void append_instance(DxfText& dxf, PrimitiveKind kind, const double* v) {
  switch (kind) {
    case PrimitiveKind::point: return dxf.point({v[0], v[1]});
    case PrimitiveKind::circle:
    case PrimitiveKind::disk: return dxf.circle({{v[0], v[1]}, v[2]});
    case PrimitiveKind::triangle:
      return dxf.polyline(std::array<Vec2, 3>{{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}}}, true);
    case PrimitiveKind::arc: return dxf.arc(arc_of(v));
    default: return;
  }
}

void append_plane_layer(DxfText& dxf, const LayerGeometry& geometry, LayerIndex layer, LayerText& out) {
  for (const PrimitiveKind kind : geometry.registry.layers()[layer].kinds) {
    const std::span<const double> instances = geometry.mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    if (kind == PrimitiveKind::ray || kind == PrimitiveKind::line)
      out.left_out += instances.size() / stride;
    else if (kind == PrimitiveKind::segment)
      append_chains(dxf, instances);
    else
      for (std::size_t at = 0; at < instances.size(); at += stride) append_instance(dxf, kind, instances.data() + at);
  }
}

/// In another system circles are none.
void append_projected_layer(DxfText& dxf, const LayerGeometry& geometry, LayerIndex layer,
                            const MapConversion& conversion, LayerText& out) {
  for (const StraightShape& shape : straight_shapes_of(geometry, layer, out.left_out)) {
    const auto parts = parts_on_earth(shape, conversion);
    if (parts.empty()) ++out.off_earth;
    for (const std::vector<Vec2>& part : parts) {
      const bool is_closed = part.size() > 2 && part.front() == part.back();
      if (shape.kind == StraightKind::point)
        dxf.point(part.front());
      else
        dxf.polyline(std::span(part).first(part.size() - (is_closed ? 1 : 0)), is_closed);
    }
  }
}

}  // namespace

Expected<LayerText> dxf_of(const LayerGeometry& geometry) {
  const auto& map = geometry.document.map();
  const bool is_projected = map && map->projection != MapProjection::none;
  const auto conversion = conversion_for(geometry, MapTarget::own_system);
  if (!conversion) return std::unexpected(conversion.error());
  LayerText out{std::string(DxfText::kBegin)};
  for (const LayerIndex layer : geometry.layers) {
    DxfText dxf(out.text, geometry.registry.layers()[layer].id);
    if (is_projected)
      append_projected_layer(dxf, geometry, layer, **conversion, out);
    else
      append_plane_layer(dxf, geometry, layer, out);
  }
  out.text += DxfText::kEnd;
  return out;
}

}  // namespace mes
