// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels of pictures, and styles to draw them in.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "core/draw/layer_style.h"
#include "render/image/image.h"

namespace mes::test {

inline Rgb pixel(const render::Image& image, int x, int y) {
  const std::size_t at = image.offset(x, y);
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

inline int largest_difference(const render::Image& a, const render::Image& b) {
  int worst = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) worst = std::max(worst, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
  return worst;
}

inline LayerStyle black(double width_px = 1.0, double point_px = 5.0) {
  LayerStyle out;
  out.line_width_px = width_px;
  out.point_size_px = point_px;
  return out;
}

}  // namespace mes::test
