// SPDX-License-Identifier: GPL-3.0-or-later
// Explains on the canvas why nothing is visible, and offers a remedy.
#pragma once

#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/screen/gui.h"
#include "core/engine/engine.h"

namespace mes {

struct EmptyViewNote {
  const Gui& gui;
  Editor& editor;
  LayerStack& layers;
  const Picture& picture;
  const Engine& engine;

  /// Draws the note around `middle`, unless anything is computed or visible. Returns whether it was drawn.
  bool draw(ImVec2 middle, float width) const;
};

}  // namespace mes
