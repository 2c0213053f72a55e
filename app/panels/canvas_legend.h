// SPDX-License-Identifier: GPL-3.0-or-later
// The colour bars of visible layers, above the canvas.
#pragma once

#include "app/model/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/gui.h"

namespace mes {

struct CanvasLegend {
  const Gui& gui;
  const Picture& picture;
  const LayerStack& layers;

  /// With its lower right corner at `corner`, no higher than `room`. Its size in screen coordinates; nothing while no
  /// visible layer has a colour map.
  ImVec2 draw(ImVec2 corner, float room) const;
};

}  // namespace mes
