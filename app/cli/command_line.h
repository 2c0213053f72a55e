// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the program.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mes {
class Registry;
}

namespace mes::cli {

struct WindowRequest {
  std::vector<std::string> files;
  std::vector<std::string> experiments;
  int link = -1;          ///< the socket of a program whose document is shown; -1: none
  bool presents = false;  ///< the lesson of the first file
};

/// Opens the window; returns the exit code.
using OpenWindow = std::function<int(WindowRequest)>;

/// Runs the command in the arguments with the contents of the registry, or the window if there is no command. Returns
/// the exit code.
int run_command_line(const Registry& registry, int argc, const char* const* argv, const OpenWindow& open_window);

/// The manual of the program with this registry, as Markdown.
std::string complete_manual(const Registry& registry, const std::filesystem::path& assets);

}  // namespace mes::cli
