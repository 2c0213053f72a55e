// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/cli/manual/completions.h"

namespace mes::cli {
namespace {

constexpr std::string_view kBegin = R"(# Completions of mesecina for bash, written by `mesecina completions bash`.
_mesecina_choices() {
  mapfile -t COMPREPLY < <(compgen -W "$2" -- "$1")
  if [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]]; then compopt -o nospace; fi
}
# Those of a list that is separated by commas.
_mesecina_list() {
  local last=${1##*,}
  mapfile -t COMPREPLY < <(compgen -P "${1%"$last"}" -W "$2" -- "$last")
  compopt -o nospace
}
_mesecina_files() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen "$2" -- "$1")
}
_mesecina() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
  if [[ $current == '=' ]]; then
    current=
  elif [[ $before == '=' ]] && ((COMP_CWORD > 2)); then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if ((COMP_CWORD > 1)); then command=${COMP_WORDS[1]}; fi
  COMPREPLY=()
)";

std::string reply(const Registry& registry, const OptionValue& value) {
  switch (value.kind) {
    case ValueKind::choice: return R"(_mesecina_choices "$current" ')" + joined_words(value.offer(registry)) + '\'';
    case ValueKind::choices: return R"(_mesecina_list "$current" ')" + joined_words(value.offer(registry)) + '\'';
    case ValueKind::file: return R"(_mesecina_files "$current" -f)";
    case ValueKind::folder: return R"(_mesecina_files "$current" -d)";
    case ValueKind::text: break;
  }
  return ":";
}

std::string last_word(const std::string& name) {
  return name.substr(name.rfind(' ') + 1);
}

// The words that fit after an option, or in the position of an argument.
std::string cases_of(const Registry& registry, const CommandHelp& command, std::string_view indent) {
  std::string out;
  std::string at_its_place = ":";
  std::vector<std::string> names;
  for (const OptionHelp& option : command.options) {
    if (option.is_positional) {
      at_its_place = reply(registry, *option.value);
      continue;
    }
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (option.value == nullptr) continue;
    std::string pattern;
    for (const std::string& name : option.names) pattern += (pattern.empty() ? "" : " | ") + name;
    out += fmt::format("{}{}) {} ;;\n", indent, pattern, reply(registry, *option.value));
  }
  return out + fmt::format("{}*) if [[ $current == -* ]]; then _mesecina_choices \"$current\" '{}'; else {}; fi ;;\n",
                           indent, joined_words(names), at_its_place);
}

}  // namespace

std::string bash_completions(const Registry& registry, std::span<const CommandHelp> commands) {
  std::string out(kBegin);
  std::vector<std::string> names;
  std::vector<std::string> options;
  for (const CommandHelp& command : commands.subspan(1)) names.push_back(last_word(command.name));
  for (const OptionHelp& option : commands.front().options)
    if (!option.is_positional) options.insert(options.end(), option.names.begin(), option.names.end());
  out += "  case $command in\n";
  for (const CommandHelp& command : commands.subspan(1))
    out += fmt::format("    {})\n      case $before in\n{}      esac ;;\n", last_word(command.name),
                       cases_of(registry, command, "        "));
  out += "    *)\n      _mesecina_choices \"$current\" '" + joined_words(options) + "'\n" +
         "      if [[ $current != -* ]]; then\n        local files=()\n" +
         "        mapfile -t files < <(compgen -f -- \"$current\")\n        compopt -o filenames\n        " +
         "COMPREPLY=(\"${files[@]}\")\n        if ((COMP_CWORD == 1)); then\n          mapfile -t -O ${#files[@]} " +
         "COMPREPLY < <(compgen -W '" + joined_words(names) +
         "' -- \"$current\")\n        fi\n      fi ;;\n  esac\n}\n" + "complete -F _mesecina mesecina\n";
  return out;
}

}  // namespace mes::cli
