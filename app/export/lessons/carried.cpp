// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/lessons/carried.h"

#include <filesystem>
#include <memory>
#include <utility>

namespace mes {

Session session_for_picture(std::string title, SampleData data, LayerConfiguration layers,
                            const ComputationSettings& settings, const Box2& view) {
  layers.image.file = std::filesystem::path(layers.image.file).filename().string();
  return {.title = std::move(title),
          .data = std::make_shared<const SampleData>(std::move(data)),
          .layers = std::move(layers),
          .settings = settings,
          .view = view};
}

Session session_for_lesson(const Session& session) {
  const auto without_folder = [](BackgroundImage& image) {
    image.file = std::filesystem::path(image.file).filename().string();
  };
  const auto clean = [&](LayersChanged& change) {
    if (change.image) without_folder(*change.image);
    for (LayersChanged& back : change.back)
      if (back.image) without_folder(*back.image);
  };
  Session out = session;
  without_folder(out.layers.image);
  for (LessonStep& step : out.lesson.steps) without_folder(step.layers.image);
  TimelineLog entries;
  for (TimelineEntry entry : session.entries) {
    if (auto* const change = std::get_if<LayersChanged>(&entry)) clean(*change);
    entries.push_back(entry);
  }
  out.entries = std::move(entries);
  return out;
}

}  // namespace mes
