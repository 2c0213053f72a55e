// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manual/command_help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string_view>

namespace mes::cli {
namespace {

bool takes_value(const CLI::Option& option) {
  return option.get_type_size() != 0 && option.get_items_expected_max() > 0;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (!option.nonpositional()) return {option.get_name(true)};
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

OptionHelp option_help(const CLI::Option& option, std::string_view command) {
  OptionHelp out{.names = names_of(option), .text = option.get_description()};
  out.is_positional = !option.nonpositional();
  out.is_required = option.get_required();
  if (!takes_value(option)) return out;
  out.value = &value_of(command, out.names.back());
  out.default_value = option.get_default_str();
  out.may_repeat =
      option.get_items_expected_max() > 1 || option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return out;
}

CommandHelp command_help(const CLI::App& app, const std::string& name) {
  CommandHelp out{.name = name, .summary = app.get_description(), .page = app.help(), .footer = app.get_footer()};
  for (const CLI::Option* option : app.get_options()) out.options.push_back(option_help(*option, app.get_name()));
  return out;
}

/// CLI11 marks flags that switch something off: "--no-legend{false}". This formatter does not.
class PlainNames final : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    std::string out = CLI::Formatter::make_option_name(option, is_positional);
    for (std::size_t at = out.find('{'); at != std::string::npos; at = out.find('{'))
      out.erase(at, out.find('}', at) + 1 - at);
    return out;
  }
};

}  // namespace

void name_values(CLI::App& app) {
  app.formatter(std::make_shared<PlainNames>());
  for (CLI::Option* option : app.get_options())
    if (takes_value(*option)) option->type_name(std::string(value_of(app.get_name(), names_of(*option).back()).name));
  for (CLI::App* command : app.get_subcommands({})) name_values(*command);
}

std::vector<CommandHelp> help_of(const CLI::App& app) {
  std::vector<CommandHelp> out{command_help(app, app.get_name())};
  for (const CLI::App* command : app.get_subcommands({})) {
    out.push_back(command_help(*command, app.get_name() + ' ' + command->get_name()));
    out.back().page = command->help(app.get_name());
  }
  return out;
}

std::string brief(const std::string& text) {
  std::string out = text;
  std::ranges::replace(out, '\n', ' ');
  for (const std::string_view end : {". ", "; ", " (", ": "}) {
    const std::size_t found = out.find(end);
    // A short beginning such as "csv: one primitive a line" says little without the rest.
    constexpr std::size_t kShortest = 12;
    if (found != std::string::npos && found >= kShortest) out.resize(found);
  }
  return out;
}

}  // namespace mes::cli
