// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace mes {

/// A field for a name in a dialog. It has the keyboard from the moment the dialog is requested, so letters that are
/// typed before the field is visible are not lost. The proposed name is selected, so typing replaces it.
class NameField {
 public:
  /// Takes the keyboard; for the first frame of the dialog.
  void focus();
  /// Shows a name that was replaced from elsewhere, selects it, and takes the keyboard.
  void show_replaced() {
    focus();
    is_replaced_ = true;
  }
  /// Returns true when Enter confirmed the name.
  bool draw(const char* label, const char* hint, std::string& name);

 private:
  bool wants_focus_ = false;
  bool waits_ = false;  // waits for the keyboard
  bool is_replaced_ = false;
  std::string early_;  // typed while waiting
};

}  // namespace mes
