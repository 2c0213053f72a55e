// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/cli/manual/completions.h"

namespace mes::cli {
namespace {

std::string quoted_for_fish(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + '\'';
}

std::string argument(const Registry& registry, const OptionValue& value) {
  switch (value.kind) {
    case ValueKind::choice: return " -x -a " + quoted_for_fish(joined_words(value.offer(registry)));
    case ValueKind::choices:
      return " -x -a " + quoted_for_fish("(__fish_append , " + joined_words(value.offer(registry)) + ")");
    case ValueKind::file: return " -r -F";
    case ValueKind::folder: return " -x -a " + quoted_for_fish("(__fish_complete_directories)");
    case ValueKind::text: break;
  }
  return " -x";
}

std::string line(const Registry& registry, const std::string& condition, const OptionHelp& option) {
  std::string out = "complete -c mesecina -n " + quoted_for_fish(condition);
  if (option.is_positional) {
    if (option.value->kind == ValueKind::file) return out + " -F\n";
    if (option.value->kind == ValueKind::text) return out + " -f\n";
    return out + " -f -a " + quoted_for_fish(joined_words(option.value->offer(registry))) + '\n';
  }
  for (const std::string& name : option.names)
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.value != nullptr) out += argument(registry, *option.value);
  return out + " -d " + quoted_for_fish(brief(option.text)) + '\n';
}

}  // namespace

std::string fish_completions(const Registry& registry, std::span<const CommandHelp> commands) {
  std::string out = "# Completions of mesecina for fish, written by `mesecina completions fish`.\n";
  const std::string first = "__fish_use_subcommand";
  for (const OptionHelp& option : commands.front().options) out += line(registry, first, option);
  for (const CommandHelp& command : commands.subspan(1)) {
    const std::string name = command.name.substr(command.name.rfind(' ') + 1);
    out += fmt::format("complete -c mesecina -n {} -a {} -d {}\n", first, name, quoted_for_fish(command.summary));
    for (const OptionHelp& option : command.options)
      out += line(registry, "__fish_seen_subcommand_from " + name, option);
  }
  return out;
}

}  // namespace mes::cli
