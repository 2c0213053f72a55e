// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates of vertices as drawings list them, read many at a time. Private to core/io.
//
// The ends of numbers are found for 64 bytes at once, so that no number waits for the previous one. Source of the idea:
// Langdale and Lemire, "Parsing gigabytes of JSON per second", VLDB Journal 28 (2019).
//
// Smallest use:
//     std::array<Vec2, 256> pairs;
//     const PairRun run = read_coordinate_pairs("1,2 3.5-4 L 5 6 ...", 'L', pairs);
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "core/base/geometry/vec2.h"

namespace mes {

struct PairRun {
  std::size_t size = 0;   ///< bytes up to the end of the last pair
  std::size_t count = 0;  ///< number of pairs
};

/// Reads pairs of decimal numbers from the beginning of the text, up to the first unusual one. Between numbers are
/// blanks with at most one comma, or nothing before a minus sign; before a pair, `letter` may replace the comma. The
/// text begins with a number, unless it follows a pair. Exponents, plus signs, numbers of many digits and anything else
/// are left to the caller, as are all pairs on machines without SSE2. Rounds as `std::from_chars` does. Cost: about
/// five nanoseconds a pair.
PairRun read_coordinate_pairs(std::string_view text, char letter, std::span<Vec2> out, bool follows_a_pair = false);

}  // namespace mes
