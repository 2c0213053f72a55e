// SPDX-License-Identifier: GPL-3.0-or-later
// Hands the shapes of a layer to the writer of a format that has circles and arcs.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/store/internal/segment_chains.h"
#include "app/store/layer_text.h"
#include "core/draw/primitive_values.h"
#include "core/graph/registry.h"

namespace mes {

/// `writer` has `point`, `circle`, `arc`, and `polyline`, whose flag says that it is closed; then the first corner is
/// not repeated. Segments are joined into chains. Returns the number of rays and lines, which are left out.
template <class Writer>
std::uint64_t write_plane_layer(Writer& writer, const LayerGeometry& geometry, LayerIndex layer) {
  std::uint64_t left_out = 0;
  for (const PrimitiveKind kind : geometry.registry.layers()[layer].kinds) {
    const std::span<const double> instances = geometry.mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    if (kind == PrimitiveKind::segment) {
      const SegmentChains found = chains_of(instances);
      std::vector<Vec2> corners;
      for (const SegmentChain& chain : found.chains) {
        corners.clear();
        for (const std::uint32_t point : chain.points) corners.push_back(found.points[point]);
        writer.polyline(corners, chain.closed);
      }
      continue;
    }
    for (std::size_t at = 0; at < instances.size(); at += stride) {
      const double* const v = instances.data() + at;
      switch (kind) {
        case PrimitiveKind::point: writer.point({v[0], v[1]}); break;
        case PrimitiveKind::circle:
        case PrimitiveKind::disk: writer.circle({{v[0], v[1]}, v[2]}); break;
        case PrimitiveKind::triangle:
          writer.polyline(std::array<Vec2, 3>{{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}}}, true);
          break;
        case PrimitiveKind::arc: writer.arc(arc_of(v)); break;
        case PrimitiveKind::ray:
        case PrimitiveKind::line: ++left_out; break;
        case PrimitiveKind::segment: break;
      }
    }
  }
  return left_out;
}

}  // namespace mes
