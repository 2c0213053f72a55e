// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_input.h"

#include <string_view>
#include <utility>

namespace mes {
namespace {

bool types_text(const KeyChord& chord) {
  return chord.symbol < key::named && !chord.modifiers.ctrl && !chord.modifiers.alt;
}

/// Tab, Enter, arrow keys and the like, which navigate in panels.
bool goes_about(const KeyChord& chord) {
  return chord.symbol >= key::named && chord.symbol < key::f1;
}

// The keys that a text field handles.
bool is_editing_key(const KeyChord& chord) {
  constexpr std::u32string_view kWithCtrl = U"ACVXYZ";
  if (types_text(chord) || goes_about(chord)) return true;
  return chord.modifiers.ctrl && !chord.modifiers.shift && kWithCtrl.find(chord.symbol) != kWithCtrl.npos;
}

}  // namespace

WindowInput::WindowInput(const Uses& uses) : uses_(uses) {
  uses_.screen.window->set_listener(this);
}

WindowInput::~WindowInput() {
  uses_.screen.window->set_listener(nullptr);
}

// A dialog opens or closes only in the next frame, and a clicked field gets the keyboard only then. On a slow machine
// a whole sentence of keys can arrive between two frames, so later events wait.
void WindowInput::deliver() {
  const std::vector<const Dialog*> open = uses_.dialogs.open();
  const auto is_recording = [this] { return uses_.recording.recorder().is_recording(); };
  const auto is_stroke = [&] {
    return (uses_.canvas.tool().is_stroke() || is_recording()) && uses_.canvas.has_pointer();
  };
  waits_for_panels_ = false;
  events_.deliver(
      [&] { return uses_.dialogs.open() == open && !waits_for_panels_ && !uses_.recording.holds_input(); }, is_stroke,
      uses_.follow_hold);
  if (!events_.is_empty() && !uses_.recording.holds_input()) uses_.screen.clock.want(2);
}

void WindowInput::on_pointer_moved(Vec2 px, Modifiers modifiers) {
  pointer_px_ = px;
  uses_.presenter.note_pointer();
  events_.push_move([this, px, modifiers] { follow_pointer(px, modifiers); });
}

void WindowInput::follow_pointer(Vec2 px, Modifiers modifiers) {
  if (uses_.canvas.has_pointer() || !uses_.screen.gui.wants_pointer(px)) {
    is_on_panel_ = false;
    uses_.canvas.move(px, modifiers);
  } else {
    uses_.canvas.leave();
  }
}

void WindowInput::on_pointer_left() {
  events_.push([this] {
    if (!uses_.canvas.has_pointer()) uses_.canvas.leave();
  });
}

void WindowInput::on_button(PointerButton button, bool pressed, Modifiers modifiers) {
  events_.push([this, button, pressed, modifiers, px = pointer_px_, when = Clock::now()] {
    if (pressed)
      press(button, px, modifiers);
    else
      release(button, px, modifiers, when);
  });
}

void WindowInput::press(PointerButton button, Vec2 px, Modifiers modifiers) {
  if (uses_.canvas.has_pointer()) return;
  if (uses_.screen.gui.wants_pointer(px)) {
    waits_for_panels_ = is_panel_pressed_ = true;
    is_on_panel_ = !uses_.screen.gui.has_popup();
    return;
  }
  is_on_panel_ = false;
  uses_.messages.clear_remark();
  pressed_px_ = px;
  uses_.canvas.press(button, px, modifiers);
}

// A double click on a selected sample selects its curve. If a frame takes long, the second click arrives late, so
// clicks in adjacent frames count as well.
void WindowInput::release(PointerButton button, Vec2 px, Modifiers modifiers, Clock::time_point when) {
  // A key pressed after the release finds the control with its last value.
  if (std::exchange(is_panel_pressed_, false)) waits_for_panels_ = true;
  constexpr std::chrono::milliseconds kLongest{400};
  constexpr double kFarthestPx = 6.0;
  const double scale = uses_.canvas.content_scale();
  const bool is_click = uses_.canvas.has_pointer() && button == PointerButton::left && modifiers == Modifiers{} &&
                        uses_.canvas.tool_id() == ToolId::select &&
                        distance(px, pressed_px_) <= kDragThresholdPx * scale;
  if (uses_.canvas.release(button, px, modifiers)) uses_.open_menu();
  if (!is_click) return;
  const Click click{when, ImGui::GetFrameCount(), px};
  const bool is_second = click_ && distance(px, click_->px) < kFarthestPx * scale &&
                         (when - click_->when < kLongest || click.frame - click_->frame <= 1);
  click_ = is_second ? std::nullopt : std::optional(click);
  if (is_second && uses_.canvas.tool().feedback().hovered != kNoSlot) uses_.actions.run(ActionId::select_curve);
}

void WindowInput::on_wheel(double steps) {
  events_.push([this, steps, px = pointer_px_] {
    if (uses_.canvas.has_pointer() || !uses_.screen.gui.wants_pointer(px)) uses_.canvas.wheel(px, steps);
  });
}

bool WindowInput::is_in_gesture() const {
  const bool holds_control = is_panel_pressed_ && uses_.screen.gui.holds_control();
  return uses_.canvas.has_pointer() || uses_.mark_drag.is_under_way() || holds_control;
}

std::optional<ActionId> WindowInput::action_of(const KeyChord& chord) const {
  const bool has_selection = !uses_.selection.is_empty() || uses_.annotations.current() != nullptr;
  if (const auto action = uses_.actions.keymap().find(chord, has_selection)) return action;
  // Finds the action even without a selection, so that a key that needs one can say so.
  if (const auto action = uses_.actions.keymap().find(chord, true)) return action;
  // A lasso is drawn with Ctrl held, and Esc and F4 are then Ctrl+Esc and Ctrl+F4.
  const bool is_held_for_gesture = chord.modifiers != Modifiers{} && is_in_gesture();
  return is_held_for_gesture ? uses_.actions.keymap().find({chord.symbol, {}}, true) : std::nullopt;
}

void WindowInput::come_again(const KeyChord& chord, bool repeated) {
  waits_for_panels_ = true;
  events_.push_first([this, chord, repeated] {
    has_come_again_ = true;
    run_by_key(chord, repeated);
    has_come_again_ = false;
  });
}

// Keys meant for the window close a list, as a click beside it does, or leave a field, as Enter does.
bool WindowInput::is_for_panels(const KeyChord& chord, bool repeated) {
  Gui& gui = uses_.screen.gui;
  const bool wants_text = gui.wants_text();
  if (wants_text && is_editing_key(chord)) return true;
  if (!wants_text && chord.symbol == key::escape && gui.close_popup()) return true;
  if (!wants_text && !gui.has_popup()) return false;
  if (goes_about(chord)) return true;
  const auto action = action_of(chord);
  if (!action) return true;
  if (works_at_any_time(*action)) return false;
  if (has_come_again_) return true;
  gui.leave_panels();
  come_again(chord, repeated);
  return true;
}

// The document must not change during a gesture, which Esc takes back. A slider that is held would change it again.
bool WindowInput::is_refused_by_gesture(ActionId action) {
  const bool is_mark = uses_.mark_drag.is_under_way();
  if (is_mark && (action == ActionId::deselect || action == ActionId::undo)) {
    uses_.mark_drag.cancel();
    return true;
  }
  if (!is_in_gesture() || works_at_any_time(action)) return false;
  const bool is_of_canvas = is_mark || uses_.canvas.has_pointer();
  if (is_of_canvas && action == ActionId::deselect) return false;
  uses_.messages.refusal(descriptor_of(action).name + " is not possible now: " +
                         (is_of_canvas ? "the button of the mouse is down (Esc takes back what it did)"
                                       : "the mouse holds a control of the panels"));
  return true;
}

bool WindowInput::is_refused_on_panel(ActionId action) {
  const bool is_nudge = action >= ActionId::first_nudge && action <= ActionId::last_nudge;
  const bool is_of_selection = is_nudge || action == ActionId::delete_selection;
  if (!is_of_selection || !is_on_panel_ || uses_.selection.is_empty() || uses_.presenter.is_on()) return false;
  uses_.messages.refusal(descriptor_of(action).name +
                         " is not possible now: the pointer is on a panel that was clicked, not on the drawing");
  return true;
}

bool WindowInput::steps_in_list(const KeyChord& chord) {
  if (!is_on_panel_ || uses_.presenter.is_on() || chord.modifiers != Modifiers{}) return false;
  constexpr std::ptrdiff_t kPage = 10;
  switch (chord.symbol) {
    case key::up: return uses_.step_in_list(-1);
    case key::down: return uses_.step_in_list(1);
    case key::page_up: return uses_.step_in_list(-kPage);
    case key::page_down: return uses_.step_in_list(kPage);
    default: return false;
  }
}

void WindowInput::run_by_key(const KeyChord& chord, bool repeated) {
  const auto action = action_of(chord);
  // The record key ends a recording even during a question.
  const bool is_for_dialogs = action != ActionId::record || types_text(chord);
  if (is_for_dialogs && uses_.dialogs.take_key(chord, repeated)) return;
  if (is_for_dialogs && is_for_panels(chord, repeated)) return;
  DocumentFiles& files = uses_.documents.files();
  if (chord.symbol == key::escape && !uses_.canvas.has_pointer() && files.is_reading()) return files.cancel_reading();
  if (steps_in_list(chord)) return;
  if (!action || (repeated && !descriptor_of(*action).repeats)) return;
  if (is_refused_by_gesture(*action) || is_refused_on_panel(*action)) return;
  uses_.messages.clear_refusal();
  if (!uses_.actions.run(*action)) {
    // A pressed key without effect must give the reason, because no menu shows that the action is disabled.
    const std::string why = uses_.actions.missing(*action);
    if (why.empty()) return;
    uses_.messages.refusal(descriptor_of(*action).name + " is not possible now: " + why);
    return;
  }
  const bool is_slide = (*action >= ActionId::first_bundle && *action <= ActionId::last_bundle) ||
                        *action == ActionId::next_bundle || *action == ActionId::previous_bundle;
  uses_.presenter.note_key(to_string(chord), descriptor_of(*action).name, is_slide);
}

void WindowInput::on_key(const KeyChord& chord, bool repeated) {
  // The user may want to cancel the computation that the recording waits for, or the recording itself.
  const bool is_held = uses_.recording.holds_input();
  const bool waits = is_held || (uses_.recording.recorder().is_recording() && !events_.is_empty());
  const auto action = action_of(chord);
  const bool ends_recording = waits && action == ActionId::record && !repeated && !types_text(chord);
  if ((is_held && action == ActionId::cancel_computation) ||
      (ends_recording && std::exchange(ends_recording_, false)))
    return run_by_key(chord, repeated);
  if (!ends_recording) {
    events_.push([this, chord, repeated] { run_by_key(chord, repeated); });
    return;
  }
  ends_recording_ = true;
  uses_.messages.refusal("The recording ends when all that was done has its frames; " + to_string(chord) +
                         " once more ends it at once");
  events_.push([this, chord] {
    if (std::exchange(ends_recording_, false) && uses_.recording.recorder().is_recording()) run_by_key(chord, false);
  });
}

void WindowInput::on_typed(char32_t symbol, bool repeated) {
  const KeyChord chord{symbol, {}};
  if (is_typed_symbol(chord)) events_.push([this, chord, repeated] { run_by_key(chord, repeated); });
}

void WindowInput::on_space(bool held) {
  events_.push([this, held] {
    uses_.canvas.set_space_held(held && !uses_.screen.gui.wants_text() && !uses_.screen.gui.has_popup());
  });
}

void WindowInput::on_key_held(char32_t symbol, bool held) {
  events_.push([this, symbol, held] {
    if (symbol == 0) is_alt_held_ = is_hold_key_held_ = false;
    if (symbol != kHoldKey) return;
    const bool is_free = !uses_.actions.keymap().find({kHoldKey, {}}, true) && uses_.dialogs.open().empty() &&
                         !uses_.screen.gui.wants_text() && !uses_.screen.gui.has_popup();
    is_hold_key_held_ = held && (is_hold_key_held_ || is_free);
  });
}

// Gestures and snapping depend on the modifiers, even if the pointer rests. Nothing depends on them below a dialog,
// and after it the pointer is where it was.
void WindowInput::on_modifiers(Modifiers modifiers) {
  events_.push([this, px = pointer_px_, modifiers] {
    is_alt_held_ = modifiers.alt;
    const Canvas& canvas = uses_.canvas;
    if (canvas.is_hovered() && (canvas.has_pointer() || !uses_.screen.gui.wants_pointer(px)))
      uses_.canvas.move(px, modifiers);
  });
}

void WindowInput::on_files_dropped(std::vector<std::string> files) {
  std::erase_if(files, [this](const std::string& file) {
    if (!is_experiment_file(file)) return false;
    uses_.experiments.ask(file);
    return true;
  });
  if (!files.empty()) uses_.documents.open(std::move(files));
}

void WindowInput::on_close_wanted() {
  uses_.actions.run(ActionId::quit);
}

}  // namespace mes
