// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of a feature of a map, as members of a JSON object. Private to core/io.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/io/maps/map_features.h"

namespace mes {

/// JSON of a text. One that is not UTF-8 is read as Latin-1.
std::string json_of_text(std::string_view text);

/// Adds properties to a feature. A name that is taken gets a number.
class FeatureProperties {
 public:
  explicit FeatureProperties(MapFeature& feature) : feature_(feature) {}
  void add_text(std::string_view name, std::string_view value) { add(name, json_of_text(value)); }
  /// `value`: JSON.
  void add(std::string_view name, const std::string& value);

 private:
  MapFeature& feature_;
  std::set<std::string> taken_;       // the keys
  std::map<std::string, int> times_;  // how often a name was taken
};

}  // namespace mes
