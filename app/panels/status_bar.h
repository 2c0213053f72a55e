// SPDX-License-Identifier: GPL-3.0-or-later
// One line at the foot of the window: what to do or what happened, what is being computed, counts, coordinates.
#pragma once

#include "app/canvas/canvas.h"
#include "app/editing/editor.h"
#include "app/insight/computation_control.h"
#include "app/model/messages.h"
#include "app/panels/verdict.h"
#include "app/panels/work_in_progress.h"
#include "app/picture/picture.h"
#include "app/ui/widgets.h"

namespace mes {

struct StatusBar {
  const Gui& gui;
  const Editor& editor;
  const Canvas& canvas;
  const Picture& picture;
  ComputationControl& computation;
  Messages& messages;
  WorkInProgress work;
  Verdict verdict;

  /// In screen coordinates.
  float height() const;
  void draw(const PanelArea& area) const;
};

}  // namespace mes
