// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the last problem over the canvas until it is closed.
#pragma once

#include "app/model/messages.h"
#include "app/ui/gui.h"

namespace mes {

struct ProblemNote {
  const Gui& gui;
  Messages& messages;

  /// Draws in the middle of `width`, with the upper edge at `at`.
  void draw(ImVec2 at, float width) const;
};

}  // namespace mes
