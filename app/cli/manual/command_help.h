// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and their options as data: the source of the manual, the man page and the shell completions.
#pragma once

#include <string>
#include <vector>

#include "app/cli/manual/option_values.h"

namespace CLI {
class App;
}

namespace mes::cli {

struct OptionHelp {
  std::vector<std::string> names{};    ///< "-o", "--output"; a positional argument has only its name
  std::string text{};                  ///< may have several lines
  std::string default_value{};         ///< empty: none
  const OptionValue* value = nullptr;  ///< null: the option takes no value
  bool is_positional = false;
  bool is_required = false;
  bool may_repeat = false;
};

struct CommandHelp {
  std::string name{};     ///< "mesecina", "mesecina compute"
  std::string summary{};  ///< effect, in the command's own words
  std::string page{};     ///< output of --help
  std::string footer{};   ///< paragraphs after the options, separated by empty lines
  std::vector<OptionHelp> options{};
};

/// Gives the value of each option its name from `OptionValue`, for the help pages, and shows flags there as the user
/// types them.
void name_values(CLI::App& app);

/// Help of the program itself, followed by its commands.
std::vector<CommandHelp> help_of(const CLI::App& app);

/// The first sentence of a text, for places with room for one line.
std::string brief(const std::string& text);

}  // namespace mes::cli
