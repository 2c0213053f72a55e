// SPDX-License-Identifier: GPL-3.0-or-later
// Distributes groups of lines, each with a heading, over columns of about the same height.
//
// Guarantees:
//  1. All lines are there once, in their order. A group may go on in the next column, under its heading again.
//  2. Below a heading there are two lines at least, unless its group has only one; so no line stands alone.
//  3. No other height of columns under which the lines are filled in one after the other is lower.
//
// Cost: some twenty passes over the lines. Threads: any.
#pragma once

#include <cstddef>
#include <vector>

namespace mes {

/// The lines of one group in one column, from `first` to before `end`.
struct ColumnPart {
  std::size_t group = 0;
  std::size_t first = 0;
  std::size_t end = 0;
};
using EvenColumns = std::vector<std::vector<ColumnPart>>;

/// `groups`: the heights of the lines of each group; `heading`: the height of a heading; `most`: number of columns, at
/// least one.
EvenColumns even_columns(const std::vector<std::vector<float>>& groups, float heading, std::size_t most);

}  // namespace mes
