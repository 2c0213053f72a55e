// SPDX-License-Identifier: GPL-3.0-or-later
// The interactive window as one call.
#pragma once

#include <string>
#include <vector>

namespace mes {

class Registry;

struct WindowOptions {
  std::vector<std::string> files;          ///< the first is opened; none: a built-in shape
  std::vector<std::string> experiments{};  ///< files or folders, added while the window is open
  int link = -1;                           ///< a socket to a program whose document this is (LinkRun); none: -1
  std::string executable;                  ///< as the program was called; finds what comes with it
};

/// Runs until the window is closed, and shows what the registry has. Exit code of the program: 0, or 4 without display or
/// OpenGL, with one line on stderr.
int run_window(const Registry& registry, const WindowOptions& options);

}  // namespace mes
