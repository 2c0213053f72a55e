// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/layer_summary.h"

#include <cmath>

#include "core/base/geometry/quick_length.h"
#include "core/base/geometry/vec2.h"

namespace mes {

std::string_view plural_of(PrimitiveKind kind) {
  constexpr std::array<std::string_view, kPrimitiveKinds> names{"points", "disks",     "circles", "segments", "rays",
                                                                "lines",  "triangles", "arcs",    "parabolas"};
  return names[static_cast<std::size_t>(kind)];
}

void LayerTally::add(PrimitiveKind kind, std::span<const double> values) {
  const std::size_t stride = stride_of(kind);
  counts_.count[static_cast<std::size_t>(kind)] += values.size() / stride;
  const auto for_each = [&](auto visit) {
    for (std::size_t at = 0; at < values.size(); at += stride) visit(values.data() + at);
  };
  switch (kind) {
    case PrimitiveKind::segment:
      for_each([this](const double* v) {
        if (is_zero_length(v)) {
          ++counts_.zero_length;
        } else {
          length_.add(quick_length({v[2] - v[0], v[3] - v[1]}));
        }
      });
      break;
    case PrimitiveKind::disk:
    case PrimitiveKind::circle: for_each([this](const double* v) { radius_sum_.add(v[2]); }); break;
    case PrimitiveKind::arc:
      for_each([this](const double* v) {
        const Arc arc = arc_of(v);
        length_.add(arc.radius * sweep_of(arc));
      });
      break;
    case PrimitiveKind::parabola:
      for_each([this](const double* v) { length_.add(length_of(parabola_of(v))); });
      break;
    case PrimitiveKind::triangle:
      for_each([this](const double* v) {
        const Vec2 corner{v[0], v[1]};
        area_.add(0.5 * std::abs(cross(Vec2{v[2], v[3]} - corner, Vec2{v[4], v[5]} - corner)));
      });
      break;
    case PrimitiveKind::point:
    case PrimitiveKind::ray:
    case PrimitiveKind::line: break;
  }
}

LayerSummary LayerTally::summary() const {
  LayerSummary out = counts_;
  out.count[static_cast<std::size_t>(PrimitiveKind::segment)] -= out.zero_length;
  out.length = length_.value();
  out.radius_sum = radius_sum_.value();
  out.area = area_.value();
  out.not_finite = static_cast<std::uint64_t>(length_.left_out() + radius_sum_.left_out() + area_.left_out());
  return out;
}

LayerSummary summarise(const LayerMirror& mirror, LayerIndex layer) {
  LayerTally tally;
  for (const PrimitiveKind kind : kAllPrimitiveKinds) tally.add(kind, mirror.instances(layer, kind));
  return tally.summary();
}

}  // namespace mes
