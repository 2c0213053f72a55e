// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which samples enter a new triangulation, and the line that cuts many samples in two.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/kernel/point_predicates.h"
#include "core/structures/delaunay/internal/delaunay_stitch.h"
#include "core/structures/triangulation/hilbert.h"

namespace mes {

/// Biased randomised insertion order (Amenta, Choi, Rote 2003): rounds of doubling size, each along a Hilbert curve.
/// The rounds protect against bad inputs; the curve keeps the walk to each new site short. `position(slot)` returns the
/// position of a sample.
template <class Position>
std::vector<Keyed<SampleSlot>> insertion_order(const std::vector<SampleSlot>& samples, const Box2& extent,
                                               Position position) {
  constexpr int kRoundBits = 3;
  const HilbertGrid grid(extent);
  const int rounds = std::max(0, static_cast<int>(std::bit_width(samples.size())) - 6) / kRoundBits;
  std::vector<Keyed<SampleSlot>> order;
  order.reserve(samples.size());
  for (const SampleSlot sample : samples) {
    const std::uint32_t hash = (sample.index() + 1U) * 2654435769U;
    const int round = rounds - std::min(rounds, std::countl_zero(hash ^ (hash << 15U)) / kRoundBits);
    order.push_back({(std::uint64_t(static_cast<unsigned>(round)) << 32U) | grid.key(position(sample)), sample});
  }
  std::vector<Keyed<SampleSlot>> scratch;
  radix_sort(order, scratch, 38);
  return order;
}

/// Two sets of about the same size, divided by a line across the longer side: `near` comes before `far`. One of them
/// is empty when all samples coincide.
struct Halves {
  std::vector<SampleSlot> near;
  std::vector<SampleSlot> far;
  SweepOrder before;
};

template <class Position>
Halves cut_in_two(const std::vector<SampleSlot>& samples, Position position) {
  Halves halves;
  if (samples.empty()) return halves;
  // The median of some hundred samples is close enough to that of all.
  constexpr std::size_t kProbes = 255;
  std::vector<Vec2> probes;
  Box2 extent;
  for (std::size_t i = 0; i < kProbes; ++i) {
    probes.push_back(position(samples[samples.size() * i / kProbes]));
    extent.add(probes.back());
  }
  halves.before.along_y = extent.height() > extent.width();
  const auto middle = probes.begin() + kProbes / 2;
  std::nth_element(probes.begin(), middle, probes.end(), halves.before);
  halves.near.reserve(samples.size());
  halves.far.reserve(samples.size());
  for (const SampleSlot sample : samples)
    (halves.before(position(sample), *middle) ? halves.near : halves.far).push_back(sample);
  return halves;
}

}  // namespace mes
