// SPDX-License-Identifier: GPL-3.0-or-later
// The desktop's own file dialog, where the desktop has one: the interface FileChooser of the portals of Freedesktop
// (xdg-desktop-portal), over D-Bus.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace mes {

struct DesktopQuestion {
  bool is_saving = false;
  std::string heading{};
  std::filesystem::path folder{};  ///< that is shown first
  std::string name{};              ///< that is proposed for saving
  struct Filter {
    std::string name;
    std::vector<std::string> patterns;  ///< such as "*.poff"
  };
  std::vector<Filter> filters{};  ///< the first is chosen to begin with
  std::string window{};           ///< above which the dialog lies: "x11:" and its number in hexadecimal, or empty
};

struct DesktopAnswer {
  enum class Kind : std::uint8_t { chosen, cancelled, unavailable };
  Kind kind = Kind::unavailable;
  std::filesystem::path file{};  ///< when it was chosen
};

/// Whether asking makes sense: this program can, and a session bus is named. Costs a look at the environment.
bool may_have_desktop_dialog();

/// Shows the dialog and waits for its end. `unavailable`: the desktop has none, it failed, or it has not begun within
/// ten seconds. A stop closes the dialog and is answered with `cancelled`. Replacing a file was agreed to there, for
/// the name that is returned. Threads: any but the window's, because it waits.
DesktopAnswer ask_desktop(const DesktopQuestion& question, const std::stop_token& stop);

}  // namespace mes
