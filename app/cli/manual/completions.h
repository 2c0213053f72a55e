// SPDX-License-Identifier: GPL-3.0-or-later
// Shell scripts that complete the commands, options and values of the program.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/console/interruption.h"
#include "app/cli/manual/command_help.h"
#include "app/cli/requests/requests.h"
#include "core/base/error.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// Joins the words with spaces.
std::string joined_words(const std::vector<std::string>& words);

struct Shell {
  std::string_view name;
  std::string (*script)(const Registry& registry, std::span<const CommandHelp> commands);
};

std::span<const Shell> shells();

/// The scripts can be read by their shells as they are; equal programs give equal bytes.
std::string bash_completions(const Registry& registry, std::span<const CommandHelp> commands);
std::string zsh_completions(const Registry& registry, std::span<const CommandHelp> commands);
std::string fish_completions(const Registry& registry, std::span<const CommandHelp> commands);

Expected<void> run_completions(const Registry& registry, const CompletionsRequest& request,
                               std::span<const CommandHelp> commands, Interruption& interruption);

}  // namespace mes::cli
