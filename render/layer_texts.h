// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of a layer: labels beside points of the plane, shown instead of the layer's instances.
//
// Smallest use:
//     auto texts = std::make_shared<LayerTexts>(LayerTexts{font, 13.0, {5.0, -5.0}, {{{0.5, 0.25}, "17"}}});
//     scene.draw(camera, {{layer, style, 1, texts}}, {});
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "render/image/text.h"

namespace mes::render {

struct PlacedText {
  Vec2 at;           ///< in units of the document
  std::string text;  ///< UTF-8, one line
};

/// Lengths are in logical pixels. Texts should not overlap: overlaps add up.
struct LayerTexts {
  std::optional<Font> font{};  ///< required to show anything
  double size = 13.0;          ///< size of the letters, as in `draw_text`
  Vec2 shift{};                ///< from the point to the beginning of the baseline, y down
  std::vector<PlacedText> texts;
};

}  // namespace mes::render
