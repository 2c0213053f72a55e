// SPDX-License-Identifier: GPL-3.0-or-later
// Number type and theorem light, always visible at the end of the status bar.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/picture/picture.h"
#include "app/ui/screen/gui.h"
#include "core/document/document.h"
#include "core/document/settings/computation_settings.h"

namespace mes {

struct Verdict {
  const Gui& gui;
  const ActionBindings& actions;
  const Engine& engine;
  const Document& document;
  const ComputationSettings& computation;
  const Picture& picture;
  Canvas& canvas;

  /// Width that `draw` takes.
  float width(float room) const;
  /// Draws in the present window at the present position: a choice of number types, and the light with the epsilon
  /// beside it, if it is measured and all this is at most as wide as `room`. The light opens the list of reasons; a
  /// click on a reason shows its location.
  void draw(float room) const;
};

}  // namespace mes
