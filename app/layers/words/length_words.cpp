// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/words/length_words.h"

#include <fmt/core.h>

namespace mes {

std::string length_words(double length, const std::optional<MapPlane>& map) {
  return map ? fmt::format("{:.4g} {}", length, map->plane_unit()) : fmt::format("{:.4g}", length);
}

std::string with_unit(std::string_view title, const std::optional<MapPlane>& map) {
  return map ? fmt::format("{} ({})", title, map->plane_unit()) : std::string(title);
}

}  // namespace mes
