// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/rng.h"
#include "core/base/slot.h"

using namespace mes;

namespace {

using RowOfTest = Slot<struct RowOfTestTag>;

}  // namespace

TEST_CASE("rows are together when they were joined, by labels in plain loops") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Rng rng(seed);
    std::size_t count = 1 + rng.below(40);
    DisjointSets<RowOfTest> sets(count);
    std::vector<std::size_t> label(count);
    for (std::size_t i = 0; i < count; ++i) label[i] = i;
    for (int step = 0; step < 60; ++step) {
      if (rng.below(8) == 0) {
        sets.grow(count + 3);
        for (int i = 0; i < 3; ++i) label.push_back(count++);
      }
      const auto row = [&] { return RowOfTest(static_cast<RowNumber>(rng.below(count))); };
      const RowOfTest a = sets.root(row());
      const RowOfTest b = sets.root(row());
      const RowOfTest joined = sets.join(a, b);
      CHECK((joined == a || joined == b));
      std::ranges::replace(label, std::size_t{label[a.index()]}, label[b.index()]);
      for (RowNumber i = 0; i < count; ++i) {
        REQUIRE((sets.root(RowOfTest(i)) == joined) == (label[i] == label[b.index()]));
        for (RowNumber j = 0; j < i; ++j)
          REQUIRE((sets.root(RowOfTest(i)) == sets.root(RowOfTest(j))) == (label[i] == label[j]));
      }
    }
    sets.reset(count);
    for (RowNumber i = 0; i < count; ++i) REQUIRE(sets.root(RowOfTest(i)) == RowOfTest(i));
  }
}
