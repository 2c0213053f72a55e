// SPDX-License-Identifier: GPL-3.0-or-later
// What the values of options are: how help pages name them, and what a shell offers for them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mes {
class Registry;
}

namespace mes::cli {

enum class ValueKind : std::uint8_t { text, file, folder, choice, choices };  // choices: separated by commas

struct OptionValue {
  std::string_view option;  ///< "--layers"; "FILE" for what is given by its position
  std::string_view name;    ///< in help pages; empty where the option's own name says enough
  ValueKind kind = ValueKind::text;
  std::vector<std::string> (*offer)(const Registry& registry) = nullptr;  ///< what there is to choose from
  std::string_view command = {};  ///< the only one that it is so in; empty: all others
};

/// Of an option of a command. A text without a name of its own for options that are not in the table.
const OptionValue& value_of(std::string_view command, std::string_view option);

/// The shells that `mesecina completions` knows.
std::vector<std::string> shell_names();

}  // namespace mes::cli
