// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "app/store/texts/internal/layer_writers.h"
#include "app/store/texts/internal/segment_chains.h"
#include "core/document/document.h"
#include "core/io/format.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

std::string poff_text(std::span<const Vec2> points, std::span<const SegmentChain> chains,
                      const std::optional<MapPlane>& map) {
  std::string out = fmt::format("POFF {} 0 0\n", points.size());
  for (const Vec2 p : points) {
    append_number(out, p.x);
    out += ' ';
    append_number(out, p.y);
    out += '\n';
  }
  append_map_line(out, map);
  for (const SegmentChain& chain : chains) {
    out += chain.closed ? "# loop closed" : "# loop open";
    for (const std::uint32_t point : chain.points) {
      out += ' ';
      out += std::to_string(point);
    }
    out += '\n';
  }
  return out;
}

struct Before {
  bool operator()(Vec2 a, Vec2 b) const { return lexicographically_less(a, b); }
};
using Normals = std::map<Vec2, Vec2, Before>;

// The layer of normals draws each normal as a segment that begins at its sample.
Normals normals_in(const LayerGeometry& geometry) {
  Normals out;
  const std::span<const double> segments = geometry.mirror.instances(
      find_layer(geometry.registry.layers(), LayerData::curve_normals), PrimitiveKind::segment);
  for (std::size_t at = 0; at < segments.size(); at += stride_of(PrimitiveKind::segment)) {
    const Vec2 from{segments[at], segments[at + 1]};
    const Vec2 way = Vec2{segments[at + 2], segments[at + 3]} - from;
    const double size = length(way);
    if (size > 0.0) out[from] = {way.x / size, way.y / size};
  }
  return out;
}

}  // namespace

Expected<LayerText> wpoff_of(const LayerGeometry& geometry) {
  const LayerIndex layer = geometry.layers.front();
  const LayerDescriptor& descriptor = geometry.registry.layers()[layer];
  if (descriptor.data == LayerData::balls) return LayerText{write_wpoff(geometry.document)};
  std::vector<Disk> balls;
  const PrimitiveKind kind = emits(descriptor, PrimitiveKind::disk) ? PrimitiveKind::disk : PrimitiveKind::circle;
  const std::span<const double> instances = geometry.mirror.instances(layer, kind);
  for (std::size_t at = 0; at < instances.size(); at += stride_of(kind))
    balls.push_back({{instances[at], instances[at + 1]}, instances[at + 2]});
  return LayerText{write_wpoff(balls)};
}

Expected<LayerText> poff_of(const LayerGeometry& geometry) {
  const LayerIndex layer = geometry.layers.front();
  const LayerDescriptor& descriptor = geometry.registry.layers()[layer];
  // Keeps the input order and the curve order of the input.
  if (descriptor.data == LayerData::samples) return LayerText{write_poff(geometry.document)};
  if (!emits(descriptor, PrimitiveKind::point)) {
    const SegmentChains found = chains_of(segments_of(geometry.mirror, layer, ParabolasAs::chains));
    return LayerText{poff_text(found.points, found.chains, geometry.document.map())};
  }
  std::vector<Vec2> points;
  const std::span<const double> instances = geometry.mirror.instances(layer, PrimitiveKind::point);
  for (std::size_t at = 0; at < instances.size(); at += stride_of(PrimitiveKind::point))
    points.push_back({instances[at], instances[at + 1]});
  return LayerText{poff_text(points, {}, geometry.document.map())};
}

Expected<LayerText> npoff_of(const LayerGeometry& geometry) {
  const Normals normals = normals_in(geometry);
  const SegmentChains found = chains_of(
      geometry.mirror.instances(find_layer(geometry.registry.layers(), LayerData::curve), PrimitiveKind::segment));
  LayerText out;
  for (const SegmentChain& chain : found.chains) {
    bool is_first = true;
    for (const std::uint32_t point : chain.points) {
      const Vec2 at = found.points[point];
      const auto normal = normals.find(at);
      if (normal == normals.end()) continue;  // ends and branch points have no normal
      if (std::exchange(is_first, false) && !out.text.empty()) out.text += '\n';
      append_number(out.text, at.x);
      out.text += ' ';
      append_number(out.text, at.y);
      out.text += "  ";
      append_number(out.text, normal->second.x);
      out.text += ' ';
      append_number(out.text, normal->second.y);
      out.text += '\n';
    }
  }
  return out;
}

}  // namespace mes
