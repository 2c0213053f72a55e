// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "app/canvas/tools/brush_tool.h"

using namespace mes;

namespace {

constexpr int kSamples = 80;

struct BrushBench {
  Editor editor{[](auto) {}};
  AnnotationEditor annotations{editor};
  double spacing = 12.0;
  BrushSettings brush{.radius_px = 30.0};
  ToolContext context{.editor = editor,
                      .annotations = annotations,
                      .spray_spacing_px = spacing,
                      .report = [](const Error& error) { FAIL(error.message()); },
                      .brush = &brush};
  BrushTool tool{context};

  BrushBench() {
    SampleData data;
    for (int i = 0; i < kSamples; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSamples;
      data.positions.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
    }
    data.balls = {{{100, 0}, 5}, {{0, 0}, 3}};
    REQUIRE(editor.load(data));
  }
  /// A pixel is a unit.
  static Pointer at(Vec2 p) { return {.px = p, .world = p, .units_per_px = 1.0}; }
  void stroke(std::initializer_list<Vec2> way) {
    tool.press(at(*way.begin()));
    for (const Vec2 p : way) tool.drag(at(p));
    tool.release(at(*(way.end() - 1)));
  }
  void around(int times) {
    tool.press(at({100, 0}));
    for (int i = 1; i <= 40 * times; ++i)
      tool.drag(at({100 * std::cos(2 * std::numbers::pi * i / 40), 100 * std::sin(2 * std::numbers::pi * i / 40)}));
    tool.release(at({100, 0}));
  }
  std::vector<Vec2> places() const {
    std::vector<Vec2> out;
    for (const SampleSlot slot : editor.document().slots_in_input_order())
      out.push_back(editor.document().position(slot));
    return out;
  }
};

}  // namespace

