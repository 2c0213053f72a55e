// SPDX-License-Identifier: GPL-3.0-or-later
// The features of the maps that `--each` reads.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/io/files/file_fingerprint.h"
#include "core/io/maps/map_features.h"

namespace mes {
class Registry;
}

namespace mes::cli {

struct Feature : MapFeature {
  std::string name{};    ///< in messages: "FILE: feature 3, id 17"
  std::string format{};  ///< of its text
};

struct FeatureList {
  std::vector<Feature> features{};
  std::vector<SourceFile> sources{};
};

/// The values of `--from` that `read_features` understands.
std::span<const std::string_view> feature_formats();

/// Reads GeoJSON: a FeatureCollection, a single feature, or several of either in sequence; KML or WKT
/// (core/io/maps/map_features.h); or a map that GDAL reads (core/io/maps/gdal.h). `format` is one of `feature_formats`,
/// or empty: found by the content. `has_system`: their coordinate system is chosen.
/// "-" is standard input. A feature of KML or WKT without an id gets its number as one.
/// Error: `bad_input` for anything else.
Expected<FeatureList> read_features(const Registry& registry, const std::string& file, std::string_view format,
                                    bool has_system);

}  // namespace mes::cli
