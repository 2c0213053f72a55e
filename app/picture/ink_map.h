// SPDX-License-Identifier: GPL-3.0-or-later
// Where a picture has something drawn, found in its pixels, so that legends, cards and messages can avoid it.
//
// Guarantees: every pixel that differs visibly from the canvas counts, whatever drew it. Outside the picture nothing is
// drawn.
//
// Cost: making it O(pixels), some milliseconds a million; a question some microseconds. Threads: any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/color.h"
#include "core/base/geometry/box2.h"
#include "render/camera.h"
#include "render/image/image.h"

namespace mes {

class InkMap {
 public:
  /// Nothing is drawn.
  InkMap() = default;
  /// `picture`: as `camera` sees it, on a canvas of this colour, or on a transparent one.
  InkMap(const render::RawImage& picture, const render::Camera& camera, const std::optional<Rgb>& canvas);

  /// Divides a box, in pixels from the upper left, into about 64 nearly square parts, and counts those in which
  /// something is drawn. `now` is the camera that sees the drawing there.
  std::size_t parts_below(const Box2& box, const render::Camera& now) const;

 private:
  bool has_ink(const Box2& box) const;

  render::Camera camera_;
  int columns_ = 0;
  int rows_ = 0;
  /// Number of cells with ink above and to the left of each corner of a cell.
  std::vector<std::uint32_t> sums_;
};

}  // namespace mes
