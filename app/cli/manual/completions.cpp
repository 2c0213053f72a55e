// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manual/completions.h"

#include <array>

#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/requests.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

constexpr std::array<Shell, 3> kShells{
    {{"bash", bash_completions}, {"zsh", zsh_completions}, {"fish", fish_completions}}};

}  // namespace

std::string joined_words(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::span<const Shell> shells() {
  return kShells;
}

Expected<void> run_completions(const Registry& registry, const CompletionsRequest& request,
                               std::span<const CommandHelp> commands, Interruption& interruption) {
  if (auto good = check_output(request.output); !good) return good;
  std::vector<std::string_view> names;
  for (const Shell& shell : kShells) {
    names.push_back(shell.name);
    if (shell.name == request.shell)
      return write_output(request.output, shell.script(registry, commands), interruption);
  }
  return usage_error("no completions for " + in_quotes(request.shell) + "; the shell is one of " + one_of(names));
}

}  // namespace mes::cli
