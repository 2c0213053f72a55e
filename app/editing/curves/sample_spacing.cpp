// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/curves/sample_spacing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/rng.h"

namespace mes {
namespace {

constexpr std::size_t kProbes = 200;

struct Probe {
  std::uint64_t key = 0;
  Vec2 at;
  double nearest = std::numeric_limits<double>::infinity();
};

template <class Visit>
void visit_places(const Document& document, const Visit& visit) {
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot)) visit(document.position(slot));
}

/// A pseudo-random number for the point; 0 and -0 give the same.
std::uint64_t key_of(Vec2 p) {
  return Rng(std::bit_cast<std::uint64_t>(p.x + 0.0)).at(std::bit_cast<std::uint64_t>(p.y + 0.0));
}

/// Keeps the probes with the least keys, each key once, by increasing key.
void keep_least(std::vector<Probe>& probes, std::uint64_t key, Vec2 at) {
  if (probes.size() == kProbes && key >= probes.back().key) return;
  const auto place = std::ranges::lower_bound(probes, key, {}, &Probe::key);
  if (place != probes.end() && place->key == key) return;
  probes.insert(place, {key, at});
  if (probes.size() > kProbes) probes.pop_back();
}

/// If there are many samples, chooses some at random by their index in input order, which files keep: samples that
/// move, as in an evolution, stay chosen, or the median would jump from step to step. If some of those coincide, or
/// there are few, chooses positions at random.
std::vector<Probe> choose_probes(const Document& document) {
  std::vector<Probe> out;
  if (document.sample_count() > kProbes) {
    const Rng random(1);
    std::uint64_t number = 0;
    for (const SampleSlot slot : document.slots_in_input_order())
      keep_least(out, random.at(number++), document.position(slot));
    std::vector<Vec2> places;
    for (const Probe& probe : out) places.push_back(probe.at);
    std::ranges::sort(places, lexicographically_less);
    if (std::ranges::adjacent_find(places) == places.end()) return out;
    out.clear();
  }
  visit_places(document, [&out](Vec2 p) { keep_least(out, key_of(p), p); });
  return out;
}

/// A grid of probes, each listed in its own cell and the eight around it.
class ProbeGrid {
 public:
  ProbeGrid(std::vector<Probe>& probes, double reach) : probes_(probes), size_((1.0 + 1e-9) * reach) {
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const Cell cell = cell_of(probes[i].at);
      for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x)
        for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y) entries_.push_back({key_of({x, y}), i});
    }
    std::ranges::sort(entries_, {}, &Entry::key);
    for (const Entry& entry : entries_) is_used_.set(entry.key % kBits);
  }

  /// Measures the distances from the point to the probes near it.
  void meet(Vec2 p) {
    const std::uint64_t key = key_of(cell_of(p));
    if (!is_used_.test(key % kBits)) return;
    for (auto at = std::ranges::lower_bound(entries_, key, {}, &Entry::key); at != entries_.end() && at->key == key;
         ++at) {
      Probe& probe = probes_[at->probe];
      if (const double d = distance(probe.at, p); d > 0.0) probe.nearest = std::min(probe.nearest, d);
    }
  }

 private:
  static constexpr std::size_t kBits = std::size_t{1} << 16U;
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };
  struct Entry {
    std::uint64_t key = 0;
    std::size_t probe = 0;
  };

  // Relative to a probe, so that points far from the origin have cells, too.
  Cell cell_of(Vec2 p) const {
    const auto number = [this](double value) {
      constexpr double kFarthest = 4e15;
      return static_cast<std::int64_t>(std::floor(std::clamp(value / size_, -kFarthest, kFarthest)));
    };
    const Vec2 from = p - probes_.front().at;
    return {number(from.x), number(from.y)};
  }
  static std::uint64_t key_of(Cell cell) {
    std::uint64_t h = static_cast<std::uint64_t>(cell.x) * 0x9e3779b97f4a7c15U;
    h = (h ^ (h >> 32U) ^ static_cast<std::uint64_t>(cell.y)) * 0xff51afd7ed558ccdU;
    return h ^ (h >> 32U);
  }

  std::vector<Probe>& probes_;
  double size_;
  std::vector<Entry> entries_;
  std::bitset<kBits> is_used_;
};

