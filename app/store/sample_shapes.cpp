// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/sample_shapes.h"

#include <nlohmann/json.hpp>

#include "core/io/files/read_file.h"
#include "core/io/session/json_text.h"

namespace mes {

namespace fs = std::filesystem;

std::vector<SampleShape> read_sample_shapes(const fs::path& assets) {
  std::vector<SampleShape> out;
  if (assets.empty()) return out;
  const auto bytes = read_regular_file(assets / "shapes" / "index.json");
  const nlohmann::json index = bytes ? parse_json(*bytes) : nlohmann::json();
  if (!index.is_array()) return out;
  const auto text = [](const nlohmann::json& entry, const char* key) {
    const auto found = entry.find(key);
    return found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  for (const nlohmann::json& entry : index) {
    if (!entry.is_object()) continue;
    SampleShape shape{assets / "shapes" / text(entry, "file"), text(entry, "name"), text(entry, "description")};
    std::error_code error;
    if (!shape.name.empty() && fs::is_regular_file(shape.file, error)) out.push_back(std::move(shape));
  }
  return out;
}

}  // namespace mes
