// SPDX-License-Identifier: GPL-3.0-or-later
// Shows why a key had no effect while the status bar is hidden.
#pragma once

#include "app/actions/messages.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct RefusalNote {
  const Gui& gui;
  const Messages& messages;

  /// Draws the present remark if it is a refusal, in the middle of `width`, with its lower edge at `at`.
  void draw(ImVec2 at, float width) const;
};

}  // namespace mes
