// SPDX-License-Identifier: GPL-3.0-or-later
// A dialog with a question and a button for each answer.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "app/ui/dialogs/dialog.h"

namespace mes {

/// Enter presses the default button, which stands out; Left, Right and Tab make another one the default. Esc cancels.
///
/// Threads: the window's.
class Question : public Dialog {
 public:
  void press(const KeyChord& chord) override;

 protected:
  /// Draws the question while the dialog is open: the heading, what `draw_rest` draws below it, and the buttons. Heading
  /// and rest are scrolled if they are too high for the window.
  /// Returns the index of the answer that was given. `usual`: the default button when the dialog opens.
  std::optional<std::size_t> draw_question(const Gui& gui, const char* id, std::span<const char* const> answers,
                                           std::size_t usual, const std::string& heading,
                                           const std::function<void(float width)>& draw_rest);

 private:
  float body_ = 0.0F;         // height of heading and rest, as of the last frame
  std::ptrdiff_t steps_ = 0;  // of the default button, since the dialog opened
  bool is_confirmed_ = false;
};

}  // namespace mes
