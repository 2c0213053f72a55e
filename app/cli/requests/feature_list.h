// SPDX-License-Identifier: GPL-3.0-or-later
// The features of the maps that `--each` reads.
#pragma once

#include <functional>
#include <set>
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

/// Names of the properties of features, for columns beside them: a column has one meaning in all rows, and columns of a
/// GeoPackage differ in more than case.
class PropertyNames {
 public:
  explicit PropertyNames(std::span<const Feature> features = {});
  /// The name, with the prefix as often as a feature has a property of that name.
  std::string free_name(std::string name, std::string_view prefix) const;

 private:
  std::set<std::string, std::less<>> taken_;  // in lower case
};

struct FeatureList {
  std::vector<Feature> features{};
  std::vector<SourceFile> sources{};
};

/// The values of `--from` that `read_features` understands.
std::span<const std::string_view> feature_formats();

/// Reads GeoJSON: a FeatureCollection, a single feature, or several of either in sequence; KML, WKT or a table of
/// geometries (core/io/maps/map_features.h); or a map that GDAL reads (core/io/maps/gdal.h). `format` is one of
/// `feature_formats`, or empty: found by the content. `has_system`: their coordinate system is chosen.
/// "-" is standard input. A feature of these without an id gets its number as one.
/// Error: `bad_input` for anything else.
Expected<FeatureList> read_features(const Registry& registry, const std::string& file, std::string_view format,
                                    bool has_system);

}  // namespace mes::cli
