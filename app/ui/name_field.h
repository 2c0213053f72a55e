// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace mes {

/// A line for a name in a dialog. It has the keyboard from the moment the dialog is asked for: what is typed before
/// the field is on screen is not lost. A name proposed is selected, so typing replaces it.
class NameField {
 public:
  /// With the dialog's first frame.
  void focus();
  /// True: the name was confirmed by Enter.
  bool draw(const char* label, const char* hint, std::string& name);

 private:
  bool wants_focus_ = false;
  bool waits_ = false;  // for the keyboard
  std::string early_;   // typed while waiting
};

}  // namespace mes
