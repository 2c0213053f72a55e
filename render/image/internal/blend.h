// SPDX-License-Identifier: GPL-3.0-or-later
// One pixel painted over another.
#pragma once

#include <cmath>

#include "core/base/color.h"
#include "render/image/image.h"

namespace mes::render {

/// Paints `color` over a pixel of a picture whose alpha is not multiplied in.
inline void blend(Image& image, int x, int y, Rgb color, double alpha) {
  std::uint8_t* const at = &image.rgba[image.offset(x, y)];
  const double below = at[3] / 255.0 * (1.0 - alpha);
  const double total = alpha + below;
  if (total <= 0.0) return;
  const auto mix = [&](std::uint8_t under, std::uint8_t over) {
    return static_cast<std::uint8_t>(std::lround((over * alpha + under * below) / total));
  };
  at[0] = mix(at[0], color.r);
  at[1] = mix(at[1], color.g);
  at[2] = mix(at[2], color.b);
  at[3] = static_cast<std::uint8_t>(std::lround(255.0 * total));
}

}  // namespace mes::render
