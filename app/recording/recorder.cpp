// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recorder.h"

namespace mes {

Change Recorder::change(const ShownState& now) const {
  if (now.document != captured_.document) return Change::document;
  if (now.settings != captured_.settings) return Change::settings;
  if (now.layers != captured_.layers || now.solo != captured_.solo) return Change::layers;
  if (now.selection != captured_.selection) return Change::selection;
  return now.view == captured_.view ? Change::none : Change::view;
}

bool Recorder::wants_frame(const ShownState& now, const AtRest& rest) const {
  switch (change(now)) {
    case Change::none: return false;
    case Change::view: return each_motion_ || rest.view;
    case Change::layers:
    case Change::settings: return rest.controls;
    case Change::selection:
    case Change::document: break;
  }
  return true;
}

bool Recorder::is_due(const ShownState& now, const AtRest& rest) const {
  return complete_ == now && wants_frame(now, rest);
}

bool Recorder::holds_input(const ShownState& now, const AtRest& rest, bool is_cancelled) const {
  return !is_cancelled && wants_frame(now, rest);
}

std::string name_of(Change change, const std::string& undo_name) {
  switch (change) {
    case Change::none: return "Nothing";
    case Change::view: return "View";
    case Change::selection: return "Selection";
    case Change::layers: return "Layers";
    case Change::settings: return "Computation";
    case Change::document: break;
  }
  return undo_name.empty() ? "Edit" : undo_name;
}

}  // namespace mes
