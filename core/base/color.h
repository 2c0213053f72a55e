// SPDX-License-Identifier: GPL-3.0-or-later
// sRGB colours, 8 bits a channel, and the Okabe-Ito palette (distinguishable without colour vision).
#pragma once

#include <cstdint>

namespace mes {

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  friend constexpr bool operator==(Rgb, Rgb) = default;
};

/// Source: Okabe and Ito, "Color Universal Design", 2008.
namespace palette {
inline constexpr Rgb black{0x00, 0x00, 0x00};
inline constexpr Rgb orange{0xE6, 0x9F, 0x00};
inline constexpr Rgb sky{0x56, 0xB4, 0xE9};
inline constexpr Rgb green{0x00, 0x9E, 0x73};
inline constexpr Rgb yellow{0xF0, 0xE4, 0x42};
inline constexpr Rgb blue{0x00, 0x72, 0xB2};
inline constexpr Rgb vermilion{0xD5, 0x5E, 0x00};
inline constexpr Rgb purple{0xCC, 0x79, 0xA7};
inline constexpr Rgb grey{0x99, 0x99, 0x99};
}  // namespace palette

}  // namespace mes
