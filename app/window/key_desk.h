// SPDX-License-Identifier: GPL-3.0-or-later
// What actions do and the keys in force: those chosen in the settings, changed by the user's file.
#pragma once

#include <filesystem>

#include "app/actions/action_bindings.h"
#include "app/model/messages.h"
#include "app/model/settings.h"

namespace mes {

/// What it guarantees: the file is read once and never changed; what is wrong in it is one message with the lines, and
/// everything else in it holds. Threads: the window's.
class KeyDesk {
 public:
  KeyDesk(Settings& settings, Messages& messages);

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
  std::string text_;  // of the file
};

}  // namespace mes
