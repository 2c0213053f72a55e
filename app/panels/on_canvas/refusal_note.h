// SPDX-License-Identifier: GPL-3.0-or-later
// Shows why a key had no effect while the status bar is hidden.
#pragma once

#include "app/model/messages.h"
#include "app/ui/gui.h"

namespace mes {

struct RefusalNote {
  const Gui& gui;
  const Messages& messages;

  /// Draws in the middle of `width`, with the lower edge at `at`; nothing if the present remark is no refusal.
  void draw(ImVec2 at, float width) const;
};

}  // namespace mes
