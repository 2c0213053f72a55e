// SPDX-License-Identifier: GPL-3.0-or-later
// Events of the window: panels have first refusal, then the canvas, then the table of actions.
#include <algorithm>

#include "app/window/app.h"
#include "render/picture_file.h"

namespace mes {
namespace {

constexpr int kSettlingFrames = 3;

}  // namespace

void App::on_anything() {
  frames_wanted_ = kSettlingFrames;
}

void App::on_pointer_moved(Vec2 px, Modifiers modifiers) {
  pointer_px_ = px;
  events_.push_back({true, [this, px, modifiers] { follow_pointer(px, modifiers); }});
}

void App::follow_pointer(Vec2 px, Modifiers modifiers) {
  if (canvas_.has_pointer() || !gui_.wants_pointer(px))
    canvas_.move(px, modifiers);
  else
    canvas_.leave();
}

// Which dialog has the keys now.
int App::dialog() const {
  return (show_help_ ? 1 : 0) + (ask_unsaved_.is_open() ? 2 : 0) + (browser_.is_open() ? 4 : 0) +
         (ask_recover_.is_open() ? 8 : 0) + (ask_conflict_.is_open() ? 16 : 0);
}

// Events that came with one that opened or closed a dialog wait for the next frame, when it is really there (or
// gone): on a slow machine a whole sentence of keys can arrive between two frames, and each must reach whom it was
// meant for.
void App::deliver_events() {
  const int before = dialog();
  while (!events_.empty() && dialog() == before && !holds_input()) {
    const Event event = std::move(events_.front());
    events_.pop_front();
    // Of many moves in a row the last one says all, but to a stroke being drawn and to a recording.
    const bool is_stroke = (canvas_.tool_id() == ToolId::spray || record_.is_recording()) && canvas_.has_pointer();
    if (event.is_move && !is_stroke && !events_.empty() && events_.front().is_move) continue;
    event.run();
  }
  if (!events_.empty() && !holds_input()) frames_wanted_ = std::max(frames_wanted_, 2);
}

void App::on_pointer_left() {
  events_.push_back({false, [this] {
                       if (!canvas_.has_pointer()) canvas_.leave();
                     }});
}

void App::on_button(PointerButton button, bool pressed, Modifiers modifiers) {
  events_.push_back({false, [this, button, pressed, modifiers, px = pointer_px_] {
                       if (!pressed) {
                         canvas_.release(button, px, modifiers);
                         return;
                       }
                       if (canvas_.has_pointer() || gui_.wants_pointer(px)) return;
                       messages_.clear_remark();
                       canvas_.press(button, px, modifiers);
                     }});
}

void App::on_wheel(double steps) {
  events_.push_back({false, [this, steps, px = pointer_px_] {
                       if (canvas_.has_pointer() || !gui_.wants_pointer(px)) canvas_.wheel(px, steps);
                     }});
}

// Dialogs take all keys; Esc (and for the help page its own keys) closes them.
bool App::close_top_dialog(const KeyChord& chord) {
  const bool is_escape = chord.symbol == key::escape;
  if (show_help_) {
    if (is_escape || find_action(chord, false) == ActionId::help) show_help_ = false;
    return true;
  }
  if (ask_recover_.is_open()) {
    if (is_escape) ask_recover_.close();
    return true;
  }
  if (ask_unsaved_.is_open()) {
    if (is_escape) ask_unsaved_.close();
    return true;
  }
  if (ask_conflict_.is_open()) {
    if (is_escape) {
      ask_conflict_.close();
      after_save_ = {};
    }
    return true;
  }
  if (browser_.is_open()) {
    if (is_escape) {
      browser_.close();
      after_save_ = {};
    }
    return true;
  }
  return false;
}

void App::run_by_key(const KeyChord& chord, bool repeated) {
  if (close_top_dialog(chord)) return;
  if (gui_.wants_text()) return;
  if (chord.symbol == key::escape && gui_.close_popup()) return;
  if (gui_.has_popup()) return;
  const auto action = find_action(chord, !editor_.selection().is_empty());
  if (!action || (repeated && !descriptor_of(*action).repeats)) return;
  // A gesture under way is ended only by Esc; the document must not change beneath it.
  if (canvas_.has_pointer() && *action != ActionId::deselect) return;
  actions_.run(*action);
}

void App::on_key(const KeyChord& chord, bool repeated) {
  // What a recording waits for may be what is to be cancelled.
  if (holds_input() && find_action(chord, false) == ActionId::cancel_computation) {
    run_by_key(chord, repeated);
    return;
  }
  events_.push_back({false, [this, chord, repeated] { run_by_key(chord, repeated); }});
}

void App::on_typed(char32_t symbol, bool repeated) {
  const KeyChord chord{symbol, {}};
  if (is_typed_symbol(chord)) events_.push_back({false, [this, chord, repeated] { run_by_key(chord, repeated); }});
}

void App::on_space(bool held) {
  canvas_.set_space_held(held && !gui_.wants_text() && !gui_.has_popup());
}

void App::on_files_dropped(std::vector<std::string> files) {
  if (files.empty()) return;
  // Of several pictures the last is on top; the others would not be seen.
  const auto first_picture = std::stable_partition(
      files.begin(), files.end(), [](const std::string& file) { return !render::is_picture_file(file); });
  const std::string picture = first_picture == files.end() ? std::string() : files.back();
  files.erase(first_picture, files.end());
  open_files(files, picture);
}

void App::on_close_wanted() {
  actions_.run(ActionId::quit);
}

}  // namespace mes
