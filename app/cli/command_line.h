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

/// Opens the window on files, or with the document of a program at a socket; returns the exit code.
using OpenWindow = std::function<int(std::vector<std::string> files, std::vector<std::string> experiments, int link)>;

/// Runs the command in the arguments with the contents of the registry, or the window if there is no command. Returns
/// the exit code.
int run_command_line(const Registry& registry, int argc, const char* const* argv, const OpenWindow& open_window);

/// The manual of the program with this registry, as Markdown.
std::string complete_manual(const Registry& registry, const std::filesystem::path& assets);

}  // namespace mes::cli
