// SPDX-License-Identifier: GPL-3.0-or-later
// What the program has said since it was started.
#pragma once

#include "app/model/messages.h"
#include "app/ui/gui.h"

namespace mes {

struct LogPanel {
  const Gui& gui;
  Messages& messages;

  void draw() const;
};

}  // namespace mes
