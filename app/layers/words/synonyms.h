// SPDX-License-Identifier: GPL-3.0-or-later
// Everyday words for what the program calls by the terms of its field.
#pragma once

#include <span>
#include <string_view>

namespace mes {

struct Synonyms {
  std::string_view id;     ///< public id of an action, layer, parameter or evolution
  std::string_view words;  ///< in lower case, separated by spaces
};

/// The whole table, for tests.
std::span<const Synonyms> all_synonyms();

/// Other words for what has this public id; empty if there are none.
std::string_view synonyms_of(std::string_view id);

}  // namespace mes
