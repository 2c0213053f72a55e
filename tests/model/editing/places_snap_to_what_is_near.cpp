// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/canvas/tools/ball_tool.h"
#include "app/canvas/tools/insert_tool.h"
#include "app/canvas/tools/select_tool.h"
#include "app/editing/tools/snapper.h"
#include "app/editing/tools/vertex_near.h"
#include "core/base/rng.h"
#include "core/document/taken_samples.h"
#include "core/kernel/circumcircle.h"
#include "tests/model/editing/tool_hand.h"

using namespace mes;
using mes::test::click;

namespace {

// A pixel is a hundredth of a unit, so what is within 0.08 is near.
Pointer at_unit(double x, double y, Modifiers modifiers = {}) {
  return {{100 * x, -100 * y}, {x, y}, 0.01, modifiers};
}
constexpr Modifiers kCtrl{.ctrl = true};

struct SnapBench {
  Editor editor{[](auto) {}};
  AnnotationEditor annotations{editor};
  SnapSettings settings{.is_on = true};
  double grid = 0.5;
  Snapper snapper{editor, annotations, settings, [this] { return Snapper::Steps{grid, 0.01}; }};
  double spacing = 10.0;
  ToolContext context{editor, annotations, spacing, [](const Error& error) { FAIL(error.message()); }};

  SnapBench() {
    REQUIRE(editor.load({.positions = {{0.013, 0.017}, {3.1, 0.02}, {1.4, 2.3}}, .balls = {{{7.03, 3.07}, 1.31}}}));
    context.snapper = &snapper;
  }
  std::optional<Snap> snap(Vec2 p, double reach = 0.08) const { return snapper.at(p, reach, {}); }
};

}  // namespace

TEST_CASE("a curve that samples were taken from is meant before the grid, and after points") {
  SnapBench bench;
  PlaneCurve line({0, 0});
  line.line_to({4, 2});
  const auto curves = std::make_shared<const CurveSet>(CurveSet{.curves = {line}});
  const SamplingRequest request{.rule = SamplingRule::vertices};
  REQUIRE(bench.editor.load(*taken_from(curves, *sample(*curves, request), request)));
  const auto on_curve = bench.snap({2.02, 0.99});
  REQUIRE(on_curve);
  CHECK(on_curve->name == "curve");
  CHECK(on_curve->place.x == Approx(2.012));
  CHECK(on_curve->place.y == Approx(1.006));
  CHECK(bench.snap({0.02, 0.03})->name == "sample");
  CHECK(bench.snap({3.05, 0.27})->name == "line of the grid");
  bench.settings.curves = false;
  CHECK(bench.snap({2.02, 0.99})->name == "grid");
}

TEST_CASE("the nearest point is meant, then a circle, then the grid") {
  SnapBench bench;
  const auto sample = bench.snap({0.05, 0.0});
  REQUIRE(sample);
  CHECK(sample->place == Vec2{0.013, 0.017});
  CHECK(sample->name == "sample");
  const auto center = bench.snap({7.0, 3.0});
  REQUIRE(center);
  CHECK(center->place == Vec2{7.03, 3.07});
  CHECK(center->name == "centre of a ball");
  const auto circle = bench.snap({7.03, 4.43});
  REQUIRE(circle);
  CHECK(circle->name == "circle of a ball");
  CHECK(distance(circle->place, {7.03, 3.07}) == Approx(1.31));
  const auto crossing = bench.snap({5.05, -1.46});
  REQUIRE(crossing);
  CHECK(crossing->place == Vec2{5.0, -1.5});
  CHECK(crossing->name == "grid");
  const auto line = bench.snap({5.05, -1.3});
  REQUIRE(line);
  CHECK(line->place == Vec2{5.0, -1.3});
  CHECK_FALSE(bench.snap({5.2, -1.3}));
}

TEST_CASE("a vertex is the centre of the circle through its three samples") {
  const SnapBench bench;
  const Vec2 vertex{1.5565, 0.8};
  const auto snap = bench.snap(vertex, 0.2);
  REQUIRE(snap);
  CHECK(snap->name == "Voronoi vertex");
  const Document& document = bench.editor.document();
  const double radius = distance(snap->place, document.position(SampleSlot(0)));
  CHECK(distance(snap->place, document.position(SampleSlot(1))) == Approx(radius));
  CHECK(distance(snap->place, document.position(SampleSlot(2))) == Approx(radius));
}

TEST_CASE("what is switched off is no target") {
  SnapBench bench;
  bench.settings.samples = false;
  bench.settings.grid = false;
  CHECK_FALSE(bench.snap({0.05, 0.0}));
  bench.settings = {};
  CHECK_FALSE(bench.snap({0.05, 0.0}));
  bench.settings = {.is_on = true};
  bench.grid = 0.0;
  CHECK_FALSE(bench.snap({5.05, -1.46}));
}

TEST_CASE("coordinates on the grid are the doubles that decimal numbers are read as") {
  SnapBench bench;
  for (const auto& [step, place, expected] : {std::tuple{0.1, 0.3001, 0.3},
                                              {0.1, 0.7, 0.7},
                                              {0.02, 1.1399, 1.14},
                                              {0.005, -0.0351, -0.035},
                                              {2e-5, 0.00034, 0.00034},
                                              {1e-11, 1.9461e-8, 1.946e-8},
                                              {50.0, 1249.0, 1250.0},
                                              {2.0, 5.01, 6.0}}) {
    bench.grid = step;
    const auto snap = bench.snap({place, -50 * step}, step);
    REQUIRE(snap);
    if (snap->name.ends_with("grid")) CHECK(snap->place.x == expected);
  }
}

