// SPDX-License-Identifier: GPL-3.0-or-later
#include <span>
#include <vector>

#include "app/store/texts/internal/dxf_text.h"
#include "app/store/texts/internal/layer_writers.h"
#include "app/store/texts/internal/plane_layer.h"
#include "app/store/texts/internal/shapes_on_earth.h"
#include "app/store/texts/internal/straight_shapes.h"
#include "core/document/document.h"

namespace mes {
namespace {

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
  LayerText out{DxfText::beginning(map && !is_projected ? map->plane_unit() : "")};
  for (const LayerIndex layer : geometry.layers) {
    DxfText dxf(out.text, geometry.registry.layers()[layer].id);
    if (is_projected)
      append_projected_layer(dxf, geometry, layer, **conversion, out);
    else
      out.left_out += write_plane_layer(dxf, geometry, layer);
  }
  out.text += DxfText::kEnd;
  return out;
}

}  // namespace mes
