// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manual/man_page.h"

#include <fmt/core.h>
#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "app/actions/actions.h"

namespace mes::cli {
namespace {

// Escapes all markup, so that a hyphen is the character that users type.
std::string in_roff(std::string_view text) {
  std::string out;
  bool is_line_start = true;
  for (const char c : text) {
    if (is_line_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    is_line_start = c == '\n';
  }
  return out;
}

std::string bold(std::string_view text) {
  return "\\fB" + in_roff(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + in_roff(text) + "\\fR";
}

std::string section(std::string_view title) {
  std::string out(".SH ");
  for (const char c : title) out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out + '\n';
}

std::string item(const std::string& name, std::string_view text) {
  return fmt::format(".TP\n{}\n{}\n", name, in_roff(text));
}

std::string heading_of(const OptionHelp& option) {
  if (option.is_positional) return italic(option.names.front());
  std::string out;
  for (const std::string& name : option.names) out += (out.empty() ? "" : ", ") + bold(name);
  if (option.value != nullptr) out += ' ' + italic(option.value->name);
  if (!option.default_value.empty()) out += " (default: " + in_roff(option.default_value) + ')';
  return option.is_required ? out + " (required)" : out;
}

std::string options_of(const CommandHelp& command) {
  std::string out;
  for (const OptionHelp& option : command.options) out += item(heading_of(option), option.text);
  return out;
}

std::string usage_of(const CommandHelp& command) {
  std::string out = bold(command.name);
  for (const OptionHelp& option : command.options)
    if (!option.is_positional && option.is_required)
      out += ' ' + bold(option.names.front()) + ' ' + italic(option.value->name);
  out += " [" + italic("OPTIONS") + ']';
  for (const OptionHelp& option : command.options) {
    if (!option.is_positional) continue;
    const std::string name = italic(option.names.front());
    out += ' ' + (option.is_required ? name : '[' + name + "...]");
  }
  return out + '\n';
}

// "Examples:" with indented lines becomes a section with unchanged lines, "Input: text" one with text.
std::string sections_of(std::string_view footer) {
  std::string out;
  while (!footer.empty()) {
    const std::string_view paragraph = footer.substr(0, footer.find("\n\n"));
    footer.remove_prefix(std::min(footer.size(), paragraph.size() + 2));
    const std::size_t colon = paragraph.find(':');
    const std::string_view text = paragraph.substr(colon + 1);
    out += section(paragraph.substr(0, colon));
    if (text.starts_with('\n')) {
      out += ".nf\n" + in_roff(text.substr(1)) + "\n.fi\n";
      continue;
    }
    std::string line;
    for (const char c : text)
      if (c != ' ' || (!line.empty() && line.back() != '\n')) line += c;
    out += in_roff(line) + '\n';
  }
  return out;
}

std::string keys() {
  std::string out = section("Keys of the window");
  for (const ActionDescriptor& action : action_descriptors()) {
    if (action.keys.empty()) continue;
    std::string all;
    for (const std::string_view key : action.keys) all += (all.empty() ? "" : ", ") + bold(key);
    out += item(all, fmt::format("{}: {}.", action.name, action.tooltip));
  }
  for (const GestureDescriptor& gesture : gesture_descriptors()) out += item(bold(gesture.input), gesture.meaning);
  return out;
}

std::string files() {
  return section("Environment") +
         item(bold("MESECINA_ASSETS"), "The folder of shapes, fonts, bundles and colour maps of the program.") +
         section("Files") +
         item(italic("$XDG_DATA_HOME/mesecina, ~/.local/share/mesecina"), "Bundles, colour maps, unsaved work.") +
         item(italic("$XDG_CONFIG_HOME/mesecina, ~/.config/mesecina"), "Settings of the window.");
}

}  // namespace

std::string man_page(std::span<const CommandHelp> commands) {
  const CommandHelp& program = commands.front();
  std::string out = ".\\\" Written by `mesecina manual --man`.\n";
  out += ".TH MESECINA 1 \"\" \"Mesecina " MESECINA_VERSION "\" \"User Commands\"\n.ad l\n";
  out += section("Name") + "mesecina \\- sample\\-based geometry in the plane, live\n";
  out += section("Synopsis") + ".nf\n";
  for (const CommandHelp& command : commands) out += usage_of(command);
  out += ".fi\n" + section("Description") + in_roff(program.summary) + '\n';
  out += section("Options") + options_of(program) + section("Commands");
  for (const CommandHelp& command : commands.subspan(1)) {
    out += fmt::format(".SS {}\n{}.\n{}", in_roff(command.name), in_roff(command.summary), options_of(command));
    if (!command.footer.empty()) out += ".PP\n" + in_roff(command.footer) + '\n';
  }
  return out + sections_of(program.footer) + keys() + files();
}

}  // namespace mes::cli
