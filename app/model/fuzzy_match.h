// SPDX-License-Identifier: GPL-3.0-or-later
// How well some typed letters fit a name.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace mes {

struct FuzzyMatch {
  double score = 0.0;                ///< larger is better; comparable for one query
  std::vector<std::size_t> letters;  ///< bytes of the text that matched, ascending
};

/// Each word of the query must be found in the text, its letters in their order but not necessarily side by side; case
/// does not count. Of all ways to find a word the best counts: letters side by side and at beginnings of words weigh
/// most, gaps cost, and of equal matches the shorter text wins. An empty query fits everything. Nothing when a word is
/// not found. Cost: O(|query| |text|).
std::optional<FuzzyMatch> fuzzy_match(std::string_view query, std::string_view text);

}  // namespace mes
