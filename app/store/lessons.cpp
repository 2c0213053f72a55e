// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/lessons.h"

#include <nlohmann/json.hpp>

#include "app/playing/demo.h"
#include "core/graph/registry.h"
#include "core/io/files/read_file.h"
#include "core/io/format.h"
#include "core/io/session/json_text.h"

namespace mes {

namespace fs = std::filesystem;

std::vector<ShippedLesson> read_shipped_lessons(const fs::path& assets) {
  std::vector<ShippedLesson> out;
  if (assets.empty()) return out;
  const auto bytes = read_regular_file(assets / "lessons" / "index.json");
  nlohmann::json index = bytes ? parse_json(*bytes) : nlohmann::json();
  if (!index.is_array()) index = nlohmann::json::array();
  for (const nlohmann::json& entry : index) {
    if (!entry.is_object() || !entry.value("file", nlohmann::json()).is_string()) continue;
    const fs::path file = assets / "lessons" / entry["file"].get<std::string>();
    const nlohmann::json title = entry.value("title", nlohmann::json());
    const std::string name = file.stem().string();
    std::error_code error;
    if (fs::is_regular_file(file, error))
      out.push_back({file, name, title.is_string() ? title.get<std::string>() : name});
  }
  if (!read_sample_shapes(assets).empty()) out.push_back({{}, "demo", kDemoTitle});
  return out;
}

Expected<std::shared_ptr<const Session>> session_of(const Registry& registry, const ShippedLesson& lesson,
                                                    const fs::path& assets) {
  if (lesson.file.empty()) {
    auto demo = demo_of(registry, read_sample_shapes(assets));
    if (!demo) return std::unexpected(demo.error());
    return std::make_shared<const Session>(std::move(*demo));
  }
  const auto loaded = read_sample_file(lesson.file, {}, nullptr, {.formats = &registry.formats()});
  if (!loaded) return std::unexpected(loaded.error());
  if (!loaded->session)
    return std::unexpected(
        Error{ErrorCode::bad_input, "this is not a session but " + loaded->format, lesson.file.string()});
  return loaded->session;
}

Expected<Session> demo_of(const Registry& registry, std::span<const SampleShape> shapes) {
  if (shapes.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "the sample shapes that come with the program are missing"});
  const auto shape = read_sample_file(shapes.front().file, {}, nullptr, {.formats = &registry.formats()});
  if (!shape) return std::unexpected(shape.error());
  return demo_session(registry, shape->data);
}

}  // namespace mes
