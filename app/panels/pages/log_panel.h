// SPDX-License-Identifier: GPL-3.0-or-later
// The program's messages since it was started.
#pragma once

#include "app/actions/messages.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct LogPanel {
  const Gui& gui;
  Messages& messages;

  void draw() const;
};

}  // namespace mes
