// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts that let shells complete the commands, options and values of the program.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/command_help.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// The words with spaces between them.
std::string joined_words(const std::vector<std::string>& words);

struct Shell {
  std::string_view name;
  std::string (*script)(const Registry& registry, std::span<const CommandHelp> commands);
};

std::span<const Shell> shells();

/// Each of them is read by its shell as it stands; equal programs give equal bytes.
std::string bash_completions(const Registry& registry, std::span<const CommandHelp> commands);
std::string zsh_completions(const Registry& registry, std::span<const CommandHelp> commands);
std::string fish_completions(const Registry& registry, std::span<const CommandHelp> commands);

}  // namespace mes::cli
