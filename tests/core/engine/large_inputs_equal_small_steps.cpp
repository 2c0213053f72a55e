// SPDX-License-Identifier: GPL-3.0-or-later
// Large inputs, whose rebuild may work in pieces and on several threads, against the same samples added batch by
// batch, each small enough to be an update; and against being taken away again.
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "core/structures/delaunay/delaunay.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

// Along a curve in order, each prefix is an open stroke, whose ends see half of it; that is another matter.
std::vector<Vec2> shuffled(std::vector<Vec2> positions) {
  Rng rng(31);
  for (std::size_t i = positions.size(); i > 1; --i) std::swap(positions[i - 1], positions[rng.below(i)]);
  return positions;
}

void check_grown(const std::vector<Vec2>& positions) {
  const ComparedBench at_once(positions);
  const GeometryState expected = at_once.state();
  CHECK(broken_row(at_once.graph()) == "");
  const std::int64_t decided = at_once.count("one-step-crust", "decided_by_static_filter") +
                               at_once.count("one-step-crust", "decided_by_intervals") +
                               at_once.count("one-step-crust", "decided_exactly");
  CHECK(decided == at_once.count("delaunay", "edges"));

  const std::size_t start = positions.size() / 3;
  ComparedBench grown({positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(start)});
  int updates = 0;
  for (std::size_t from = start; from < positions.size();) {
    const std::size_t to = std::min(positions.size(), from + from / 12 + 1);
    grown.insert(
        {positions.begin() + static_cast<std::ptrdiff_t>(from), positions.begin() + static_cast<std::ptrdiff_t>(to)});
    for (const NodeReport& node : grown.patch().nodes)
      if (node.structure == "one-step-crust") updates += node.rebuilt ? 0 : 1;
    from = to;
  }
  CHECK(updates > 5);
  CHECK(broken_row(grown.graph()) == "");
  CHECK(difference(grown.state(), expected) == "");
  for (const char* key : {"nodes", "edges", "components", "cycles", "leaves", "branch_points", "isolated"})
    CHECK(grown.count("medial-axis", key) == at_once.count("medial-axis", key));

  // Back to the start by undo: updates again.
  while (grown.steps_done() > 1) grown.undo();
  const ComparedBench beginning({positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(start)});
  CHECK(difference(grown.state(), beginning.state()) == "");
}

}  // namespace

// From 40000 samples on, triangulations are made in parts.
TEST_CASE("a large smooth curve") {
  check_grown(shuffled(benchmark_curve(42000)));
}

TEST_CASE("duplicates in many parts") {
  const std::vector<Vec2> positions = duplicate_heavy(90000);
  const ComparedBench bench(positions);
  CHECK(broken_row(bench.graph()) == "");
  std::vector<Vec2> once = positions;
  std::ranges::sort(once, lexicographically_less);
  once.erase(std::ranges::unique(once).begin(), once.end());
  CHECK(bench.get<Delaunay>().site_count() == once.size());
}

TEST_CASE("parts that lie on a line") {
  // Three sides of a frame, and many samples in one place beside it.
  std::vector<Vec2> positions(2000, Vec2{-1.0, -1.0});
  for (int i = 0; i < 30000; ++i)
    for (const Vec2 p : {Vec2{0.0, 1.0 * i}, Vec2{30000.0, 1.0 * i}, Vec2{1.0 * i, 0.0}}) positions.push_back(p);
  TestBench bench;
  bench.show({"curve", "medial-axis"});
  bench.replace(shuffled(positions));
  CHECK(broken_row(bench.graph()) == "");
  CHECK(bench.get<Delaunay>().site_count() == 90000);
  CHECK(bench.count("delaunay", "hull_edges") == 30002);
}

TEST_CASE("two parts that lie on parallel lines, in order along them") {
  // In this order each sample of the second line would take the edges of the one before.
  constexpr std::int64_t kInRow = 150'000;
  std::vector<Vec2> positions;
  for (const double y : {0.0, 1e6})
    for (std::int64_t i = 0; i < kInRow; ++i)
      positions.push_back({static_cast<double>(i) + (y == 0.0 ? 0.0 : 0.25), y});
  TestBench bench;
  bench.show({"delaunay", "curve", "medial-axis"});
  bench.replace(positions);
  CHECK(broken_row(bench.graph()) == "");
  CHECK(bench.get<Delaunay>().site_count() == 2 * kInRow);
  CHECK(bench.count("delaunay", "hull_edges") == 2 * kInRow);
  CHECK(bench.count("delaunay", "edges") == 4 * kInRow - 3);
}

TEST_CASE("a large curve with corners") {
  check_grown(shuffled(rough_curve(30000)));
}

TEST_CASE("many random points, odd ones everywhere") {
  check_grown(uniform_square(15000));
}

TEST_CASE("a large lattice, where every quadruple is cocircular") {
  constexpr std::int64_t kSide = 110;
  const ComparedBench bench(shuffled(integer_lattice(kSide).positions));
  CHECK(broken_row(bench.graph()) == "");
  CHECK(bench.count("one-step-crust", "crust_edges") == 2 * kSide * (kSide - 1));
  CHECK(bench.count("one-step-crust", "odd_samples") == 4 * (kSide - 2));
  CHECK(bench.count("one-step-crust", "cocircular_edges") == (kSide - 1) * (kSide - 1));
}

TEST_CASE("a stretch of a curve is moved together, through the curve and out of it") {
  const std::vector<Vec2> positions = benchmark_curve(6000);
  ComparedBench bench(positions);
  const std::vector<SampleId> ids = bench.ids();
  Box2 extent;
  for (const Vec2 p : positions) extent.add(p);
  constexpr std::size_t kMoved = 200;
  // A step of a hand, into the shape, onto the far side, and beyond it.
  for (const double share : {0.001, 0.3, 0.6, 1.5}) {
    std::vector<Vec2> moved = positions;
    std::vector<std::pair<SampleId, Vec2>> targets;
    for (std::size_t i = 0; i < kMoved; ++i) {
      moved[i] = positions[i] + share * Vec2{extent.width(), 0.25 * extent.height()};
      targets.emplace_back(ids[i], moved[i]);
    }
    bench.move(targets);
    const auto delaunay = std::ranges::find(bench.patch().nodes, "delaunay", &NodeReport::structure);
    REQUIRE(delaunay != bench.patch().nodes.end());
    CHECK_FALSE(delaunay->rebuilt);
    CHECK(broken_row(bench.graph()) == "");
    CHECK(difference(bench.state(), ComparedBench(moved).state()) == "");
  }
  while (bench.steps_done() > 1) bench.undo();
  CHECK(difference(bench.state(), ComparedBench(positions).state()) == "");
}
