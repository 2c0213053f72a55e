// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of visible layers, above the canvas.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "app/layers/layer_stack.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/picture/picture.h"
#include "app/settings/paper_place.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct CanvasLegend {
  const Gui& gui;
  const Picture& picture;
  const LayerStack& layers;
  LegendScope scope;
  /// Returns how much of the drawing a box would hide, in logical pixels from the origin.
  std::function<std::size_t(const Box2&)> hides;

  struct Drawn {
    std::optional<Box2> box{};  ///< nothing: it has no entries or no room
    bool lacks_room = false;
  };
  /// Draws the legend at its position, or else in the lower right corner beside the marks, or in another one if only
  /// that is free; `origin` is the origin of positions in screen coordinates.
  Drawn draw(const std::optional<PaperPlace>& place, ImVec2 origin, const MarksPlace& marks) const;
};

}  // namespace mes
