// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/lessons.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace mes {

namespace fs = std::filesystem;

std::vector<ShippedLesson> read_shipped_lessons(const fs::path& assets) {
  std::vector<ShippedLesson> out;
  if (assets.empty()) return out;
  std::ifstream stream(assets / "lessons" / "index.json", std::ios::binary);
  const nlohmann::json index = nlohmann::json::parse(stream, nullptr, false);
  if (!index.is_array()) return out;
  for (const nlohmann::json& entry : index) {
    if (!entry.is_object() || !entry.value("file", nlohmann::json()).is_string()) continue;
    const fs::path file = assets / "lessons" / entry["file"].get<std::string>();
    const nlohmann::json title = entry.value("title", nlohmann::json());
    const std::string name = file.stem().string();
    std::error_code error;
    if (fs::is_regular_file(file, error))
      out.push_back({file, name, title.is_string() ? title.get<std::string>() : name});
  }
  return out;
}

}  // namespace mes
