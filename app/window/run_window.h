// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the interactive window in one call.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mes {

class Registry;

struct WindowOptions {
  std::vector<std::string> files;          ///< the first is opened; empty: a built-in shape
  bool presents = false;                   ///< the lesson of the first file
  std::vector<std::string> experiments{};  ///< files or folders, added while the window is open
  int link = -1;                           ///< a socket to the program that owns this document (LinkRun); -1: none
  std::string executable;                  ///< the name by which it was called; locates its files
  /// Writes the manual of a registry, with the files of the program in `assets`, as Markdown.
  std::function<std::string(const Registry&, const std::filesystem::path& assets)> manual;
};

/// Runs until the window is closed, and offers the contents of the registry. Returns the exit code of the program: 0,
/// or 4 without display or OpenGL, with one line on stderr.
int run_window(const Registry& registry, const WindowOptions& options);

}  // namespace mes
