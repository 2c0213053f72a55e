// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how well typed letters match a name.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace mes {

struct FuzzyMatch {
  double score = 0.0;                ///< larger is better; comparable within one query
  std::vector<std::size_t> letters;  ///< matching bytes of the text, ascending
  /// Letters that are neither next to the one before nor at the beginning of a word.
  std::size_t scattered = 0;
};

/// Each word of the query must occur in the text, with its letters in order but not necessarily adjacent; case does
/// not matter. The best match of each word counts: adjacent letters and beginnings of words weigh most, gaps cost,
/// and of equal matches the shorter text wins. An empty query matches everything. Returns nothing if a word is not
/// found. Cost: O(|query| |text|).
std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text);

}  // namespace mes
