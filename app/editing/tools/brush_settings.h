// SPDX-License-Identifier: GPL-3.0-or-later
// Effect and size of the brush. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mes {

enum class BrushMode : std::uint8_t {
  erase,   ///< removes all samples, and balls by their centres
  thin,    ///< removes every other sample along the curve
  refine,  ///< adds a sample between neighbours along the curve
};
inline constexpr std::size_t kBrushModes = 3;

struct BrushSettings {
  BrushMode mode = BrushMode::erase;
  double radius_px = 24.0;  ///< logical pixels, [4, 200]
  friend bool operator==(const BrushSettings&, const BrushSettings&) = default;
};

}  // namespace mes
