// SPDX-License-Identifier: GPL-3.0-or-later
// Controls for the picture to trace: its file, position and size.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/layers/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct ImageControls {
  const Gui& gui;
  const ActionBindings& actions;
  LayerStack& layers;
  const Picture& picture;
  const Canvas& canvas;

  /// Changes the picture of the layer stack.
  void draw() const;
};

}  // namespace mes
