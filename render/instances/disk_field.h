// SPDX-License-Identifier: GPL-3.0-or-later
// The opacity of many disks of one colour, pixel by pixel, without painting them (`OpacityField`).
//
// If k disks of opacity a cover a pixel, its opacity is 1 - (1 - a)^k. Along a row of pixels, k is a running sum of "+1
// where a disk begins, -1 where it ends" (`Sums::differences`). So the cost of a disk is that of its rows and the
// pixels of its rim instead of its area. A pixel at the rim whose part c is covered counts as the factor 1 - a c.
//
// Guarantees:
//  1. The opacity of a pixel is that of painting the disks one over the other without rounding, to 1/1000: rims are
//     ramps one pixel wide and disks smaller than a pixel are fainter, as in `shaders/disk.frag`.
//  2. It is a function of the set of disks.
//
// Smallest use:
//     DiskField field(800, 600, 0.25);
//     field.add(disks);
//     field.settle();
//     const std::uint16_t opacity = field.row(10)[20];  // of 65535
//
// Cost: `add` and `remove` O(rows + pixels at the rim) a disk, on all cores when there are many. Threads: one at a
// time.
#pragma once

#include <span>

#include "render/instances/opacity_field.h"

namespace mes::render {

/// In pixels; the origin is the lower left corner of the view, y up. The radius is 0 or larger, everything finite.
struct PixelDisk {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;
  std::int32_t times = 1;  ///< multiplicity
  friend bool operator==(const PixelDisk&, const PixelDisk&) = default;
};

class DiskField : public OpacityField {
 public:
  using Shape = PixelDisk;

  /// Both sizes are at least 1; `opacity` is that of one disk, in [0, 1].
  DiskField(int width, int height, double opacity) : OpacityField(width, height, opacity, Sums::differences) {}

  void add(std::span<const PixelDisk> disks) { change(disks, 1); }
  /// The disks must have been added.
  void remove(std::span<const PixelDisk> disks) { change(disks, -1); }

 private:
  /// A disk in the form that its rows need.
  struct Rim;

  void change(std::span<const PixelDisk> disks, int sign);
  /// Adds `times` disks; a negative number removes them.
  void change_rows(const Rim& rim, std::int32_t times, RowRange rows);
  void change_row(const Rim& rim, std::int32_t times, int y);
  template <class Take>
  static void for_each_at_rim(const Rim& rim, double dy, int begin, int end, Take take);
  void change_steep_rows(const Rim& rim, std::int32_t times, RowRange rows);
};

}  // namespace mes::render
