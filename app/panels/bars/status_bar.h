// SPDX-License-Identifier: GPL-3.0-or-later
// A line at the bottom of the window: hint or last message, work in progress, counts, coordinates.
#pragma once

#include <string>

#include "app/actions/messages.h"
#include "app/canvas/canvas.h"
#include "app/editing/editor.h"
#include "app/insight/computation_control.h"
#include "app/panels/bars/verdict.h"
#include "app/panels/bars/work_in_progress.h"
#include "app/picture/picture.h"
#include "app/ui/widgets/widgets.h"

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

  /// Height in screen coordinates.
  float height() const;
  void draw(const PanelArea& area) const;

 private:
  /// A tooltip for the text that was drawn last.
  void explain_text(const char* id, const std::string& explanation) const;
};

}  // namespace mes
