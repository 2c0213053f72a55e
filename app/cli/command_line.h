// SPDX-License-Identifier: GPL-3.0-or-later
// The program as the shell sees it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace mes {
class Registry;
}

namespace mes::cli {

/// Opens the window on files, or with the document of a program at a socket, and gives the exit code.
using OpenWindow = std::function<int(std::vector<std::string> files, std::vector<std::string> experiments, int link)>;

/// Runs the command that the arguments ask for, with what the registry has, or the window when they ask for none; gives
/// the exit code.
int run_command_line(const Registry& registry, int argc, const char* const* argv, const OpenWindow& open_window);

}  // namespace mes::cli
