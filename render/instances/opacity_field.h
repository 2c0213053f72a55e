// SPDX-License-Identifier: GPL-3.0-or-later
// The opacity of many shapes of one colour, pixel by pixel, without painting them: the common base of disk and stroke
// fields.
//
// A shape of opacity a that covers the part c of a pixel transmits the part 1 - a c of the colours below, and several
// shapes transmit the product of these factors. A field sums their logarithms as integers: so removing a shape undoes
// adding it, and neither the order of shapes nor the number of threads matters. Rounding happens once, at the end. Rows
// form bands, which different threads change, and which are updated after a change in them.
//
// Cost: `settle` O(pixels of the bands that changed). Memory: 10 bytes a pixel. Threads: one at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/jobs/parallel.h"

namespace mes::render {

/// Rows `first` (inclusive) to `end` (exclusive).
struct RowRange {
  int first = 0;
  int end = 0;
};

/// The least integer not below x, and the largest not above it, for |x| far inside the range of an int.
inline int ceil_of(double x) {
  const int cut = static_cast<int>(x);
  return cut + (static_cast<double>(cut) < x ? 1 : 0);
}
inline int floor_of(double x) {
  const int cut = static_cast<int>(x);
  return cut - (static_cast<double>(cut) > x ? 1 : 0);
}

/// Pixels `left` (inclusive) to `right` (exclusive) in some rows.
struct FieldPart {
  int left = 0;
  int right = 0;
  RowRange rows;
};

class OpacityField {
 public:
  int width() const { return width_; }
  int height() const { return height_; }

  /// Removes all shapes.
  void clear();
  /// Updates `row` and `rows`. Returns ranges of rows that may have changed, in order.
  std::span<const RowRange> settle();
  /// Disjoint parts of the field that contain all pixels of nonzero opacity. As of the last `settle`.
  std::vector<FieldPart> parts() const;
  /// Opacities in units of 1/65535, from left to right; row 0 is the lowest.
  std::span<const std::uint16_t> row(int y) const { return rows({y, y + 1}); }
  /// Successive rows, without gaps.
  std::span<const std::uint16_t> rows(RowRange range) const {
    return std::span(opacity_).subspan(static_cast<std::size_t>(range.first) * columns(),
                                       static_cast<std::size_t>(range.end - range.first) * columns());
  }

 protected:
  static constexpr int kBandRows = 16;
  static constexpr int kBlockColumns = 64;
  static constexpr int kSteps = 1024;       ///< resolution of the covered part of a pixel
  static constexpr float kHalfStep = 0.5F;  ///< half a step: truncation then rounds numbers that are not negative

  /// The target of shapes: the sum of each pixel, or the differences between neighbours in a row; in the latter, a run
  /// of covered pixels changes only those at its two ends.
  enum class Sums : std::uint8_t { plain, differences };
  /// Both sizes are at least 1; `opacity` is that of one shape, in [0, 1].
  OpacityField(int width, int height, double opacity, Sums kind);
  ~OpacityField() = default;
  OpacityField(OpacityField&&) = default;
  OpacityField& operator=(OpacityField&&) = default;

  std::size_t columns() const { return static_cast<std::size_t>(width_); }
  /// The addend of a pixel of which a shape covers `step` of `kSteps`.
  std::int64_t factor(std::size_t step) const { return factor_[step]; }
  /// `stride` numbers for each row: one a pixel, and for differences one more after the last pixel.
  std::int64_t* sums(int y) { return &sums_[static_cast<std::size_t>(y) * stride()]; }
  std::size_t stride() const { return columns() + (kind_ == Sums::differences ? 1 : 0); }
  void mark(RowRange rows) {
    for (int band = rows.first / kBandRows; band * kBandRows < rows.end; ++band)
      is_stale_[static_cast<std::size_t>(band)] = 1;
  }

  /// Calls `change(item, rows)` for all `rows_of(item)`, in parallel when there are many items; calls for the same band
  /// are never concurrent.
  template <class Item, class RowsOf, class Change>
  void change_by_bands(std::span<const Item> items, RowsOf rows_of, Change change) const;

 private:
  int bands() const { return (height_ + kBandRows - 1) / kBandRows; }
  int blocks() const { return (width_ + kBlockColumns - 1) / kBlockColumns; }
  RowRange rows_of(int band) const { return {band * kBandRows, std::min((band + 1) * kBandRows, height_)}; }
  static RowRange bands_of(RowRange rows) {
    return {rows.first / kBandRows, rows.first < rows.end ? (rows.end - 1) / kBandRows + 1 : 0};
  }
  void settle_band(int band);
  void settle_row(int y, std::span<std::uint8_t> is_visible);

  int width_;
  int height_;
  Sums kind_;
  /// -log2(1 - a c) in units of 2^-20, for c in steps.
  std::array<std::int64_t, kSteps + 1> factor_{};
  std::vector<std::int64_t> sums_;
  std::vector<std::uint16_t> opacity_;
  std::vector<std::uint8_t> is_stale_;    ///< by band
  std::vector<std::uint8_t> is_used_;     ///< by band: not empty now, or at some time since `clear`
  std::vector<std::uint8_t> is_visible_;  ///< by block of columns in a band: a pixel is not empty
  std::vector<RowRange> settled_;
};

template <class Item, class RowsOf, class Change>
void OpacityField::change_by_bands(std::span<const Item> items, RowsOf rows_of, Change change) const {
  constexpr std::size_t kFew = 64;  // handled without lists
  if (items.size() < kFew) {
    for (const Item& item : items) {
      const RowRange rows = rows_of(item);
      if (rows.first < rows.end) change(item, rows);
    }
    return;
  }
  // The items of each band, in one array: those of the first chunk, those of the second, and so on.
  const auto bands = static_cast<std::size_t>(this->bands());
  std::vector<std::size_t> place(chunk_count(items.size()) *
                                 bands);  // by chunk and band; first counts, then positions
  parallel_for(items.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    std::size_t* count = &place[chunk * bands];
    for (std::size_t i = begin; i < end; ++i) {
      const RowRange range = bands_of(rows_of(items[i]));
      for (int band = range.first; band < range.end; ++band) ++count[band];
    }
  });
  std::vector<std::size_t> start(bands + 1);
  std::size_t total = 0;
  for (std::size_t band = 0; band < bands; ++band) {
    start[band] = total;
    for (std::size_t at = band; at < place.size(); at += bands) total += std::exchange(place[at], total);
  }
  start[bands] = total;
  // Copies small items: otherwise threads of different bands would contend for each item.
  constexpr bool kCopies = sizeof(Item) <= 3 * sizeof(double);
  std::vector<std::conditional_t<kCopies, Item, std::uint32_t>> of_band(total);
  parallel_for(items.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    std::size_t* next = &place[chunk * bands];
    for (std::size_t i = begin; i < end; ++i) {
      const RowRange range = bands_of(rows_of(items[i]));
      for (int band = range.first; band < range.end; ++band) {
        if constexpr (kCopies)
          of_band[next[band]++] = items[i];
        else
          of_band[next[band]++] = static_cast<std::uint32_t>(i);
      }
    }
  });
  run_tasks(bands, [&](std::size_t band) {
    const int first = static_cast<int>(band) * kBandRows;
    for (std::size_t i = start[band]; i < start[band + 1]; ++i) {
      const Item& item = [&]() -> const Item& {
        if constexpr (kCopies)
          return of_band[i];
        else
          return items[of_band[i]];
      }();
      const RowRange rows = rows_of(item);
      change(item, RowRange{std::max(first, rows.first), std::min(first + kBandRows, rows.end)});
    }
  });
}

}  // namespace mes::render
