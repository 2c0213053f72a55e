// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogs of the window, which lie over everything else.
#pragma once

#include <array>
#include <vector>

#include "app/panels/dialogs/command_palette.h"
#include "app/panels/dialogs/figure_dialog.h"
#include "app/panels/dialogs/help.h"
#include "app/panels/dialogs/manual_page.h"
#include "app/panels/dialogs/questions/ask_conflict.h"
#include "app/panels/dialogs/questions/ask_experiment.h"
#include "app/panels/dialogs/questions/ask_recover.h"
#include "app/panels/dialogs/questions/ask_system.h"
#include "app/panels/dialogs/questions/ask_unsaved.h"
#include "app/panels/dialogs/shape_dialog.h"
#include "app/panels/dialogs/text_dialog.h"
#include "app/panels/dialogs/trace_dialog.h"
#include "app/ui/dialogs/file_browser.h"

namespace mes {

/// Guarantees: all keys are sent to the topmost open dialog. Threads: the window's.
class Dialogs {
 public:
  AskUnsaved unsaved;
  AskRecover recover;
  AskConflict conflict;
  AskExperiment experiment;
  AskSystem system;
  FigureDialog figure;
  TraceDialog trace;
  ShapeDialog shape;
  TextDialog text;
  FileBrowser browser;
  HelpPage help;
  ManualPage manual;
  CommandPalette palette;

  /// The open dialogs, topmost last.
  std::vector<const Dialog*> open() const;
  /// Returns true if a dialog is open and has taken the key. Holding Enter answers one question only.
  bool take_key(const KeyChord& chord, bool repeated);
  /// Called once per turn.
  void follow() {
    for (Dialog* dialog : all_) dialog->follow();
  }
  /// Draws the topmost one; those below appear when it is closed.
  void draw(const Gui& gui);

 private:
  // Topmost last.
  std::array<Dialog*, 13> all_{&figure,   &trace,      &shape,   &text, &recover, &system, &unsaved,
                               &conflict, &experiment, &browser, &help, &manual,  &palette};
};

}  // namespace mes
