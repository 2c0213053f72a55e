// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of visible layers, above the canvas.
#pragma once

#include <optional>

#include "app/layers/layer_stack.h"
#include "app/model/paper_place.h"
#include "app/picture/picture.h"
#include "app/picture/scale_drawing.h"
#include "app/ui/gui.h"

namespace mes {

struct CanvasLegend {
  const Gui& gui;
  const Picture& picture;
  const LayerStack& layers;
  LegendScope scope;

  /// Draws the legend at its position, or in the lower right corner beside the marks; `origin` is the origin of
  /// positions in screen coordinates. Returns its box; nothing if it has no entries or no room.
  std::optional<Box2> draw(const std::optional<PaperPlace>& place, ImVec2 origin, const MarksPlace& marks) const;
};

}  // namespace mes
