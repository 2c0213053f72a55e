// SPDX-License-Identifier: GPL-3.0-or-later
// The opacity of many strokes and dots of one colour, pixel by pixel, without painting them (`OpacityField`): for
// drawings with so many short lines that a processor spends its time on placing them.
//
// Guarantees:
//  1. The opacity of a pixel is that of painting the strokes one over the other without rounding, to 1/1000: ends are
//     round and rims are ramps one pixel wide, as in `shaders/stroke.frag` and `shaders/point.frag`.
//  2. It is a function of the set of strokes.
//
// Smallest use:
//     StrokeField field(800, 600, 0.25, 1.0);
//     field.add(strokes);
//     field.settle();
//     const std::uint16_t opacity = field.row(10)[20];  // of 65535
//
// Cost: `add` and `remove` O(rows + pixels) a stroke, on all cores when there are many. Threads: one at a time.
#pragma once

#include <optional>
#include <span>

#include "core/base/geometry/vec2.h"
#include "render/instances/opacity_field.h"

namespace mes::render {

/// In pixels; the origin is the lower left corner of the view, y up. A stroke with equal ends is a dot.
struct PixelStroke {
  float x = 0.0F;
  float y = 0.0F;
  float to_x = 0.0F;
  float to_y = 0.0F;
  std::int32_t times = 1;  ///< multiplicity
  friend bool operator==(const PixelStroke&, const PixelStroke&) = default;
};

class StrokeField : public OpacityField {
 public:
  using Shape = PixelStroke;

  /// Both sizes are at least 1; `opacity` is that of one stroke, in [0, 1]. A pixel whose centre is `half_width` from a
  /// stroke is half covered; `half_width` is at least 0.5.
  StrokeField(int width, int height, double opacity, double half_width)
      : OpacityField(width, height, opacity, Sums::plain), reach_(half_width + 0.5) {}

  /// Strokes as `visible` returns them.
  void add(std::span<const PixelStroke> strokes) { change(strokes, 1); }
  /// The strokes must have been added.
  void remove(std::span<const PixelStroke> strokes) { change(strokes, -1); }

  /// A stroke without the parts too far outside of a view of this size to be visible, where single precision could lose
  /// their position; nothing if no part remains.
  static std::optional<PixelStroke> visible(Vec2 from, Vec2 to, double width, double height, double half_width);

 private:
  void change(std::span<const PixelStroke> strokes, int sign);
  void change_rows(const PixelStroke& stroke, int sign, RowRange rows);
  RowRange rows_of(const PixelStroke& stroke) const {
    const float reach = static_cast<float>(reach_) + 0.5F;
    const float low = (stroke.y < stroke.to_y ? stroke.y : stroke.to_y) - reach;
    const float high = (stroke.y > stroke.to_y ? stroke.y : stroke.to_y) + reach;
    const auto top = static_cast<float>(height());
    const auto first = static_cast<int>(low > 0.0F ? (low < top ? low : top) : 0.0F);
    const auto end = static_cast<int>(high < top ? (high > 0.0F ? high : 0.0F) : top);
    return {first, end};
  }

  double reach_;  ///< distance from a stroke to the nearest pixels that it does not touch
};

}  // namespace mes::render
