// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/sample_texts.h"

#include <fmt/core.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "core/base/rng.h"
#include "core/draw/variant.h"
#include "render/look.h"

namespace mes {
namespace {

/// At most this many samples compete for room.
constexpr std::size_t kMostTexts = 10'000;

/// 1, 5, 10, 50, 100, ...: each divides the next, so that a multiple of one is a multiple of all smaller ones.
constexpr std::uint64_t next_step(std::uint64_t step) {
  std::uint64_t leading = step;
  while (leading % 10 == 0) leading /= 10;
  return leading == 1 ? 5 * step : 2 * step;
}

/// The number of steps that divide a number; zero is the roundest.
int roundness(std::uint32_t number) {
  constexpr int kMostSteps = 64;
  if (number == 0) return kMostSteps;
  int out = 0;
  for (std::uint64_t step = 5; number % step == 0; step = next_step(step)) ++out;
  return out;
}

int digits_of(std::uint32_t number) {
  int out = 1;
  for (; number >= 10; number /= 10) ++out;
  return out;
}

/// A number that competes for room.
struct Candidate {
  SampleSlot sample;
  std::uint32_t number = 0;
  Vec2 at;             ///< position of the sample, in logical pixels from the upper left corner of the part, y down
  double width = 0.0;  ///< including the gap to the next number
  int roundness = 0;
  /// True if it is the one to show when there is room for one only.
  bool precedes(const Candidate& other) const {
    return roundness != other.roundness ? roundness > other.roundness : number < other.number;
  }
};

class Candidates {
 public:
  Candidates(const TextSource& source, const TextPart& part, const NumberRoom& room)
      : document_(source.document), index_(source.index), part_(part), room_(room) {
    const std::uint32_t last = document_.next_id().value - document_.first_id().value;
    widest_ = width_of(last);
    // Numbers that begin outside may reach into the part and take room there.
    const double reach =
        (2.0 * widest_ + 2.0 * room.height + std::abs(room.shift.x) + std::abs(room.shift.y)) * part.units_per_px;
    box_ = {part.box.low - Vec2{reach, reach}, part.box.high + Vec2{reach, reach}};
    collect();
  }

  std::vector<Candidate> take() { return std::move(out_); }
  double widest() const { return widest_; }

 private:
  double width_of(std::uint32_t number) const { return room_.digit * digits_of(number) + room_.apart; }

  void collect() {
    const std::size_t count = document_.sample_count();
    if (count <= kMostTexts) return add_all(1);
    const std::size_t seen = estimate();
    std::uint64_t step = 1;
    while (seen / step > kMostTexts) step = next_step(step);
    // A look-up by number is many times as fast as one by position.
    constexpr std::size_t kQuicker = 16;
    const std::size_t numbers = document_.next_id().value - document_.first_id().value;
    if (index_ != nullptr && numbers / step > kQuicker * seen) {
      for (const SampleSlot sample : index_->in_box(box_)) add(sample, step);
    } else {
      add_all(step);
    }
  }

  /// Estimates the number of samples in the box from some thousands of all.
  std::size_t estimate() const {
    constexpr std::uint64_t kProbes = 4096;
    const std::size_t rows = document_.slot_count();
    const Rng rng(1);
    std::size_t hits = 0;
    for (std::uint64_t i = 0; i < kProbes; ++i) {
      const SampleSlot sample(rng.at(i) % rows);
      hits += document_.is_alive(sample) && box_.contains(document_.position(sample)) ? 1U : 0U;
    }
    return hits * (rows / kProbes + 1);
  }

  void add_all(std::uint64_t step) {
    const SampleId first = document_.first_id();
    const std::uint64_t numbers = document_.next_id().value - first.value;
    for (std::uint64_t number = 0; number < numbers; number += step) {
      const SampleSlot sample = document_.slot_of(SampleId{first.value + static_cast<std::uint32_t>(number)});
      if (sample != kNoSlot && box_.contains(document_.position(sample))) add(sample, 1);
    }
  }

  void add(SampleSlot sample, std::uint64_t step) {
    const std::uint32_t number = number_of(document_, sample);
    if (number % step != 0) return;
    const Vec2 p = document_.position(sample);
    const Vec2 at{(p.x - part_.box.low.x) / part_.units_per_px, (part_.box.high.y - p.y) / part_.units_per_px};
    if (is_finite(at)) out_.push_back({sample, number, at, width_of(number), roundness(number)});
  }

