// SPDX-License-Identifier: GPL-3.0-or-later
// The values of options: their names in help pages, and the words that a shell offers for them.
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
  std::string_view option;  ///< "--layers"; "FILE" for a positional argument
  std::string_view name;    ///< in help pages; empty if the option's own name is clear enough
  ValueKind kind = ValueKind::text;
  std::vector<std::string> (*offer)(const Registry& registry) = nullptr;  ///< the words to choose from
  std::string_view command = {};  ///< the only command to which this applies; empty: all others
};

/// The value of an option of a command. Options that are not in the table have a text without a name.
const OptionValue& value_of(std::string_view command, std::string_view option);

/// The shells that `mesecina completions` knows.
std::vector<std::string> shell_names();

}  // namespace mes::cli
