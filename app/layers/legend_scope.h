// SPDX-License-Identifier: GPL-3.0-or-later
// The layers that a legend explains.
#pragma once

#include <cstdint>

namespace mes {

enum class LegendScope : std::uint8_t {
  none,
  color_maps,  ///< the layers coloured by a colour map
  all_layers,  ///< a key: all layers that draw something, with their colours
};

constexpr LegendScope legend_scope(bool with_color_maps, bool with_key) {
  if (with_key) return LegendScope::all_layers;
  return with_color_maps ? LegendScope::color_maps : LegendScope::none;
}

}  // namespace mes
