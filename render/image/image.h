// SPDX-License-Identifier: GPL-3.0-or-later
// A picture in memory. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mes::render {

/// RGBA, 8 bits a channel, not premultiplied, top row first, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  std::size_t offset(int x, int y) const {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  friend bool operator==(const Image&, const Image&) = default;
};

/// A picture as OpenGL returns it: RGBA, 8 bits a channel, premultiplied, bottom row first, no padding.
struct RawImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Reverses the order of the rows and divides by alpha. O(pixels), any thread.
Image to_image(const RawImage& raw);

}  // namespace mes::render
