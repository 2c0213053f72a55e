// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates of vertices as drawings list them, read many at a time. Private to core/io.
//
// Where numbers end is found for 64 bytes at once, so that no number waits for the one before it to be read. Source of
// the idea: Langdale and Lemire, "Parsing gigabytes of JSON per second", VLDB Journal 28 (2019).
//
// Smallest use:
//     std::array<Vec2, 256> pairs;
//     const PairRun run = read_coordinate_pairs("1,2 3.5-4 L 5 6 ...", 'L', pairs);
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "core/base/vec2.h"

namespace mes {

struct PairRun {
  std::size_t size = 0;   ///< bytes from the beginning, up to the end of the last pair
  std::size_t count = 0;  ///< pairs
};

/// Pairs of decimal numbers from the beginning of the text on, as far as they go without any difficulty. Between numbers
/// stand blanks with at most one comma, or nothing before a minus sign; before a pair `letter` may stand instead, with
/// blanks. The first number stands at the beginning, unless the text follows a pair. An exponent, a plus sign, a number of many digits and anything else is left to
/// others, as are all pairs on machines without SSE2. Numbers are rounded as
/// `std::from_chars` does. Cost: some five nanoseconds a pair.
PairRun read_coordinate_pairs(std::string_view text, char letter, std::span<Vec2> out, bool follows_a_pair = false);

}  // namespace mes
