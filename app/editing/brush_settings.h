// SPDX-License-Identifier: GPL-3.0-or-later
// What the brush does, and how large it is. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mes {

enum class BrushMode : std::uint8_t {
  erase,   ///< all samples, and balls by their centres
  thin,    ///< every other sample along the curve
  refine,  ///< a sample between neighbours along the curve
};
inline constexpr std::size_t kBrushModes = 3;

struct BrushSettings {
  BrushMode mode = BrushMode::erase;
  double radius_px = 24.0;  ///< logical pixels, [4, 200]
  friend bool operator==(const BrushSettings&, const BrushSettings&) = default;
};

}  // namespace mes
