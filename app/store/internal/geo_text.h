// SPDX-License-Identifier: GPL-3.0-or-later
// Geometries in GeoJSON and well-known text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/store/internal/straight_shapes.h"

namespace mes {

/// The written parts of a shape; in the plane it is one part with its corners.
using GeoParts = std::vector<std::vector<Vec2>>;

/// Begins and ends a collection of features. Readers that follow RFC 7946 ignore the name of the system of degrees;
/// without it this program reads features as lying in the plane.
std::string begin_of_features(bool are_in_degrees);
inline constexpr std::string_view kEndOfFeatures = "\n]}\n";

void append_geojson(std::string& out, StraightKind kind, const GeoParts& parts);
void append_wkt(std::string& out, StraightKind kind, const GeoParts& parts, bool is_in_degrees);

}  // namespace mes
