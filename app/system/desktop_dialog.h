// SPDX-License-Identifier: GPL-3.0-or-later
// The desktop's own file dialog, if the desktop has one: the interface FileChooser of the portals of Freedesktop
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
  std::filesystem::path folder{};  ///< the folder shown first
  std::string name{};              ///< the name proposed for saving
  struct Filter {
    std::string name;
    std::vector<std::string> patterns;  ///< such as "*.poff"
  };
  std::vector<Filter> filters{};  ///< the first one is selected at first
  std::string window{};           ///< the parent window: "x11:" and its number in hexadecimal, or empty
};

struct DesktopAnswer {
  enum class Kind : std::uint8_t { chosen, cancelled, unavailable };
  Kind kind = Kind::unavailable;
  std::filesystem::path file{};  ///< the chosen file
};

/// True if asking makes sense: this program can, and a session bus is named. Only looks at the environment.
bool may_have_desktop_dialog();

/// Shows the dialog and waits for its end. `unavailable`: the desktop has no dialog, it failed, or it has not
/// appeared within ten seconds. A stop closes the dialog and gives `cancelled`. The dialog has already asked whether
/// to replace an existing file of the returned name. Threads: any but the window's, because the function waits.
DesktopAnswer ask_desktop(const DesktopQuestion& question, const std::stop_token& stop);

}  // namespace mes
