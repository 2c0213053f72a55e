// SPDX-License-Identifier: GPL-3.0-or-later
// Reports that added samples are hidden, and offers to show them.
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
