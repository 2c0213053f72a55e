// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done with the picture to trace: which one it is, where it lies and how large it is.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/layers/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/gui.h"

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
