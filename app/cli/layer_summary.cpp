// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/layer_summary.h"

#include <cmath>
#include <span>

#include "core/base/sum.h"
#include "core/base/vec2.h"

namespace mes::cli {

std::string_view plural_of(PrimitiveKind kind) {
  constexpr std::array<std::string_view, kPrimitiveKinds> names{"points", "disks", "circles",   "segments",
                                                                "rays",   "lines", "triangles", "arcs"};
  return names[static_cast<std::size_t>(kind)];
}

LayerSummary summarise(const LayerMirror& mirror, LayerIndex layer) {
  LayerSummary out;
  Sum length_sum;
  Sum radius_sum;
  Sum area_sum;
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    const std::span<const double> instances = mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    std::uint64_t& count = out.count[static_cast<std::size_t>(kind)];
    count = instances.size() / stride;
    for (std::size_t at = 0; at < instances.size(); at += stride) {
      const double* const v = instances.data() + at;
      switch (kind) {
        case PrimitiveKind::segment:
          if (is_zero_length(v)) {
            ++out.zero_length;
          } else {
            length_sum.add(distance({v[0], v[1]}, {v[2], v[3]}));
          }
          break;
        case PrimitiveKind::disk:
        case PrimitiveKind::circle: radius_sum.add(v[2]); break;
        case PrimitiveKind::arc: {
          const Arc arc = arc_of(v);
          length_sum.add(arc.radius * sweep_of(arc));
          break;
        }
        case PrimitiveKind::triangle: {
          const Vec2 corner{v[0], v[1]};
          area_sum.add(0.5 * std::abs(cross(Vec2{v[2], v[3]} - corner, Vec2{v[4], v[5]} - corner)));
          break;
        }
        case PrimitiveKind::point:
        case PrimitiveKind::ray:
        case PrimitiveKind::line: break;
      }
    }
    if (kind == PrimitiveKind::segment) count -= out.zero_length;
  }
  out.length = length_sum.value();
  out.radius_sum = radius_sum.value();
  out.area = area_sum.value();
  out.not_finite = static_cast<std::uint64_t>(length_sum.left_out() + radius_sum.left_out() + area_sum.left_out());
  return out;
}

}  // namespace mes::cli
