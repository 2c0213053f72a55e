// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/jitter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"

namespace mes {
namespace {

double length_along(const SampledCurves& samples) {
  double out = 0.0;
  for (const SampledCurves::Chain& chain : samples.chains) {
    const auto at = [&](std::size_t i) {
      const std::size_t place = chain.first + i % chain.count;
      return samples.positions[samples.order.empty() ? place : samples.order[place]];
    };
    for (std::size_t i = 0; i + (chain.is_closed ? 0 : 1) < chain.count; ++i) out += distance(at(i), at(i + 1));
  }
  return out;
}

/// Mean distance of samples along curves, or of isolated points as if spread evenly over their extent.
double mean_spacing(const SampledCurves& samples) {
  const std::size_t count = samples.positions.size();
  if (count < 2) return 0.0;
  if (!samples.chains.empty()) return length_along(samples) / static_cast<double>(count);
  Vec2 low = samples.positions.front();
  Vec2 high = low;
  for (const Vec2 p : samples.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double area = (high.x - low.x) * (high.y - low.y);
  return area > 0.0 ? std::sqrt(area / static_cast<double>(count))
                    : distance(low, high) / static_cast<double>(count - 1);
}

}  // namespace

void jitter(SampledCurves& samples, double amount, std::uint64_t seed) {
  if (amount == 0.0) return;
  const double reach = amount * mean_spacing(samples);
  // Makes the sequence differ from that of random points with the same seed.
  constexpr std::uint64_t kOther = 0x6a09e667f3bcc909;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  Rng random(seed ^ kOther);
  for (Vec2& p : samples.positions) {
    const double angle = random.uniform(0.0, kTurn);
    const double away = reach * std::sqrt(random.uniform());
    p = p + away * Vec2{std::cos(angle), std::sin(angle)};
  }
}

}  // namespace mes
