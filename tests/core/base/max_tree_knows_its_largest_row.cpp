// SPDX-License-Identifier: GPL-3.0-or-later
// Trees of maxima against a plain loop, while values come, change and go.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
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

TEST_CASE("of several rows with the largest value the first is known, by an order that changes with the rows") {
  struct Thing {
    double value = kNone;
    std::uint32_t key = 0;  // the order; read of no row without a value
  };
  Rng rng(2);
  for (const std::size_t rows : {0U, 1U, 2U, 5U, 64U, 100U}) {
    std::vector<Thing> things(rows);
    std::uint32_t next = 0;
    const auto change = [&](std::size_t row) {
      if (row >= things.size()) things.resize(row + 1);
      // Keys are different, and in no order.
      things[row] = {rng.below(4) == 0 ? kNone : static_cast<double>(rng.below(3)), 2654435761U * ++next};
    };
    for (std::size_t row = 0; row < rows; ++row) change(row);
    bool is_asked_of_none = false;
    const auto value_of = [&](RowSlot row) {
      return row.index() < things.size() ? things[row.index()].value : kNone;
    };
    const auto is_first = [&](RowSlot a, RowSlot b) {
      is_asked_of_none = is_asked_of_none || value_of(a) == kNone || value_of(a) != value_of(b);
      return things[a.index()].key < things[b.index()].key;
    };
    MaxTree<RowSlot> tree;
    tree.build(rows, value_of, is_first);
    for (int step = 0; step < 400; ++step) {
      const auto best = std::ranges::max_element(things, [](const Thing& a, const Thing& b) {
        return a.value != b.value ? a.value < b.value : a.key > b.key;
      });
      const double largest = things.empty() ? kNone : best->value;
      REQUIRE(tree.largest() == largest);
      if (largest != kNone) REQUIRE(tree.row_of_largest().index() == static_cast<std::size_t>(best - things.begin()));
      std::vector<RowSlot> changed;
      const std::uint64_t count = 1 + rng.below(6);
      for (std::uint64_t i = 0; i < count; ++i) {
        const std::size_t row = rng.below(static_cast<std::uint32_t>(things.size() + (step % 50 == 0 ? 3 : 1)));
        if (row >= things.size() && things.size() > rows + 20) continue;
        change(row);
        changed.emplace_back(row);
      }
      tree.set_all(changed, value_of, is_first);
    }
    CHECK_FALSE(is_asked_of_none);
  }
}
