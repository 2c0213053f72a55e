// SPDX-License-Identifier: GPL-3.0-or-later
// Many samples moved in one step: the triangulation takes them along at once where it can. After each step everything
// equals a graph that sees the final samples only.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "core/base/rng.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using Targets = std::vector<std::pair<SampleId, Vec2>>;

void show_few(TestBench& bench) {
  bench.show({"curve", "medial-axis", "delaunay", "voronoi", "label-conflicts", "curve-normals", "anti-crust-edges"});
}

std::vector<Vec2> positions_of(const TestBench& bench) {
  std::vector<Vec2> out;
  for (const SampleSlot slot : bench.document().slots_in_input_order())
    out.push_back(bench.document().position(slot));
  return out;
}

void check(const TestBench& bench) {
  REQUIRE(broken_row(bench.graph()) == "");
  TestBench fresh;
  show_few(fresh);
  fresh.replace(positions_of(bench));
  REQUIRE(difference(bench.state(), fresh.state()) == "");
  for (const char* layer : {"curve", "medial-axis", "delaunay", "voronoi", "label-conflicts", "curve-normals"}) {
    INFO(layer);
    REQUIRE(bench.mirror().digest(find_layer(layer)) == fresh.mirror().digest(find_layer(layer)));
  }
}

bool was_rebuilt(const TestBench& bench) {
  const auto& nodes = bench.patch().nodes;
  return std::ranges::find(nodes, std::string("delaunay"), &NodeReport::structure)->rebuilt;
}

/// Those that `where` is true of, each to where `to` has it.
void move_all(TestBench& bench, const std::function<bool(std::size_t, Vec2)>& where,
              const std::function<Vec2(Vec2)>& to) {
  Targets targets;
  std::size_t number = 0;
  for (const SampleSlot slot : bench.document().slots_in_input_order()) {
    const Vec2 p = bench.document().position(slot);
    if (where(number++, p)) targets.emplace_back(bench.document().id(slot), to(p));
  }
  bench.move(targets);
}

}  // namespace

TEST_CASE("a stretch of a curve goes across the shape and comes back") {
  TestBench bench;
  show_few(bench);
  bench.replace(benchmark_curve(3000));
  const std::vector<Vec2> before = positions_of(bench);
  const auto stretch = [](std::size_t number, Vec2) { return number >= 1200 && number < 1500; };
  Rng rng(5);
  int updates = 0;
  for (int step = 0; step < 30; ++step) {
    // From a hundredth of a spacing, which is 0.5, to a hundred of them.
    const double far = 0.005 * std::pow(10.0, 4.0 * rng.uniform());
    const double angle = 6.3 * rng.uniform();
    move_all(bench, stretch, [&](Vec2 p) { return p + far * Vec2{std::cos(angle), std::sin(angle)}; });
    INFO("step " << step << ", by " << far);
    check(bench);
    updates += was_rebuilt(bench) ? 0 : 1;
  }
  CHECK(updates == 30);
  while (bench.steps_done() > 1) bench.undo();
  check(bench);
  CHECK(positions_of(bench) == before);
}

TEST_CASE("random samples are shaken, moved as a block and turned") {
  TestBench bench;
  show_few(bench);
  bench.replace(uniform_square(1500));
  Rng rng(6);
  int updates = 0;
  for (int step = 0; step < 45; ++step) {
    INFO("step " << step);
    const Vec2 middle{400.0 * rng.uniform(), 400.0 * rng.uniform()};
    const double far = std::pow(10.0, 3.0 * rng.uniform() - 1.0);
    const auto near = [&](std::size_t, Vec2 p) { return distance(p, middle) < 70.0; };
    if (step % 3 == 0) {
      move_all(bench, near, [&](Vec2 p) { return p + far * Vec2{rng.uniform() - 0.5, rng.uniform() - 0.5}; });
    } else if (step % 3 == 1) {
      move_all(bench, near, [&](Vec2 p) { return p + Vec2{far, -0.3 * far}; });
    } else {
      const double angle = 0.02 * far;
      move_all(bench, near, [&](Vec2 p) {
        const Vec2 d = p - middle;
        return middle + std::cos(angle) * d + std::sin(angle) * perpendicular(d);
      });
    }
    check(bench);
    updates += was_rebuilt(bench) ? 0 : 1;
  }
  CHECK(updates > 30);
}

TEST_CASE("a block of a lattice goes over the others, where all is cocircular and positions repeat") {
  TestBench bench;
  show_few(bench);
  bench.replace(integer_lattice(18).positions);
  Rng rng(7);
  int updates = 0;
  for (int step = 0; step < 60; ++step) {
    INFO("step " << step);
    const double left = static_cast<double>(rng.below(14)), low = static_cast<double>(rng.below(14));
    const auto block = [&](std::size_t, Vec2 p) {
      return p.x >= left && p.x < left + 5.0 && p.y >= low && p.y < low + 5.0;
    };
    const Vec2 way{0.5 * static_cast<double>(rng.below(9)) - 2.0, 0.5 * static_cast<double>(rng.below(9)) - 2.0};
    if (rng.below(5) == 0) {
      bench.undo();
    } else {
      move_all(bench, block, [&](Vec2 p) { return p + way; });
    }
    check(bench);
    updates += was_rebuilt(bench) ? 0 : 1;
  }
  CHECK(updates > 20);
}

TEST_CASE("samples that are all on the hull, and samples that meet") {
  std::vector<Vec2> positions;
  for (int i = 0; i < 600; ++i) positions.push_back(100.0 * Vec2{std::cos(0.01047 * i), std::sin(0.01047 * i)});
  for (int i = 0; i < 200; ++i) positions.push_back(0.3 * positions[static_cast<std::size_t>(3 * i)]);
  TestBench bench;
  show_few(bench);
  bench.replace(positions);
  // An arc goes in and out again, and the inner circle with it.
  for (const double factor : {0.99, 0.7, 1.5, 0.97}) {
    INFO("factor " << factor);
    move_all(
        bench, [](std::size_t number, Vec2) { return number < 40 || (number > 620 && number < 660); },
        [&](Vec2 p) { return factor * p; });
    check(bench);
  }
  // All to one place, and each to the next one's.
  move_all(
      bench, [](std::size_t number, Vec2) { return number > 700 && number < 740; },
      [](Vec2) {
        return Vec2{1.0, 2.0};
      });
  check(bench);
  bench.undo();
  check(bench);
  const std::vector<Vec2> now = positions_of(bench);
  move_all(
      bench, [](std::size_t number, Vec2) { return number >= 640 && number < 690; },
      [&](Vec2 p) { return now[static_cast<std::size_t>(std::ranges::find(now, p) - now.begin()) + 1]; });
  check(bench);
}
