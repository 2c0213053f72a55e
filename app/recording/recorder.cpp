// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recorder.h"

namespace mes {
namespace {

// The name of the last edit; edits within a gesture have no name of their own.
std::string name_of_last_edit(const TimelineLog& timeline) {
  for (std::size_t i = timeline.size(); i-- > 0;) {
    const TimelineEntry entry = timeline[i];
    if (std::holds_alternative<Undone>(entry)) return "Undo";
    if (std::holds_alternative<Redone>(entry)) return "Redo";
    if (const auto* edit = std::get_if<TimelineEdit>(&entry); edit != nullptr && !edit->name.empty())
      return edit->name;
    if (const auto* gesture = std::get_if<GestureBegun>(&entry)) return gesture->name;
  }
  return "Open";
}

}  // namespace

Change Recorder::change(const ShownState& now) const {
  if (now.document != captured_.document) return Change::document;
  if (now.settings != captured_.settings) return Change::settings;
  if (now.panes != captured_.panes || now.evolution != captured_.evolution ||
      now.has_differences != captured_.has_differences)
    return Change::panes;
  if (now.layers != captured_.layers || now.solo != captured_.solo) return Change::layers;
  if (now.selection != captured_.selection) return Change::selection;
  if (now.legend != captured_.legend || now.legend_at != captured_.legend_at || now.marks != captured_.marks ||
      now.annotations != captured_.annotations || now.caption != captured_.caption)
    return Change::texts;
  return now.view == captured_.view && now.pane_views == captured_.pane_views ? Change::none : Change::view;
}

bool Recorder::wants_frame(const ShownState& now, const AtRest& rest) const {
  switch (change(now)) {
    case Change::none: return false;
    case Change::view: return each_motion_ || rest.view;
    case Change::layers:
    case Change::panes:
    case Change::settings: return rest.controls;
    case Change::texts:
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

std::string name_of(Change change, const TimelineLog& timeline) {
  switch (change) {
    case Change::none: return "Nothing";
    case Change::view: return "View";
    case Change::texts: return "Legend, scale or caption";
    case Change::selection: return "Selection";
    case Change::layers: return "Layers";
    case Change::panes: return "Panes";
    case Change::settings: return "Computation";
    case Change::document: break;
  }
  return name_of_last_edit(timeline);
}

}  // namespace mes
