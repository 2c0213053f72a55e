// SPDX-License-Identifier: GPL-3.0-or-later
// The opacity of many disks of one colour, pixel by pixel, without painting them.
//
// Where k disks of opacity a cover a pixel, the opacity there is 1 - (1 - a)^k, and k along a row of pixels is a running
// sum of "+1 where a disk begins, -1 where it ends". So a disk costs its rows and the pixels of its rim instead of its
// area. A pixel at the rim, of which a disk covers the part c, counts as the factor 1 - a c.
//
// What it guarantees:
//  1. The opacity of a pixel is that of painting the disks one over the other without rounding, to 1/1000: rims are
//     ramps one pixel wide and disks smaller than a pixel are fainter, as in `shaders/disk.frag`.
//  2. It is a function of the set of disks: all sums are of integers. Removing a disk undoes adding it, and neither the
//     order of disks nor the number of threads matters.
//
// Smallest use:
//     DiskField field(800, 600, 0.25);
//     field.add(disks);
//     field.settle();
//     const std::uint16_t opacity = field.row(10)[20];  // of 65535
//
// Cost: `add` and `remove` O(rows + pixels at the rim) a disk, on all cores when there are many; `settle` O(pixels of
// the bands that changed). Memory: 14 bytes a pixel. Threads: one at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mes::render {

/// In pixels; the origin is the lower left corner of the view, y up. The radius is 0 or larger, everything finite.
struct PixelDisk {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;
  friend bool operator==(const PixelDisk&, const PixelDisk&) = default;
};

/// Rows `first` up to, but not including, `end`.
struct RowRange {
  int first = 0;
  int end = 0;
};

class DiskField {
 public:
  /// Both sizes are at least 1; `opacity` is that of one disk, in [0, 1].
  DiskField(int width, int height, double opacity);

  int width() const { return width_; }
  int height() const { return height_; }

  void add(std::span<const PixelDisk> disks) { change(disks, 1); }
  /// The disks must have been added.
  void remove(std::span<const PixelDisk> disks) { change(disks, -1); }
  /// Brings `row` and `rows` up to date. Returns ranges of rows that may differ from before, in order.
  std::span<const RowRange> settle();
  /// Opacities of 65535, from left to right; the lowest row is 0.
  std::span<const std::uint16_t> row(int y) const { return rows({y, y + 1}); }
  /// Row after row, without gaps.
  std::span<const std::uint16_t> rows(RowRange range) const {
    return std::span(opacity_).subspan(static_cast<std::size_t>(range.first) * columns(),
                                       static_cast<std::size_t>(range.end - range.first) * columns());
  }

 private:
  /// A disk as its rows need it.
  struct Rim;
  static constexpr int kBandRows = 16;
  static constexpr int kSteps = 1024;  // of the part of a pixel that is covered

  std::size_t columns() const { return static_cast<std::size_t>(width_); }
  int bands() const { return (height_ + kBandRows - 1) / kBandRows; }
  void change(std::span<const PixelDisk> disks, int sign);
  void change_rows(const Rim& rim, int sign, RowRange rows);
  void change_row(const Rim& rim, int sign, int y);
  void change_steep_rows(const Rim& rim, int sign, RowRange rows);
  void settle_row(int y);

  int width_;
  int height_;
  /// -log2(1 - a c) in units of 2^-20, for c in steps.
  std::array<std::int64_t, kSteps + 1> factor_{};
  std::vector<std::int32_t> ends_;  ///< width + 1 a row: disks that begin here less those that ended before
  std::vector<std::int64_t> rims_;  ///< sums of `factor_` of the disks whose rim is here
  std::vector<std::uint16_t> opacity_;
  std::vector<std::uint8_t> is_stale_;  ///< by band
  std::vector<RowRange> settled_;
};

}  // namespace mes::render
