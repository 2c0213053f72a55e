// SPDX-License-Identifier: GPL-3.0-or-later
// A picture in shades of grey. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mes {

/// Values from 0 to 255, rows from the top, no padding.
struct GrayImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values{};

  std::uint8_t at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  friend bool operator==(const GrayImage&, const GrayImage&) = default;
};

/// Replaces two by two pixels by their mean; the last row or column of an odd size counts twice.
GrayImage halved(const GrayImage& image);

}  // namespace mes
