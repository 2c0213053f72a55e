// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "app/editing/curves/curve_selector.h"
#include "tests/support/bell.h"

using namespace mes;
using mes::test::Bell;

namespace {

constexpr int kRound = 24;
constexpr int kLine = 7;

// Samples 0 to 23 are a circle, 24 to 30 a stroke far from it, 31 lies where 2 does.
struct SelectorBench {
  Editor editor{[](auto) {}};
  Bell bell;
  CurveSelector selector{editor, bell.ring()};

  SelectorBench() {
    SampleData data;
    for (int i = 0; i < kRound; ++i)
      data.positions.push_back(
          {std::cos(i * 2 * 3.14159265358979 / kRound), std::sin(i * 2 * 3.14159265358979 / kRound)});
    for (int i = 0; i < kLine; ++i) data.positions.push_back({40 + 0.1 * i, 0.01 * i * i});
    data.positions.push_back(data.positions[2]);
    REQUIRE(editor.load(data));
  }
  void select(std::initializer_list<std::uint32_t> rows) {
    editor.selection().clear();
    for (const std::uint32_t row : rows) editor.selection().add(SampleSlot(row));
  }
  std::vector<std::uint32_t> after(CurveSelector::Wish wish) {
    selector.begin(wish);
    finish();
    std::vector<std::uint32_t> out;
    for (const SampleSlot slot : editor.selection().slots()) out.push_back(static_cast<std::uint32_t>(slot.index()));
    return out;
  }
  void finish() {
    bell.wait_until([&] {
      if (selector.is_under_way()) REQUIRE(selector.follow());
      return !selector.is_under_way();
    });
  }
};

}  // namespace

TEST_CASE("the curve of what is selected is selected, and no other") {
  SelectorBench bench;
  using enum CurveSelector::Wish;
  bench.select({5});
  std::vector<std::uint32_t> circle;
  for (std::uint32_t i = 0; i < kRound; ++i) circle.push_back(i);
  circle.push_back(31);
  CHECK(bench.after(whole) == circle);
  bench.select({25});
  CHECK(bench.after(whole) == std::vector<std::uint32_t>{24, 25, 26, 27, 28, 29, 30});
  // A sample that lies on another one is on its curve.
  bench.select({31});
  CHECK(bench.after(whole) == circle);
  bench.select({});
  CHECK(bench.after(whole).empty());
}

TEST_CASE("a selection grows along the curve and shrinks back, around a closed one and to the ends of an open one") {
  SelectorBench bench;
  using enum CurveSelector::Wish;
  bench.select({10});
  CHECK(bench.after(grow) == std::vector<std::uint32_t>{9, 10, 11});
  CHECK(bench.after(grow) == std::vector<std::uint32_t>{8, 9, 10, 11, 12});
  CHECK(bench.after(shrink) == std::vector<std::uint32_t>{9, 10, 11});
  CHECK(bench.after(shrink) == std::vector<std::uint32_t>{10});
  CHECK(bench.after(shrink).empty());
  bench.select({0});
  CHECK(bench.after(grow) == std::vector<std::uint32_t>{0, 1, 23});
  bench.select({24});
  CHECK(bench.after(grow) == std::vector<std::uint32_t>{24, 25});
  bench.select({1});
  CHECK(bench.after(grow) == std::vector<std::uint32_t>{0, 1, 2, 31});
  CHECK(bench.after(shrink) == std::vector<std::uint32_t>{1});
}

TEST_CASE("wishes that come while the curve is being found are all fulfilled") {
  SelectorBench bench;
  bench.select({10});
  for (int i = 0; i < 3; ++i) bench.selector.begin(CurveSelector::Wish::grow);
  CHECK(bench.after(CurveSelector::Wish::shrink) == std::vector<std::uint32_t>{8, 9, 10, 11, 12});
}

TEST_CASE("a document that changes meanwhile drops the wish") {
  SelectorBench bench;
  bench.select({5});
  bench.selector.begin(CurveSelector::Wish::whole);
  const std::vector<Vec2> one{{0.5, 0.25}};
  REQUIRE(bench.editor.insert(one, "Insert"));
  bench.finish();
  CHECK(bench.editor.selection().sample_count() == 1);
}

TEST_CASE("what was selected along the curve is said, and why nothing changed") {
  SelectorBench bench;
  using enum CurveSelector::Wish;
  CHECK(bench.selector.take_remark().empty());
  bench.select({10});
  static_cast<void>(bench.after(grow));
  CHECK(bench.selector.take_remark() == "Selected 3 samples");
  CHECK(bench.selector.take_remark().empty());
  static_cast<void>(bench.after(whole));
  CHECK(bench.selector.take_remark() == "Selected 25 samples");
  static_cast<void>(bench.after(whole));
  CHECK_THAT(bench.selector.take_remark(), Catch::StartsWith("The curves of the selected samples"));
  static_cast<void>(bench.after(grow));
  CHECK_THAT(bench.selector.take_remark(), Catch::StartsWith("The selection has no neighbours"));
  static_cast<void>(bench.after(shrink));
  CHECK_THAT(bench.selector.take_remark(), Catch::StartsWith("No selected sample has an unselected neighbour"));
  bench.select({});
  static_cast<void>(bench.after(grow));
  CHECK(bench.selector.take_remark().empty());
}

TEST_CASE("a selection that is another one of the same size is said to be selected") {
  SelectorBench bench;
  const std::vector<Vec2> twin{bench.editor.document().position(SampleSlot(24))};
  REQUIRE(bench.editor.insert(twin, "Insert"));
  bench.select({25, 32});
  // The end of the stroke takes the place of its neighbour.
  CHECK(bench.after(CurveSelector::Wish::shrink) == std::vector<std::uint32_t>{24, 32});
  CHECK(bench.selector.take_remark() == "Selected 2 samples");
}
