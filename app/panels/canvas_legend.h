// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of visible layers, above the canvas.
#pragma once

#include "app/model/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/gui.h"

namespace mes {

struct CanvasLegend {
  const Gui& gui;
  const Picture& picture;
  const LayerStack& layers;
  LegendScope scope;

  /// With its lower right corner at `corner`, no higher than `room`. Its size in screen coordinates; nothing while it
  /// has no entries.
  ImVec2 draw(ImVec2 corner, float room) const;
};

}  // namespace mes
