// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/gray_image.h"

#include <algorithm>

namespace mes {

GrayImage halved(const GrayImage& image) {
  GrayImage out{(image.width + 1) / 2, (image.height + 1) / 2, {}};
  out.values.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const int right = std::min(2 * x + 1, image.width - 1);
      const int below = std::min(2 * y + 1, image.height - 1);
      const int sum =
          image.at(2 * x, 2 * y) + image.at(right, 2 * y) + image.at(2 * x, below) + image.at(right, below);
      out.values.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
    }
  return out;
}

}  // namespace mes
