// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/cli/manual/completions.h"

namespace mes::cli {
namespace {

// Quotes a text for single quotes, where `special` characters have a meaning of their own.
std::string quoted_for_zsh(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
      continue;
    }
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

// ":NAME:ACTION": name of the value and its completion.
std::string action(const Registry& registry, const OptionHelp& option) {
  const OptionValue& value = *option.value;
  const std::string name = value.name.empty() ? option.names.back() : std::string(value.name);
  switch (value.kind) {
    case ValueKind::choice:
      // The name of a parameter is followed directly by its value, without a space.
      return value.name.ends_with("VALUE")
                 ? fmt::format(":{}:{{compadd -S \"\" -- {}}}", name, joined_words(value.offer(registry)))
                 : fmt::format(":{}:({})", name, joined_words(value.offer(registry)));
    case ValueKind::choices:
      return fmt::format(":{0}:_values -s , {0} {1}", name, joined_words(value.offer(registry)));
    case ValueKind::file: return ':' + name + ":_files";
    case ValueKind::folder: return ':' + name + ":_files -/";
    case ValueKind::text: break;
  }
  return ':' + name + ": ";
}

std::string specification(const Registry& registry, const OptionHelp& option) {
  if (option.is_positional)
    return '\'' + (option.may_repeat ? "*" + action(registry, option) : action(registry, option)) + '\'';
  const std::string text = '[' + quoted_for_zsh(brief(option.text), "[]:\\") + ']';
  const std::string value = option.value == nullptr ? "" : action(registry, option);
  if (option.names.size() == 1)
    return '\'' + std::string(option.may_repeat ? "*" : "") + option.names.front() + text + value + '\'';
  std::string all;
  std::string braces;
  for (const std::string& name : option.names) {
    all += (all.empty() ? "" : " ") + name;
    braces += (braces.empty() ? "" : ",") + name;
  }
  return fmt::format("'({})'{{{}}}'{}{}'", all, braces, text, value);
}

std::string arguments(const Registry& registry, const CommandHelp& command, const std::string& indent) {
  std::string out = "_arguments";
  for (const OptionHelp& option : command.options) out += " \\\n" + indent + specification(registry, option);
  return out;
}

}  // namespace

std::string zsh_completions(const Registry& registry, std::span<const CommandHelp> commands) {
  std::string out = "#compdef mesecina\n# Completions of mesecina for zsh, written by `mesecina completions zsh`.\n";
  out += "_mesecina_first() {\n  local -a commands=(\n";
  std::string cases;
  for (const CommandHelp& command : commands.subspan(1)) {
    const std::string name = command.name.substr(command.name.rfind(' ') + 1);
    out += fmt::format("    '{}:{}'\n", name, quoted_for_zsh(command.summary, ""));
    cases += fmt::format("    {})\n      shift words\n      ((CURRENT--))\n      {}\n      ;;\n", name,
                         arguments(registry, command, "        "));
  }
  out += "  )\n  _describe command commands\n  _files\n}\n";
  out +=
      "_mesecina() {\n  if ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n    _mesecina_first\n    return\n  fi\n";
  out += "  case $words[2] in\n" + cases + "    *)\n      " + arguments(registry, commands.front(), "        ") +
         "\n      ;;\n  esac\n}\n_mesecina \"$@\"\n";
  return out;
}

}  // namespace mes::cli
