// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of shapes that are known by a formula.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/geometry/vec2.h"
#include "core/raster/gray_image.h"

namespace mes {

/// Samples along each side of a pixel.
constexpr int kFine = 16;

/// White where `is_inside(Vec2)`, in the coordinates of the plane (core/raster/contours.h); each pixel is the mean of
/// `fine` by `fine` places in it. One place gives a picture of two values.
template <class Inside>
GrayImage rendered(int width, int height, int fine, Inside is_inside) {
  GrayImage out{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      int hits = 0;
      for (int i = 0; i < fine; ++i)
        for (int k = 0; k < fine; ++k)
          hits += is_inside(Vec2{x + (i + 0.5) / fine, height - y - (k + 0.5) / fine}) ? 1 : 0;
      out.values.push_back(static_cast<std::uint8_t>(std::lround(255.0 * hits / (fine * fine))));
    }
  return out;
}

inline GrayImage inverted(GrayImage image) {
  for (std::uint8_t& value : image.values) value = static_cast<std::uint8_t>(255 - value);
  return image;
}

inline GrayImage transposed(const GrayImage& image) {
  GrayImage out{image.height, image.width, {}};
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) out.values.push_back(image.at(y, x));
  return out;
}

}  // namespace mes