TEST_CASE("the eraser takes what the ring passes over, samples and balls, and one undo brings it back") {
  BrushBench bench;
  const std::vector<Vec2> before = bench.places();
  // The system reports two places of the way through the middle.
  bench.stroke({{154, 0}, {60, 0}});
  for (const Vec2 p : before) {
    const bool is_left = std::ranges::count(bench.places(), p) != 0;
    const double away = std::hypot(p.x - std::clamp(p.x, 60.0, 154.0), p.y);
    // A ring drawn every quarter of the radius leaves out less than one part in a hundred at the rim.
    if (away > 30.0) CHECK(is_left);
    if (away < 29.7) CHECK_FALSE(is_left);
  }
  CHECK(bench.editor.document().ball_count() == 1);
  CHECK(bench.editor.undo_name() == "Erase");
  bench.editor.undo();
  CHECK(bench.places() == before);
  CHECK(bench.editor.document().ball_count() == 2);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("thinning takes every other sample once, however often the brush passes") {
  for (const int times : {1, 3}) {
    BrushBench bench;
    bench.brush.mode = BrushMode::thin;
    bench.around(times);
    const std::size_t left = bench.editor.document().sample_count();
    CHECK(left >= kSamples / 2);
    CHECK(left <= kSamples / 2 + 2);
    // No two neighbours went.
    std::vector<Vec2> places = bench.places();
    double widest = 0.0;
    for (const Vec2 p : places) {
      double nearest = 1e9;
      for (const Vec2 q : places)
        if (p != q) nearest = std::min(nearest, distance(p, q));
      widest = std::max(widest, nearest);
    }
    CHECK(widest < 2.01 * 2 * 100 * std::sin(std::numbers::pi / kSamples));
    bench.editor.undo();
    CHECK(bench.editor.document().sample_count() == kSamples);
    CHECK_FALSE(bench.editor.can_undo());
  }
  // Another stroke takes half of what is left.
  BrushBench bench;
  bench.brush.mode = BrushMode::thin;
  bench.around(1);
  const std::size_t first = bench.editor.document().sample_count();
  bench.around(1);
  CHECK(bench.editor.document().sample_count() < first * 3 / 4);
}

TEST_CASE("a small loop is left as it is, and too many samples are said to be too many, once a stroke") {
  BrushBench bench;
  REQUIRE(bench.editor.load({.positions = {{-10, 0}, {0, -10}, {10, 0}, {0, 10}}}));
  bench.brush.mode = BrushMode::thin;
  bench.stroke({{0, 0}, {3, 0}});
  CHECK(bench.editor.document().sample_count() == 4);
  SampleData many;
  for (std::uint32_t i = 0; i < BrushStroke::kMostSamples + 10; ++i)
    many.positions.push_back({1e-3 * static_cast<double>(i), 0.0});
  REQUIRE(bench.editor.load(many));
  std::vector<std::string> said;
  bench.context.report = [&said](const Error& error) { said.push_back(error.text); };
  bench.stroke({{0, 0}, {50, 0}, {100, 0}});
  REQUIRE(said.size() == 1);
  CHECK_THAT(said[0], Catch::Contains("zoom in"));
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("refining puts one sample between neighbours, on the curve") {
  for (const int times : {1, 3}) {
    BrushBench bench;
    bench.brush.mode = BrushMode::refine;
    bench.around(times);
    CHECK(bench.editor.document().sample_count() == 2 * kSamples);
    // The sagitta of an interval is 0.077.
    for (const Vec2 p : bench.places()) CHECK(std::abs(length(p) - 100) < 1e-3);
    bench.editor.undo();
    CHECK(bench.editor.document().sample_count() == kSamples);
    CHECK_FALSE(bench.editor.can_undo());
  }
}

TEST_CASE("refining reaches neighbours that are farther apart than the brush is wide") {
  // Samples are 7.9 apart.
  for (const double radius : {6.0, 3.0}) {
    BrushBench bench;
    bench.brush.mode = BrushMode::refine;
    bench.brush.radius_px = radius;
    bench.around(1);
    CHECK(bench.editor.document().sample_count() == 2 * kSamples);
    for (const Vec2 p : bench.places()) CHECK(std::abs(length(p) - 100) < 1e-3);
  }
  // Beside the curve, and across the middle of the shape, it meets nothing.
  BrushBench bench;
  bench.brush.mode = BrushMode::refine;
  bench.brush.radius_px = 3.0;
  bench.stroke({{-90, 0}, {90, 0}});
  CHECK(bench.editor.document().sample_count() == kSamples);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("samples that refine a contour are on it, between their neighbours, and one undo takes them off") {
  for (const bool is_closed : {true, false}) {
    BrushBench bench;
    SampleData data = data_of(bench.editor.document());
    SampleData::Contour& contour = data.contours.emplace_back();
    contour.closed = is_closed;
    for (std::uint32_t i = 0; i < kSamples; ++i) contour.points.push_back(i);
    REQUIRE(bench.editor.load(data));
    // A sample that is gone leaves its neighbours on the contour next to each other, but not on the crust.
    const std::array<SampleId, 1> gone{
        bench.editor.document().id(bench.editor.document().slots_in_input_order()[20])};
    REQUIRE(bench.editor.remove(gone, "Remove"));
    const SampleData before = data_of(bench.editor.document());
    bench.brush.mode = BrushMode::refine;
    bench.around(1);
    const SampleData after = data_of(bench.editor.document());
    REQUIRE(after.contours.size() == 1);
    CHECK(after.contours[0].closed == is_closed);
    // Each is there once, and follows the one before along the circle.
    const std::vector<std::uint32_t>& points = after.contours[0].points;
    const std::size_t intervals = kSamples - 1 - (is_closed ? 0 : 1);
    REQUIRE(points.size() == kSamples - 1 + intervals);
    CHECK(after.positions.size() == 2 * (kSamples - 1));  // the crust is closed in both
    double way = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec2 a = after.positions[points[i - 1]];
      const Vec2 b = after.positions[points[i]];
      CHECK(std::atan2(cross(a, b), dot(a, b)) > 0.0);
      way += distance(a, b);
    }
    CHECK(way < 2 * std::numbers::pi * 100);
    bench.editor.undo();
    CHECK(data_of(bench.editor.document()).contours == before.contours);
    CHECK(bench.editor.document().sample_count() == before.positions.size());
    bench.editor.redo();
    CHECK(data_of(bench.editor.document()).contours == after.contours);
  }
}

TEST_CASE("a brush on nothing, on one sample and on two does no harm, and a cancelled stroke leaves nothing") {
  BrushBench bench;
  for (const BrushMode mode : {BrushMode::erase, BrushMode::thin, BrushMode::refine}) {
    bench.brush.mode = mode;
    bench.stroke({{500, 500}, {520, 500}});
    CHECK_FALSE(bench.editor.can_undo());
    bench.tool.press(BrushBench::at({100, 0}));
    bench.tool.drag(BrushBench::at({80, 40}));
    bench.tool.cancel();
    CHECK(bench.editor.document().sample_count() == kSamples);
    CHECK_FALSE(bench.editor.can_undo());
  }
  REQUIRE(bench.editor.load({.positions = {{0, 0}}}));
  for (const BrushMode mode : {BrushMode::thin, BrushMode::refine}) {
    bench.brush.mode = mode;
    bench.stroke({{0, 0}, {1, 1}});
  }
  CHECK(bench.editor.document().sample_count() == 1);
  REQUIRE(bench.editor.load({.positions = {{0, 0}, {10, 0}, {10, 0}}}));
  bench.brush.mode = BrushMode::thin;
  bench.stroke({{0, 0}, {1, 1}});
  CHECK(bench.editor.document().sample_count() == 3);
  bench.brush.mode = BrushMode::refine;
  bench.stroke({{5, 0}, {6, 0}});
  CHECK(bench.places().back() == Vec2{5, 0});
  CHECK(bench.editor.document().sample_count() == 4);
}
