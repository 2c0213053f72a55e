// SPDX-License-Identifier: GPL-3.0-or-later
// Binds actions to their effects and to the keys in force: the keys of the settings, changed by the user's file.
#pragma once

#include <filesystem>

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/settings/settings.h"

namespace mes {

/// Guarantees: the file is read once and never changed; its errors are reported in one message with their lines, and
/// the rest of it is valid. Threads: the window's.
class KeyBindings {
 public:
  KeyBindings(Settings& settings, Messages& messages);

  ActionBindings& actions() { return actions_; }

  /// $XDG_CONFIG_HOME/mesecina/keys.conf; empty when no home folder is known.
  static std::filesystem::path file();
  void bind();

 private:
  void apply();
  void write();
  void read();

  Settings& settings_;
  ActionBindings actions_;
  Messages& messages_;
  std::string text_;  // text of the file
};

}  // namespace mes
