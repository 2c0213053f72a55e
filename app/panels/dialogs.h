// SPDX-License-Identifier: GPL-3.0-or-later
// What the window asks or shows over everything else.
#pragma once

#include <array>
#include <vector>

#include "app/panels/ask_conflict.h"
#include "app/panels/ask_experiment.h"
#include "app/panels/ask_recover.h"
#include "app/panels/ask_unsaved.h"
#include "app/panels/command_palette.h"
#include "app/panels/figure_dialog.h"
#include "app/panels/help.h"
#include "app/panels/shape_dialog.h"
#include "app/panels/text_dialog.h"
#include "app/panels/trace_dialog.h"
#include "app/ui/file_browser.h"

namespace mes {

/// What it guarantees: all keys go to the topmost of those that are open. Threads: the window's.
class Dialogs {
 public:
  AskUnsaved unsaved;
  AskRecover recover;
  AskConflict conflict;
  AskExperiment experiment;
  FigureDialog figure;
  TraceDialog trace;
  ShapeDialog shape;
  TextDialog text;
  FileBrowser browser;
  HelpPage help;
  CommandPalette palette;

  /// Those that are open, topmost last.
  std::vector<const Dialog*> open() const;
  /// True when one is open: it has taken the key. Enter that is held down answers one question, not the next as well.
  bool take_key(const KeyChord& chord, bool repeated);
  /// Once a turn.
  void follow() {
    for (Dialog* dialog : all_) dialog->follow();
  }
  /// The topmost; those below it are seen when it is closed.
  void draw(const Gui& gui);

 private:
  std::array<Dialog*, 11> all_{&figure,   &trace,      &shape,   &text, &recover, &unsaved,
                               &conflict, &experiment, &browser, &help, &palette};  // topmost last
};

}  // namespace mes
