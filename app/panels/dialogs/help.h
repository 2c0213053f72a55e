// SPDX-License-Identifier: GPL-3.0-or-later
// One page with every key and gesture, from the action table.
#pragma once

#include <string>
#include <utility>

#include "app/actions/keymap.h"
#include "app/ui/dialogs/dialog.h"

namespace mes {

/// A click beside the page or on its cross closes it, and so do Enter and the keys that open it.
class HelpPage final : public Dialog {
 public:
  /// Sets the keys to show, which must outlive the page, and the file that changes them.
  void set_keys(const Keymap& keymap, std::string keys_file) {
    keymap_ = &keymap;
    keys_file_ = std::move(keys_file);
  }
  void toggle() { is_open_ = !is_open_; }

  bool is_open() const override { return is_open_; }
  void cancel() override { is_open_ = false; }
  void draw(const Gui& gui) override;
  bool is_cancelled_by(const KeyChord& chord) const override;

 private:
  const Keymap* keymap_ = nullptr;
  std::string keys_file_;
  bool is_open_ = false;
  float height_ = 860.0F;  // of the window, in logical pixels, if the screen has room for it
};

}  // namespace mes