TEST_CASE("tools put things where they snap, and Ctrl holds that off") {
  SnapBench bench;
  bench.settings.samples = false;
  InsertTool insert(bench.context);
  click(insert, at_unit(5.04, -1.52));
  const Document& document = bench.editor.document();
  CHECK(document.position(SampleSlot(3)) == Vec2{5.0, -1.5});
  CHECK(insert.feedback().snap);
  click(insert, at_unit(6.04, -1.52, kCtrl));
  CHECK(document.position(SampleSlot(4)) == Vec2{6.04, -1.52});
  CHECK_FALSE(insert.feedback().snap);
  insert.leave();
  CHECK_FALSE(insert.feedback().snap);

  // A sample on another one would change nothing.
  bench.settings.samples = true;
  bench.settings.grid = false;
  insert.hover(at_unit(3.12, 0.03));
  CHECK_FALSE(insert.feedback().snap);
  const auto vertex = bench.snap({1.5565, 0.8}, 0.2);
  REQUIRE(vertex);
  insert.hover(at_unit(vertex->place.x + 0.01, vertex->place.y));
  REQUIRE(insert.feedback().snap);
  CHECK(insert.feedback().snap->place == vertex->place);
  click(insert, at_unit(vertex->place.x + 0.01, vertex->place.y));
  CHECK(document.position(SampleSlot(5)) == vertex->place);
  bench.editor.undo();
  bench.settings.grid = true;

  // What is moved is no target itself, and what moves with it keeps its place beside it.
  bench.settings.samples = true;
  SelectTool select(bench.context);
  bench.editor.selection().add(SampleSlot(3));
  bench.editor.selection().add(SampleSlot(4));
  select.hover(at_unit(5.0, -1.5));
  select.press(at_unit(5.0, -1.5));
  select.drag(at_unit(4.0, -1.0));
  select.drag(at_unit(3.07, 0.0));
  REQUIRE(select.feedback().snap);
  CHECK(select.feedback().snap->name == "sample");
  select.release(at_unit(3.07, 0.0));
  CHECK(document.position(SampleSlot(3)) == Vec2{3.1, 0.02});
  CHECK(document.position(SampleSlot(4)).x == Approx(3.1 + 1.04));
  CHECK_FALSE(select.feedback().snap);

  BallTool ball(bench.context);
  ball.hover(at_unit(-2.02, -3.03));
  ball.press(at_unit(-2.02, -3.03));
  ball.drag(at_unit(-1.0, -1.0));
  ball.drag(at_unit(0.0, 0.0));
  ball.release(at_unit(0.0, 0.0));
  CHECK(document.disk(BallSlot(1)).center == Vec2{-2.0, -3.0});
  CHECK(document.disk(BallSlot(1)).radius == distance({-2.0, -3.0}, {0.013, 0.017}));
}

TEST_CASE("where nothing else is near, coordinates have as few digits as pixels need") {
  SnapBench bench;
  CHECK_FALSE(bench.snap({2.2313, 1.1987}));
  bench.settings.pixels = true;
  const auto pixel = bench.snap({2.2313, 1.1987});
  REQUIRE(pixel);
  CHECK(pixel->name == "pixel");
  CHECK(pixel->place == Vec2{2.23, 1.2});
  CHECK(bench.snap({3.05, 0.03})->name == "sample");
  CHECK(bench.snap({2.51, 1.49})->name == "grid");
  bench.settings.grid = false;
  CHECK(bench.snap({2.514, 1.488})->place == Vec2{2.51, 1.49});
}

TEST_CASE("the vertex that is found is the nearest of all empty circles through three sites") {
  Rng rng(9);
  int found = 0;
  for (int round = 0; round < 400; ++round) {
    const Vec2 off = round % 4 == 3 ? Vec2{1e6, -3e5} : Vec2{};
    std::vector<Vec2> sites;
    const std::size_t count = 3 + rng.below(25);
    for (std::size_t i = 0; i < count; ++i)
      sites.push_back(off + Vec2{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)});
    if (round % 5 == 4) sites.back() = sites.front();
    const Vec2 p = off + Vec2{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    const double reach = rng.uniform(0.05, 0.6);
    double nearest = reach;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j)
        for (std::size_t k = j + 1; k < count; ++k) {
          const Circle circle = circumcircle(sites[i], sites[j], sites[k]);
          const auto is_inside = [&](Vec2 q) { return distance(q, circle.center) < (1.0 - 1e-9) * circle.radius; };
          if (std::ranges::none_of(sites, is_inside)) nearest = std::min(nearest, distance(p, circle.center));
        }
    const auto vertex = vertex_near(sites, p, reach);
    CAPTURE(round, count, reach, nearest);
    REQUIRE(vertex.has_value() == (nearest < reach));
    if (!vertex) continue;
    ++found;
    CHECK(distance(p, vertex->at) == nearest);
    CHECK(std::ranges::is_sorted(vertex->corners));
  }
  CHECK(found > 100);
  CHECK_FALSE(vertex_near({}, {}, 1.0));
}

TEST_CASE("vertices are snapped to where hundreds of samples are as near as those that make them") {
  SnapBench bench;
  std::vector<Vec2> circle;
  for (int i = 0; i < 1000; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 1000.0;
    circle.push_back({100.0 + 3.0 * std::cos(t), 1.5 * std::sin(t)});
  }
  bench.grid = 0.0;
  REQUIRE(bench.editor.insert(circle, "Insert"));
  // The medial axis of this ellipse ends at the centre of curvature of its right end, (100 + 3 - 0.75, 0).
  const auto snap = bench.snap({102.25, 0.02}, 0.1);
  REQUIRE(snap);
  CHECK(snap->name == "Voronoi vertex");
  CHECK(distance(snap->place, {102.25, 0.0}) < 0.1);
}
