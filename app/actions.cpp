// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions.h"

#include <array>

#include "core/base/assert.h"

namespace mes {
namespace {

using enum ActionGroup;
using enum ActionContext;
using Id = ActionId;

std::vector<ActionDescriptor> make_table() {
  return {
      {Id::new_document, "new", "New", "Start with an empty plane", file, always, false, {"Ctrl+N"}},
      {Id::open, "open", "Open...", "Open a file of samples or balls", file, always, false, {"Ctrl+O"}},
      {Id::save,
       "save",
       "Save",
       "Write samples to their POFF file and balls to their WPOFF file",
       file,
       always,
       false,
       {"Ctrl+S"}},
      {Id::save_as,
       "save-as",
       "Save as...",
       "Write the samples to another file, or the balls if its name ends in .wpoff",
       file,
       always,
       false,
       {"Ctrl+Shift+S"}},
      {Id::quit, "quit", "Quit", "Close the window", file, always, false, {"Ctrl+Q"}},

      {Id::undo, "undo", "Undo", "Take back the last step", edit, always, true, {"Ctrl+Z"}},
      {Id::redo,
       "redo",
       "Redo",
       "Do the step again that was taken back",
       edit,
       always,
       true,
       {"Ctrl+Shift+Z", "Ctrl+Y"}},
      {Id::select_all,
       "select-all",
       "Select all",
       "Select every sample and every ball",
       edit,
       always,
       false,
       {"Ctrl+A"}},
      {Id::invert_selection,
       "invert-selection",
       "Invert selection",
       "Select what is not selected, and only that",
       edit,
       always,
       false,
       {"Ctrl+I"}},
      {Id::deselect,
       "deselect",
       "Deselect",
       "End the gesture under way, take away the card of what was clicked, or select nothing",
       edit,
       always,
       false,
       {"Esc"}},
      {Id::delete_selection,
       "delete",
       "Delete",
       "Remove what is selected",
       edit,
       with_selection,
       false,
       {"Delete", "Backspace"}},
      {Id::nudge_left,
       "nudge-left",
       "Nudge left",
       "Move what is selected by one pixel of the screen",
       edit,
       with_selection,
       true,
       {"Left"}},
      {Id::nudge_right,
       "nudge-right",
       "Nudge right",
       "Move what is selected by one pixel of the screen",
       edit,
       with_selection,
       true,
       {"Right"}},
      {Id::nudge_up,
       "nudge-up",
       "Nudge up",
       "Move what is selected by one pixel of the screen",
       edit,
       with_selection,
       true,
       {"Up"}},
      {Id::nudge_down,
       "nudge-down",
       "Nudge down",
       "Move what is selected by one pixel of the screen",
       edit,
       with_selection,
       true,
       {"Down"}},
      {Id::nudge_left_far,
       "nudge-left-far",
       "Nudge left by ten",
       "Move what is selected by ten pixels of the screen",
       edit,
       with_selection,
       true,
       {"Shift+Left"}},
      {Id::nudge_right_far,
       "nudge-right-far",
       "Nudge right by ten",
       "Move what is selected by ten pixels of the screen",
       edit,
       with_selection,
       true,
       {"Shift+Right"}},
      {Id::nudge_up_far,
       "nudge-up-far",
       "Nudge up by ten",
       "Move what is selected by ten pixels of the screen",
       edit,
       with_selection,
       true,
       {"Shift+Up"}},
      {Id::nudge_down_far,
       "nudge-down-far",
       "Nudge down by ten",
       "Move what is selected by ten pixels of the screen",
       edit,
       with_selection,
       true,
       {"Shift+Down"}},

      {Id::tool_select,
       "tool-select",
       "Select and move",
       "Click or box to select; drag a sample or a ball to move it; turn the wheel on a selected ball to change its "
       "radius",
       tools,
       always,
       false,
       {"V"}},
      {Id::tool_insert,
       "tool-insert",
       "Insert",
       "Click to add a sample; keep the button down to place it",
       tools,
       always,
       false,
       {"I"}},
      {Id::tool_spray,
       "tool-spray",
       "Spray",
       "Drag to draw a stroke of evenly spaced samples",
       tools,
       always,
       false,
       {"S"}},
      {Id::tool_ball,
       "tool-ball",
       "Ball",
       "Press at the centre of a ball and drag to its circle; a click alone makes nothing",
       tools,
       always,
       false,
       {"B"}},

      {Id::zoom_in, "zoom-in", "Zoom in", "Magnify at the cursor", view, always, true, {"+", "="}},
      {Id::zoom_out, "zoom-out", "Zoom out", "Shrink at the cursor", view, always, true, {"-"}},
      {Id::fit, "fit", "Fit to view", "Show all samples and balls", view, always, false, {"F", "Home"}},
      {Id::fit_selection,
       "fit-selection",
       "Fit selection",
       "Show what is selected",
       view,
       always,
       false,
       {"Shift+F"}},
      {Id::previous_view,
       "previous-view",
       "Previous view",
       "Return to where you looked before",
       view,
       without_selection,
       false,
       {"Backspace"}},
      {Id::toggle_panels,
       "toggle-panels",
       "Panels",
       "Hide all panels, or show them again",
       view,
       always,
       false,
       {"Tab"}},
      {Id::toggle_layers, "toggle-layers", "Layers", "Show or hide the list of layers", view, always, false, {"L"}},
      {Id::toggle_statistics,
       "toggle-statistics",
       "Statistics",
       "Show or hide counts and times of every structure",
       view,
       always,
       false,
       {"T"}},
      {Id::toggle_parameters,
       "toggle-parameters",
       "Parameters",
       "Show or hide the numbers that steer what is computed",
       view,
       always,
       false,
       {"P"}},
      {Id::toggle_log, "toggle-log", "Log", "Show or hide what the program has said", view, always, false, {}},
      {Id::toggle_legend,
       "toggle-legend",
       "Legend",
       "Show or hide the colour bars of layers with a colour map",
       view,
       always,
       false,
       {"C"}},

      {Id::cancel_computation,
       "cancel",
       "Cancel computation",
       "Stop computing; what is there stays on screen",
       compute,
       always,
       false,
       {"Ctrl+."}},
      {Id::resume_computation,
       "resume",
       "Resume computation",
       "Compute what was cancelled",
       compute,
       always,
       false,
       {}},
      {Id::precision_naive,
       "precision-naive",
       "Naive: plain doubles",
       "Plain doubles everywhere; wrong on degenerate input, to see why it matters",
       compute,
       always,
       false,
       {}},
      {Id::precision_fast,
       "precision-fast",
       "Fast: exact decisions on doubles",
       "Exact decisions on the samples, constructed points rounded to doubles",
       compute,
       always,
       false,
       {}},
      {Id::precision_exact,
       "precision-exact",
       "Exact: rationals",
       "Rational arithmetic for constructed points, roots where they are needed",
       compute,
       always,
       false,
       {}},
      {Id::precision_exact_roots,
       "precision-exact-roots",
       "Exact with roots",
       "Algebraic numbers throughout; slow, the judge of the others",
       compute,
       always,
       false,
       {}},
      {Id::toggle_union_shortcut,
       "toggle-union-shortcut",
       "Certified shortcut for unions",
       "Let unions of inner balls follow from shared samples where that is certified; off: the general pipeline "
       "always",
       compute,
       always,
       false,
       {}},
      {Id::toggle_pole_propagation,
       "toggle-pole-propagation",
       "Pole labels by propagation",
       "Spread the labels of poles from pole to pole, as Amenta, Choi and Kolluri do; off: by their triangles",
       compute,
       always,
       false,
       {}},

      {Id::help, "help", "Keys and gestures", "Show every key", ActionGroup::help, always, false, {"?", "F1"}},
  };
}

bool applies(ActionContext context, bool has_selection) {
  return context == always || (context == with_selection) == has_selection;
}

}  // namespace

std::string_view title_of(ActionGroup group) {
  constexpr std::array<std::string_view, 6> titles{"File", "Edit", "Tools", "View", "Computation", "Help"};
  return titles[static_cast<std::size_t>(group)];
}

std::span<const ActionDescriptor> action_descriptors() {
  static const std::vector<ActionDescriptor> table = make_table();
  return table;
}

const ActionDescriptor& descriptor_of(ActionId id) {
  const ActionDescriptor& found = action_descriptors()[static_cast<std::size_t>(id)];
  MES_ASSERT(found.id == id);
  return found;
}

std::optional<ActionId> find_action(const KeyChord& chord, bool has_selection) {
  for (const ActionDescriptor& action : action_descriptors()) {
    if (!applies(action.context, has_selection)) continue;
    for (const std::string_view key : action.keys)
      if (parse_chord(key) == chord) return action.id;
  }
  return std::nullopt;
}

std::string tooltip_of(ActionId id) {
  const ActionDescriptor& action = descriptor_of(id);
  std::string out(action.name);
  if (!action.keys.empty()) out += " (" + std::string(action.keys.front()) + ")";
  out += '\n';
  return out += action.tooltip;
}

std::span<const GestureDescriptor> gesture_descriptors() {
  static constexpr std::array<GestureDescriptor, 14> table{{
      {"Wheel", "zoom at the cursor"},
      {"Middle drag, right drag", "pan"},
      {"Space + drag", "pan"},
      {"Click", "select a sample (select tool), add one (insert tool)"},
      {"Click anything else drawn", "show what it comes from and what it leads to (select tool)"},
      {"Alt + click", "the same for a sample or a ball"},
      {"Shift + click or box", "add to the selection"},
      {"Ctrl + Shift + click or box", "take out of the selection"},
      {"Drag a sample or a ball", "move it, with the selection it belongs to"},
      {"Drag empty space", "select what the box holds"},
      {"Drag with the spray tool", "draw a stroke"},
      {"Drag with the ball tool", "draw a ball from its centre"},
      {"Wheel on a selected ball", "change its radius; take it at its centre or its circle"},
      {"Drop files on the window", "open them; samples and balls together"},
  }};
  return table;
}

}  // namespace mes
