// SPDX-License-Identifier: GPL-3.0-or-later
// Trees of maxima against a plain loop, while values come, change and go.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "core/base/max_tree.h"
#include "core/base/rng.h"
#include "core/base/slot.h"

using namespace mes;

namespace {

using RowSlot = Slot<struct RowTag>;
constexpr double kNone = -std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("the row with the largest value is that of a plain loop") {
  Rng rng(1);
  for (const std::size_t rows : {0U, 1U, 2U, 3U, 8U, 9U, 100U}) {
    std::vector<double> values(rows);
    for (double& value : values) value = static_cast<double>(rng.below(8));
    MaxTree<RowSlot> tree;
    CHECK(tree.is_empty());
    CHECK(tree.largest() == kNone);
    tree.build(rows, [&](RowSlot row) { return values[row.index()]; });
    for (int change = 0; change < 400; ++change) {
      const auto largest = std::ranges::max_element(values);
      REQUIRE(tree.largest() == (values.empty() ? kNone : *largest));
      if (tree.largest() != kNone)
        REQUIRE(tree.row_of_largest().index() == static_cast<std::size_t>(largest - values.begin()));
      // Most changes are of rows that are there; some make rows, with a gap or without.
      const std::size_t row = rng.below(static_cast<std::uint32_t>(values.size() + 3));
      if (row >= values.size()) values.resize(row + 1, kNone);
      values[row] = rng.below(4) == 0 ? kNone : static_cast<double>(rng.below(8));
      tree.set(RowSlot(row), values[row]);
    }
    tree.clear();
    CHECK(tree.largest() == kNone);
  }
}
