// SPDX-License-Identifier: GPL-3.0-or-later
// Hands the shapes of a layer to the writer of a format that has circles and arcs, and perhaps Bézier curves.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/store/texts/internal/segment_chains.h"
#include "app/store/texts/layer_text.h"
#include "core/draw/primitive_values.h"
#include "core/graph/registry.h"

namespace mes {

/// Segments and parabolas of a layer are joined into chains. A chain is closed if the flag says so; then the first
/// corner is not repeated.
template <class Writer>
void write_chains(Writer& writer, const LayerMirror& mirror, LayerIndex layer) {
  constexpr bool kHasCurves = requires(std::span<const std::optional<Vec2>> none) {
    writer.chain({}, none, false);
  };
  const std::vector<double> lines =
      segments_of(mirror, layer, kHasCurves ? ParabolasAs::chords : ParabolasAs::chains);
  const SegmentChains found = chains_of(lines);
  std::vector<Vec2> corners;
  std::vector<std::optional<Vec2>> controls;
  for (const SegmentChain& chain : found.chains) {
    corners.clear();
    for (const std::uint32_t point : chain.points) corners.push_back(found.points[point]);
    if constexpr (kHasCurves) {
      const std::size_t straight = mirror.count(layer, PrimitiveKind::segment);
      const std::span<const double> curved = mirror.instances(layer, PrimitiveKind::parabola);
      controls.clear();
      for (const std::uint32_t i : chain.segments)
        controls.push_back(
            i < straight
                ? std::nullopt
                : std::optional(parabola_of(&curved[(i - straight) * stride_of(PrimitiveKind::parabola)]).control));
      writer.chain(corners, controls, chain.closed);
    } else {
      writer.polyline(corners, chain.closed);
    }
  }
}

/// `writer` has `point`, `circle`, `arc`, and `polyline`, whose flag says that it is closed; then the first corner is
/// not repeated. A writer of curves also has `chain`: a polyline with the control point of each side that is a
/// quadratic Bézier curve. Returns the number of rays and lines, which are left out.
template <class Writer>
std::uint64_t write_plane_layer(Writer& writer, const LayerGeometry& geometry, LayerIndex layer) {
  std::uint64_t left_out = 0;
  bool has_chains = false;
  for (const PrimitiveKind kind : geometry.registry.layers()[layer].kinds) {
    const std::span<const double> instances = geometry.mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    if (kind == PrimitiveKind::segment || kind == PrimitiveKind::parabola) {
      if (!std::exchange(has_chains, true)) write_chains(writer, geometry.mirror, layer);
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
        case PrimitiveKind::segment:
        case PrimitiveKind::parabola: break;
      }
    }
  }
  return left_out;
}

}  // namespace mes
