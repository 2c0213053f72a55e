// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/sample_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/rng.h"

namespace mes {
namespace {

constexpr std::size_t kProbes = 200;

// Searches squares that grow until one holds another place, and then the circle that this leaves open.
double to_nearest(const Document& document, const SampleIndex& index, Vec2 p, double first, double last) {
  double best = std::numeric_limits<double>::infinity();
  for (double reach = first; reach < 4.0 * last && best > reach; reach *= 2.0) {
    for (const SampleSlot slot : index.in_box({{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}})) {
      const double d = distance(document.position(slot), p);
      if (d > 0.0) best = std::min(best, d);
    }
  }
  return best;
}

}  // namespace

double typical_spacing(const Document& document, const SampleIndex& index) {
  if (document.sample_count() < 2) return 0.0;
  Box2 box;
  std::vector<SampleSlot> alive;
  alive.reserve(document.sample_count());
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count())) {
    if (!document.is_alive(slot)) continue;
    alive.push_back(slot);
    box.add(document.position(slot));
  }
  const double size = std::max(box.width(), box.height());
  if (!(size > 0.0)) return 0.0;
  const double first = 0.25 * size / static_cast<double>(alive.size());
  const Rng rng(1);
  std::vector<double> nearest;
  for (std::size_t i = 0; i < std::min(kProbes, alive.size()); ++i) {
    const std::size_t at = alive.size() <= kProbes ? i : static_cast<std::size_t>(rng.at(i) % alive.size());
    const double d = to_nearest(document, index, document.position(alive[at]), first, size);
    if (std::isfinite(d)) nearest.push_back(d);
  }
  if (nearest.empty()) return 0.0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

bool is_made_of_samples(const LayerDescriptor& descriptor) {
  return descriptor.group != LayerGroup::union_b && !descriptor.kinds.empty() &&
         descriptor.points_as == PointsAs::dots;
}

LayerStyle thinned(LayerStyle style, const LayerDescriptor& descriptor, double spacing_px) {
  constexpr double kDense = 2.0;     // logical pixels
  constexpr double kThinnest = 0.2;  // of the width in the style
  constexpr double kSmallestDot = 1.0;
  constexpr double kThinnestLine = 0.3;
  if (!style.thin_when_dense || !is_made_of_samples(descriptor) || !(spacing_px > 0.0) || spacing_px >= kDense)
    return style;
  const double factor = std::max(kThinnest, spacing_px / kDense);
  style.point_size_px = std::min(style.point_size_px, std::max(kSmallestDot, factor * style.point_size_px));
  style.line_width_px = std::min(style.line_width_px, std::max(kThinnestLine, factor * style.line_width_px));
  return style;
}

}  // namespace mes
