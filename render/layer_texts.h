// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a layer: text beside places of the plane, in the place of the layer's instances.
//
// Smallest use:
//     auto texts = std::make_shared<LayerTexts>(LayerTexts{font, 13.0, {5.0, -5.0}, {{{0.5, 0.25}, "17"}}});
//     scene.draw(camera, {{layer, style, 1, texts}}, {});
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/vec2.h"
#include "render/text.h"

namespace mes::render {

struct PlacedText {
  Vec2 at;           ///< in units of the document
  std::string text;  ///< UTF-8, one line
};

/// Lengths are in logical pixels. Texts must not overlap: where they do, they add up.
struct LayerTexts {
  std::optional<Font> font{};  ///< without one nothing is shown
  double size = 13.0;          ///< of the letters, as of `draw_text`
  Vec2 shift{};                ///< from the place to the beginning of the baseline, y down
  std::vector<PlacedText> texts;
};

}  // namespace mes::render
