// SPDX-License-Identifier: GPL-3.0-or-later
// Says that what was added is not seen, and offers to show it.
#pragma once

#include "app/editing/editor.h"
#include "app/editing/hidden_samples.h"
#include "app/ui/gui.h"

namespace mes {

struct HiddenSamplesNote {
  const Gui& gui;
  HiddenSamples& hidden;
  Editor& editor;
  LayerStack& layers;

  /// `top`: the middle of its upper edge.
  void draw(ImVec2 top) const;
};

}  // namespace mes
