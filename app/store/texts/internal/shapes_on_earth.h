// SPDX-License-Identifier: GPL-3.0-or-later
// Converts shapes in the plane of a map to a coordinate system.
#pragma once

#include <vector>

#include "app/store/texts/internal/geo_text.h"
#include "app/store/texts/internal/straight_shapes.h"
#include "core/io/systems/map_conversion.h"

namespace mes {

/// Longitudes are from -180 to 180 and latitudes from -90 to 90: a shape across the 180th meridian is cut there, as
/// RFC 7946 (3.1.9) requires, and may become several chains or polygons. Returns none for a shape that reaches beyond
/// a pole or out of the system, for a polygon around a pole or all around the Earth, and for a chain of more than eight
/// turns around it. O(corners).
std::vector<std::vector<Vec2>> parts_on_earth(const StraightShape& shape, const MapConversion& conversion);

/// The same with the holes of a polygon, each in the part around it. Null: the shape stays in the plane, as one part.
GeoParts geo_parts_of(const StraightShape& shape, const MapConversion* conversion);

}  // namespace mes
