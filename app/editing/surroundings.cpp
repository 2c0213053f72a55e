// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/surroundings.h"

namespace mes {

void SurroundingsNotes::follow(Editor& editor, const Surroundings& now) {
  if (generation_ != editor.timeline().generation()) {
    *this = {};
    generation_ = editor.timeline().generation();
  }
  if (settings_ != now.settings) {
    settings_ = now.settings;
    editor.note(SettingsChanged{now.settings});
  }
  if (!now.view.is_empty() && view_ != now.view) {
    view_ = now.view;
    editor.note(ViewChanged{now.view});
  }
}

void SurroundingsNotes::take_as_noted(const Editor& editor, const Surroundings& now) {
  generation_ = editor.timeline().generation();
  settings_ = now.settings;
  view_ = now.view;
}

}  // namespace mes
