// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and their options as data: what the manual, the man page and the completions of shells are made from.
#pragma once

#include <string>
#include <vector>

#include "app/cli/option_values.h"

namespace CLI {
class App;
}

namespace mes::cli {

struct OptionHelp {
  std::vector<std::string> names{};    ///< "-o", "--output"; the name alone of what is given by its position
  std::string text{};                  ///< may have several lines
  std::string default_value{};         ///< empty: none
  const OptionValue* value = nullptr;  ///< null: the option takes no value
  bool is_positional = false;
  bool is_required = false;
  bool may_repeat = false;
};

struct CommandHelp {
  std::string name{};     ///< "mesecina", "mesecina compute"
  std::string summary{};  ///< what it does, in its own words
  std::string page{};     ///< what --help prints
  std::string footer{};   ///< paragraphs after the options, separated by empty lines
  std::vector<OptionHelp> options{};
};

/// Gives the value of each option the name that `OptionValue` has for it, so that help pages say it, and names flags in
/// them as they are typed.
void name_values(CLI::App& app);

/// The program itself first, then its commands.
std::vector<CommandHelp> help_of(const CLI::App& app);

/// The first sentence of a text, for places of one line.
std::string brief(const std::string& text);

}  // namespace mes::cli