  const Document& document_;
  const SampleIndex* index_;
  const TextPart& part_;
  const NumberRoom& room_;
  double widest_ = 0.0;
  Box2 box_;
  std::vector<Candidate> out_;
};

/// The chosen numbers, in a hash table of the cells that contain their samples: a cell is as wide as the narrowest
/// number and as high as all. Several cells may share an entry of the table, so each number found there is compared.
class TextCells {
 public:
  TextCells(std::span<const Candidate> candidates, Vec2 size, double widest)
      : candidates_(candidates),
        size_(size),
        reach_(static_cast<std::int64_t>(std::ceil(widest / size.x))),
        first_(std::bit_ceil(4 * candidates.size() + 1), kNone),
        next_(candidates.size(), kNone) {}

  /// Returns false if an added number overlaps it.
  bool has_room(const Candidate& candidate) const {
    const Cell cell = cell_of(candidate.at);
    for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y)
      for (std::int64_t x = cell.x - reach_; x <= cell.x + reach_; ++x)
        for (std::uint32_t i = first_[place_of({x, y})]; i != kNone; i = next_[i]) {
          const Vec2 apart = candidates_[i].at - candidate.at;
          if (std::abs(apart.y) < size_.y && apart.x < candidate.width && -apart.x < candidates_[i].width)
            return false;
        }
    return true;
  }
  void add(std::size_t i) {
    std::uint32_t& first = first_[place_of(cell_of(candidates_[i].at))];
    next_[i] = std::exchange(first, static_cast<std::uint32_t>(i));
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };
  Cell cell_of(Vec2 at) const {
    const auto whole = [](double x) {
      constexpr double kFar = 1e15;
      return static_cast<std::int64_t>(std::floor(std::clamp(x, -kFar, kFar)));
    };
    return {whole(at.x / size_.x), whole(at.y / size_.y)};
  }
  std::size_t place_of(const Cell& cell) const {
    // The factors are 2^64 divided by the golden ratio, and an odd number without pattern.
    std::uint64_t h = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15U;
    h ^= static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4FU;
    h ^= h >> 32U;
    return static_cast<std::size_t>(h) & (first_.size() - 1);
  }

  std::span<const Candidate> candidates_;
  Vec2 size_;
  std::int64_t reach_;
  std::vector<std::uint32_t> first_;  // by index in the table
  std::vector<std::uint32_t> next_;   // by index of the candidate
};

/// The radius of the dots in the layer `points`; 0 if it is hidden.
double dots_of(std::span<const LayerDescriptor> layers, std::span<const render::LayerView> views) {
  const LayerIndex points = find_layer(layers, "points");
  const auto found = std::ranges::find(views, points, &render::LayerView::layer);
  return found == views.end() ? 0.0 : 0.5 * render::point_size_of(found->style);
}

}  // namespace

std::uint32_t number_of(const Document& document, SampleSlot sample) {
  return document.id(sample).value - document.first_id().value;
}

std::vector<SampleSlot> numbers_with_room(const TextSource& source, const TextPart& part, const NumberRoom& room) {
  if (!(part.units_per_px > 0.0) || part.box.is_empty() || source.document.sample_count() == 0) return {};
  Candidates found(source, part, room);
  std::vector<Candidate> candidates = found.take();
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) { return a.precedes(b); });
  TextCells cells(candidates, {room.digit + room.apart, room.height}, found.widest());
  const double width = part.box.width() / part.units_per_px;
  const double height = part.box.height() / part.units_per_px;
  std::vector<SampleSlot> out;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& each = candidates[i];
    const Vec2 corner = each.at + room.shift;
    const bool is_seen =
        corner.x < width && corner.x + each.width > 0.0 && corner.y > 0.0 && corner.y - room.height < height;
    if (is_seen && cells.has_room(each)) out.push_back(each.sample);
    cells.add(i);
  }
  std::ranges::sort(out);
  return out;
}

void add_texts(std::span<const LayerDescriptor> layers, std::span<render::LayerView> views, const TextSource& source,
               const TextPart& part, const render::Font* font) {
  constexpr double kApart = 0.35;   // share of the size of the letters
  constexpr double kHeight = 0.75;  // distance from a digit to one of the line above
  constexpr double kGap = 2.5;
  const double diagonal = std::sqrt(0.5);
  for (render::LayerView& view : views) {
    if (layers[view.layer.layer].points_as == PointsAs::dots) continue;
    auto texts = std::make_shared<render::LayerTexts>();
    view.texts = texts;
    if (font == nullptr) continue;
    const double size = render::point_size_of(view.style);
    const double aside = diagonal * dots_of(layers, views) + kGap;
    double digit = 0.0;
    for (char c = '0'; c <= '9'; ++c) digit = std::max(digit, render::text_width(*font, size, std::string(1, c)));
    const NumberRoom room{digit, kApart * size, kHeight * size, {aside, -aside}};
    *texts = {*font, size, room.shift, {}};
    for (const SampleSlot sample : numbers_with_room(source, part, room))
      texts->texts.push_back(
          {source.document.position(sample), fmt::format("{}", number_of(source.document, sample))});
  }
}

}  // namespace mes
