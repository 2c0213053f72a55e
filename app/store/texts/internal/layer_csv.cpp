// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/store/texts/internal/layer_writers.h"
#include "core/base/geometry/arc.h"
#include "core/draw/primitive_values.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

std::size_t csv_width(PrimitiveKind kind) {
  return kind == PrimitiveKind::arc ? 5 : doubles_per(kind);
}

void append_values(std::string& out, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i != 0) out += ',';
    append_number(out, values[i]);
  }
}

/// Pairs of numbers at the beginning of an instance that are positions. Others are directions.
std::size_t positions_of(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::segment: return 2;
    case PrimitiveKind::triangle:
    case PrimitiveKind::parabola: return 3;
    default: return 1;
  }
}

/// Appends one row without its scalar; arcs have angles in radians, a0 <= a1.
void append_coordinates(std::string& out, PrimitiveKind kind, std::span<const double> instance,
                        const std::optional<MapConversion>& conversion) {
  std::vector<double> values(instance.begin(), instance.end());
  if (kind == PrimitiveKind::arc) {
    const Arc arc = arc_of(instance.data());
    const Vec2 start = arc.from - arc.center;
    const double a0 = std::atan2(start.y, start.x);
    values = {arc.center.x, arc.center.y, arc.radius, a0, a0 + sweep_of(arc)};
  }
  for (std::size_t i = 0; conversion && i < positions_of(kind); ++i) {
    const Vec2 place = conversion->from_plane({values[2 * i], values[2 * i + 1]});
    values[2 * i] = place.x;
    values[2 * i + 1] = place.y;
  }
  append_values(out, values);
}

}  // namespace

std::string_view csv_columns(PrimitiveKind kind) {
  constexpr std::array<std::string_view, kPrimitiveKinds> names{"x,y",
                                                                "x,y,r",
                                                                "x,y,r",
                                                                "x1,y1,x2,y2",
                                                                "x,y,dx,dy",
                                                                "x,y,dx,dy",
                                                                "x1,y1,x2,y2,x3,y3",
                                                                "x,y,r,a0,a1",
                                                                "x1,y1,xc,yc,x2,y2"};
  return names[static_cast<std::size_t>(kind)];
}

Expected<LayerText> csv_of(const LayerGeometry& geometry) {
  const auto conversion = conversion_for(geometry, MapTarget::own_system);
  if (!conversion) return std::unexpected(conversion.error());
  const LayerIndex layer = geometry.layers.front();
  const LayerDescriptor& descriptor = geometry.registry.layers()[layer];
  const bool has_kind = descriptor.kinds.size() > 1;
  const bool has_scalar = !descriptor.scalar.empty();
  std::size_t columns = 0;
  std::string_view header;
  for (const PrimitiveKind kind : descriptor.kinds) {
    if (csv_width(kind) <= columns) continue;
    columns = csv_width(kind);
    header = csv_columns(kind);
  }
  LayerText out{(has_kind ? "kind," : "") + std::string(header) + (has_scalar ? ",scalar\n" : "\n")};
  for (const PrimitiveKind kind : descriptor.kinds) {
    const std::span<const double> instances = geometry.mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    for (std::size_t at = 0; at < instances.size(); at += stride) {
      const std::span<const double> values = instances.subspan(at, stride);
      if (kind == PrimitiveKind::segment && is_zero_length(values.data())) continue;
      if (has_kind) {
        out.text += name_of(kind);
        out.text += ',';
      }
      append_coordinates(out.text, kind, values.first(stride - 1), *conversion);
      out.text.append(columns - csv_width(kind), ',');
      if (has_scalar) {
        out.text += ',';
        append_number(out.text, values.back());
      }
      out.text += '\n';
    }
  }
  return out;
}

}  // namespace mes
