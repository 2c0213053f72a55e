// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "app/ui/widgets/even_columns.h"
#include "core/base/rng.h"

using namespace mes;

TEST_CASE(
    "columns hold every line once, in order, with no line alone, and are as even as their longest block allows") {
  Rng rng(11);
  constexpr float kHeading = 24;
  for (int round = 0; round < 400; ++round) {
    std::vector<std::vector<float>> groups(1 + rng.next() % 8);
    float tallest = 0;
    float all = 0;
    for (auto& lines : groups) {
      lines.resize(1 + rng.next() % 30);
      for (float& line : lines) line = 18.0F * static_cast<float>(1 + rng.next() % 3);
      for (const float line : lines) tallest = std::max(tallest, line);
      for (const float line : lines) all += line;
      all += kHeading;
    }
    const std::size_t most = 1 + rng.next() % 4;
    const EvenColumns columns = even_columns(groups, kHeading, most);
    REQUIRE(columns.size() <= most);
    std::size_t group = 0;
    std::size_t line = 0;
    float highest = 0;
    for (const auto& column : columns) {
      REQUIRE_FALSE(column.empty());
      float height = 0;
      for (const ColumnPart& part : column) {
        if (line == groups[group].size()) {
          ++group;
          line = 0;
        }
        REQUIRE(part.group == group);
        REQUIRE(part.first == line);
        REQUIRE(part.end > part.first);
        REQUIRE((part.end - part.first >= 2 || groups[group].size() == 1));
        line = part.end;
        height += kHeading;
        for (std::size_t i = part.first; i < part.end; ++i) height += groups[group][i];
      }
      highest = std::max(highest, height);
    }
    REQUIRE(group + 1 == groups.size());
    REQUIRE(line == groups[group].size());
    // A column lacks less than a block of three lines with its heading; each column may repeat a heading.
    const auto count = static_cast<float>(most);
    CHECK(highest <= all / count + count * kHeading + 3 * tallest + 1);
  }
}
