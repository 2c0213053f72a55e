// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/carried.h"

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

}  // namespace mes
