// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/maps/feature_properties.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace mes {

std::string json_of_text(std::string_view text) {
  using Json = nlohmann::json;
  try {
    return Json(text).dump();
  } catch (const Json::type_error&) {
    std::string utf8;
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x80) {
        utf8 += c;
        continue;
      }
      utf8 += static_cast<char>(0xC0U | (byte >> 6U));
      utf8 += static_cast<char>(0x80U | (byte & 0x3FU));
    }
    return Json(utf8).dump();
  }
}

void FeatureProperties::add(std::string_view name, const std::string& value) {
  std::string key(name);
  while (!taken_.insert(key).second) key = std::string(name) + '_' + std::to_string(++times_[std::string(name)] + 1);
  if (!feature_.properties.empty()) feature_.properties += ',';
  feature_.properties += json_of_text(key) + ':' + value;
  feature_.keys.push_back(std::move(key));
}

}  // namespace mes
