// SPDX-License-Identifier: GPL-3.0-or-later
// Events of the window: panels have first refusal, then the canvas, then the table of actions.
#include "app/window/app.h"

namespace mes {
namespace {

constexpr int kSettlingFrames = 3;

}  // namespace

void App::on_anything() {
  frames_wanted_ = kSettlingFrames;
}

void App::on_pointer_moved(Vec2 px, Modifiers modifiers) {
  pointer_px_ = px;
  pointer_modifiers_ = modifiers;
  pointer_moved_ = true;
}

void App::deliver_pointer() {
  if (!pointer_moved_) return;
  pointer_moved_ = false;
  if (canvas_.has_pointer() || !gui_.wants_pointer(pointer_px_))
    canvas_.move(pointer_px_, pointer_modifiers_);
  else
    canvas_.leave();
}

void App::on_pointer_left() {
  if (!canvas_.has_pointer()) canvas_.leave();
  pointer_moved_ = false;
}

void App::on_button(PointerButton button, bool pressed, Modifiers modifiers) {
  deliver_pointer();
  if (!pressed) {
    canvas_.release(button, pointer_px_, modifiers);
    return;
  }
  if (canvas_.has_pointer() || gui_.wants_pointer(pointer_px_)) return;
  messages_.clear_remark();
  canvas_.press(button, pointer_px_, modifiers);
}

void App::on_wheel(double steps) {
  if (!canvas_.has_pointer() && gui_.wants_pointer(pointer_px_)) return;
  canvas_.wheel(pointer_px_, steps);
}

// Dialogs take all keys; Esc (and for the help page its own keys) closes them.
bool App::close_top_dialog(const KeyChord& chord) {
  const bool is_escape = chord.symbol == key::escape;
  if (show_help_) {
    if (is_escape || find_action(chord, false) == ActionId::help) show_help_ = false;
    return true;
  }
  if (ask_unsaved_.is_open()) {
    if (is_escape) ask_unsaved_.close();
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
  if (gui_.wants_text() || gui_.has_popup()) return;
  const auto action = find_action(chord, !editor_.selection().is_empty());
  if (!action || (repeated && !descriptor_of(*action).repeats)) return;
  // A gesture under way is ended only by Esc; the document must not change beneath it.
  if (canvas_.has_pointer() && *action != ActionId::deselect) return;
  actions_.run(*action);
}

void App::on_key(const KeyChord& chord, bool repeated) {
  run_by_key(chord, repeated);
}

void App::on_typed(char32_t symbol, bool repeated) {
  const KeyChord chord{symbol, {}};
  if (is_typed_symbol(chord)) run_by_key(chord, repeated);
}

void App::on_space(bool held) {
  canvas_.set_space_held(held && !gui_.wants_text() && !gui_.has_popup());
}

void App::on_files_dropped(std::vector<std::string> files) {
  if (files.empty()) return;
  open_file(files.front());
  if (files.size() > 1) messages_.remark("Opened the first of " + std::to_string(files.size()) + " files");
}

void App::on_close_wanted() {
  actions_.run(ActionId::quit);
}

}  // namespace mes
