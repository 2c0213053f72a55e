// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths in words, with the unit of the document where it has one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/document/map_plane.h"

namespace mes {

/// "12.5 m"; without a map, whose plane has a unit, "12.5".
std::string length_words(double length, const std::optional<MapPlane>& map);
/// "radius (m)", the title of numbers that are lengths; without a map "radius".
std::string with_unit(std::string_view title, const std::optional<MapPlane>& map);

}  // namespace mes
