// SPDX-License-Identifier: GPL-3.0-or-later
// The features of a map, each as a map of its own.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/files/file_fingerprint.h"

namespace mes::cli {

struct Feature {
  std::string name{};               ///< in messages: "FILE: feature 3, id 17"
  std::string text{};               ///< GeoJSON of the feature, with the reference system of the map
  std::string id{};                 ///< JSON; empty: none
  std::string properties{};         ///< JSON members without the braces
  std::vector<std::string> keys{};  ///< names of the properties
};

struct FeatureList {
  std::vector<Feature> features{};
  std::vector<SourceFile> sources{};
};

/// Reads GeoJSON: a FeatureCollection, a single feature, or several of either in sequence; or a map that GDAL reads
/// (core/io/maps/gdal.h). "-" is standard input. Error: `bad_input` for anything else.
Expected<FeatureList> read_features(const std::string& file);

}  // namespace mes::cli