/// The median is finite only if more than half of the probes have a neighbour.
double median_of_nearest(const std::vector<Probe>& probes) {
  std::vector<double> nearest;
  for (const Probe& probe : probes) nearest.push_back(probe.nearest);
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

}  // namespace

// The probes alone give a median distance as an upper bound. With more points, nearest distances shrink about in
// proportion to their number; the search is wider if half of the probes have no neighbour within that.
double typical_spacing(const Document& document) {
  std::vector<Probe> probes = choose_probes(document);
  if (probes.size() < 2) return 0.0;
  for (Probe& probe : probes)
    for (const Probe& other : probes)
      if (&other != &probe) probe.nearest = std::min(probe.nearest, distance(probe.at, other.at));
  const double among_probes = median_of_nearest(probes);
  if (probes.size() < kProbes) return among_probes;
  const double share = static_cast<double>(kProbes) / static_cast<double>(document.sample_count());
  for (double reach = 2.0 * std::sqrt(share) * among_probes;; reach *= 4.0) {
    reach = std::min(reach, among_probes);
    if (!(reach > 0.0)) return among_probes;
    ProbeGrid grid(probes, reach);
    visit_places(document, [&grid](Vec2 p) { grid.meet(p); });
    if (const double found = median_of_nearest(probes); found <= reach) return found;
  }
}

double FollowedSpacing::of(const Document& document, std::uint64_t origin) {
  const std::uint64_t digest = document.sample_digest();
  const std::size_t count = document.sample_count();
  const int magnitude = document.magnitudes().most;
  const std::size_t change = std::max(count, count_) - std::min(count, count_);
  const bool is_same = digest == digest_ && count == count_;
  const bool may_wait = count > kAlwaysMeasured && 10 * change <= count_ && magnitude == magnitude_;
  if (origin == origin_ && is_same) return spacing_;
  if (origin == origin_ && may_wait && digest != changed_to_) {
    changed_to_ = digest;
    return spacing_;
  }
  digest_ = digest;
  origin_ = origin;
  count_ = count;
  magnitude_ = magnitude;
  spacing_ = typical_spacing(document);
  return spacing_;
}

bool is_made_of_samples(const LayerDescriptor& descriptor) {
  return descriptor.group != LayerGroup::union_b && !descriptor.kinds.empty() &&
         descriptor.points_as == PointsAs::dots;
}

LayerStyle thinned(LayerStyle style, const LayerDescriptor& descriptor, double spacing_px) {
  constexpr double kShareOfSpacing = 0.7;
  constexpr double kSmallestApart = 1.5;  // logical pixels, like the others
  constexpr double kSmallestOfOthers = 2.5;
  constexpr double kLargestDot = 5.0;  // larger ones mark single places
  constexpr double kDense = 2.0;
  constexpr double kThinnest = 0.2;  // share of the width in the style
  constexpr double kSmallestDot = 1.0;
  constexpr double kThinnestLine = 0.3;
  if (!style.thin_when_dense || !is_made_of_samples(descriptor) || !(spacing_px > 0.0)) return style;
  const double point = style.point_size_px;
  const bool is_of_dots = std::ranges::equal(descriptor.kinds, std::array{PrimitiveKind::point}) &&
                          descriptor.style.point_size_px <= kLargestDot;
  const double smallest = descriptor.data == LayerData::samples ? kSmallestApart : kSmallestOfOthers;
  if (is_of_dots && point == descriptor.style.point_size_px)
    style.point_size_px = std::min(point, std::max(smallest, kShareOfSpacing * spacing_px));
  if (spacing_px >= kDense) return style;
  const double factor = std::max(kThinnest, spacing_px / kDense);
  style.point_size_px = std::min(style.point_size_px, std::max(kSmallestDot, factor * point));
  style.line_width_px = std::min(style.line_width_px, std::max(kThinnestLine, factor * style.line_width_px));
  return style;
}

}  // namespace mes
