// SPDX-License-Identifier: GPL-3.0-or-later
// Says on the canvas why nothing is seen, and offers what would show something.
#pragma once

#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/gui.h"
#include "core/engine/engine.h"

namespace mes {

struct EmptyViewNote {
  const Gui& gui;
  Editor& editor;
  LayerStack& layers;
  const Picture& picture;
  const Engine& engine;

  /// About `middle`; nothing while anything is computed or seen. Whether it is there.
  bool draw(ImVec2 middle, float width) const;
};

}  // namespace mes
