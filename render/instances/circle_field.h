// SPDX-License-Identifier: GPL-3.0-or-later
// The opacity of many circles of one colour, pixel by pixel, without painting them (`OpacityField`): for drawings with
// so many of them that a processor takes seconds to paint them.
//
// Guarantees:
//  1. The opacity of a pixel is that of painting the circles one over the other without rounding, to 1/1000: both edges
//     are ramps one pixel wide, as in `shaders/circle.frag`.
//  2. It is a function of the set of circles.
//
// Smallest use:
//     CircleField field(800, 600, 0.25, 1.0);
//     field.add(circles);
//     field.settle();
//     const std::uint16_t opacity = field.row(10)[20];  // of 65535
//
// Cost: `add` and `remove` O(rows + pixels of the line) a circle, on all cores when there are many. Threads: one at a
// time.
#pragma once

#include <span>

#include "render/instances/disk_field.h"

namespace mes::render {

class CircleField : public OpacityField {
 public:
  using Shape = PixelDisk;

  /// Both sizes are at least 1; `opacity` is that of one circle, in [0, 1]. A pixel whose centre is `half_width` from
  /// the rim is half covered; `half_width` is at least 0.5.
  CircleField(int width, int height, double opacity, double half_width)
      : OpacityField(width, height, opacity, Sums::plain), reach_(half_width + 0.5) {}

  /// The rims of these disks.
  void add(std::span<const PixelDisk> circles) { change(circles, 1); }
  /// The circles must have been added.
  void remove(std::span<const PixelDisk> circles) { change(circles, -1); }

 private:
  void change(std::span<const PixelDisk> circles, int sign);
  void change_rows(const PixelDisk& circle, std::int64_t times, RowRange rows);
  void change_pixels(const PixelDisk& circle, std::int64_t times, int y, int begin, int end);
  RowRange rows_of(const PixelDisk& circle) const;

  double reach_;  ///< distance from a circle to the nearest pixels that it does not touch
};

}  // namespace mes::render
