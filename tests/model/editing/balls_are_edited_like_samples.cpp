// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <random>

#include "app/canvas/canvas.h"
#include "app/canvas/tools/ball_tool.h"
#include "app/canvas/tools/select_tool.h"
#include "app/editing/places/ball_pick.h"
#include "tests/model/editing/tool_hand.h"

using namespace mes;
using mes::test::at_pixel;
using mes::test::click;
using mes::test::drag;
using mes::test::kCtrlShift;
using mes::test::kShift;

namespace {

struct BallBench {
  Editor editor{{}};
  double spacing = 10.0;
  int refused = 0;
  AnnotationEditor annotations{editor};
  ToolContext context{editor, annotations, spacing, [this](const Error&) { ++refused; }};

  // Balls with 40 pixels of radius around the pixels (100, 100), (300, 100) and (500, 100), and a sample between each
  // two.
  BallBench() {
    SampleData data;
    for (const double x : {100.0, 300.0, 500.0}) data.balls.push_back({at_pixel(x, 100).world, 20.0});
    for (const double x : {200.0, 400.0}) data.positions.push_back(at_pixel(x, 100).world);
    REQUIRE(editor.load(data));
  }
  const Document& document() const { return editor.document(); }
  std::vector<SampleSlot> samples() const { return editor.selection().slots(); }
  std::vector<BallSlot> balls() const { return editor.selection().ball_slots(); }
};

// Rows by their numbers.
template <class Row>
std::vector<Row> rows(std::initializer_list<std::size_t> numbers) {
  std::vector<Row> out;
  for (const std::size_t number : numbers) out.emplace_back(number);
  return out;
}

}  // namespace

TEST_CASE("the ball tool draws a ball from its centre to the pointer, in one step") {
  BallBench bench;
  BallTool tool(bench.context);
  tool.hover(at_pixel(10, 300));
  tool.press(at_pixel(10, 300));
  tool.drag(at_pixel(12, 300));
  CHECK(bench.document().ball_count() == 3);
  tool.drag(at_pixel(30, 300));
  REQUIRE(bench.document().ball_count() == 4);
  CHECK(bench.document().disk(BallSlot(3)) == Disk{at_pixel(10, 300).world, 10.0});
  REQUIRE(tool.feedback().ball);
  CHECK(*tool.feedback().ball == Disk{at_pixel(10, 300).world, 10.0});
  tool.drag(at_pixel(40, 340));
  tool.release(at_pixel(40, 340));
  CHECK(bench.document().disk(BallSlot(3)) == Disk{at_pixel(10, 300).world, 25.0});
  CHECK_FALSE(tool.feedback().ball);
  CHECK(bench.editor.undo_name() == "Insert ball");
  bench.editor.undo();
  CHECK(bench.document().ball_count() == 3);
  CHECK_FALSE(bench.editor.can_undo());
  bench.editor.redo();
  CHECK(bench.document().disk(BallSlot(3)).radius == 25.0);
}

TEST_CASE("a click of the ball tool makes nothing, nor does a drag that comes back or is cancelled") {
  BallBench bench;
  const auto digest = bench.document().digest();
  BallTool tool(bench.context);
  click(tool, at_pixel(10, 300));
  CHECK_FALSE(bench.editor.in_gesture());
  tool.press(at_pixel(10, 300));
  tool.drag(at_pixel(60, 300));
  tool.release(at_pixel(11, 301));
  CHECK(bench.document().digest() == digest);
  tool.press(at_pixel(10, 300));
  tool.drag(at_pixel(60, 300));
  CHECK(bench.document().ball_count() == 4);
  tool.cancel();
  tool.release(at_pixel(60, 300));
  CHECK(bench.document().digest() == digest);
  CHECK_FALSE(bench.editor.can_undo());
  CHECK_FALSE(tool.is_active());
  CHECK(bench.refused == 0);
}

TEST_CASE("a ball that no double can hold is refused once, and nothing is left open") {
  BallBench bench;
  BallTool tool(bench.context);
  const double most = std::numeric_limits<double>::max();
  tool.press({{0, 0}, {-most, 0}, 1.0, {}});
  tool.drag({{100, 0}, {most, 0}, 1.0, {}});
  tool.drag({{110, 0}, {most, 0}, 1.0, {}});
  tool.release({{110, 0}, {most, 0}, 1.0, {}});
  CHECK(bench.refused == 1);
  CHECK(bench.document().ball_count() == 3);
  CHECK_FALSE(bench.editor.in_gesture());
}

TEST_CASE("a ball is taken at its centre and at its circle, but not in between") {
  BallBench bench;
  SelectTool tool(bench.context);
  click(tool, at_pixel(104, 97));
  CHECK(bench.balls() == rows<BallSlot>({0}));
  click(tool, at_pixel(120, 100));
  CHECK(bench.balls().empty());
  click(tool, at_pixel(300, 143));
  CHECK(bench.balls() == rows<BallSlot>({1}));
  click(tool, at_pixel(457, 100, kShift));
  CHECK(bench.balls() == rows<BallSlot>({1, 2}));
  click(tool, at_pixel(200, 100, kShift));
  CHECK(bench.samples() == rows<SampleSlot>({0}));
  CHECK(bench.editor.selection().size() == 3);
  click(tool, at_pixel(300, 60, kCtrlShift));
  CHECK(bench.balls() == rows<BallSlot>({2}));
  click(tool, at_pixel(200, 100));
  CHECK(bench.samples() == rows<SampleSlot>({0}));
  CHECK(bench.balls().empty());
}

TEST_CASE("of a sample and a ball the nearer one is taken, and the sample when both are as near") {
  BallBench bench;
  SelectTool tool(bench.context);
  // On the circle of the first ball.
  REQUIRE(bench.editor.insert(std::vector{at_pixel(140, 100).world}, "sample"));
  click(tool, at_pixel(143, 100));
  CHECK(bench.samples() == rows<SampleSlot>({2}));
  CHECK(bench.balls().empty());
  // Six pixels along the circle from the sample, right on it.
  const double t = 6.0 / 40.0;
  click(tool, at_pixel(100 + 40 * std::cos(t), 100 + 40 * std::sin(t)));
  CHECK(bench.samples().empty());
  CHECK(bench.balls() == rows<BallSlot>({0}));
}

TEST_CASE("a box selects the balls whose centre it holds") {
  BallBench bench;
  SelectTool tool(bench.context);
  drag(tool, at_pixel(150, 60), at_pixel(320, 120));
  CHECK(bench.balls() == rows<BallSlot>({1}));
  CHECK(bench.samples() == rows<SampleSlot>({0}));
  drag(tool, at_pixel(400, 0, kShift), at_pixel(600, 200, kShift));
  CHECK(bench.balls() == rows<BallSlot>({1, 2}));
  drag(tool, at_pixel(290, 80, kCtrlShift), at_pixel(600, 200, kCtrlShift));
  CHECK(bench.balls().empty());
  CHECK(bench.samples() == rows<SampleSlot>({0}));
}

TEST_CASE("dragging moves the whole selection, samples and balls, in one step") {
  BallBench bench;
  const auto digest = bench.document().digest();
  SelectTool tool(bench.context);
  bench.editor.selection().add(SampleSlot(1));
  bench.editor.selection().add_ball(BallSlot(0));
  drag(tool, at_pixel(60, 100), at_pixel(90, 140));
  CHECK(bench.document().disk(BallSlot(0)) == Disk{at_pixel(130, 140).world, 20.0});
  CHECK(bench.document().disk(BallSlot(1)) == Disk{at_pixel(300, 100).world, 20.0});
  CHECK(bench.document().position(SampleSlot(1)) == at_pixel(430, 140).world);
  CHECK(bench.document().position(SampleSlot(0)) == at_pixel(200, 100).world);
  CHECK(bench.editor.undo_name() == "Move sample and ball");
  bench.editor.undo();
  CHECK(bench.document().digest() == digest);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("the wheel on a selected ball changes its radius, one step until the pointer moves on") {
  BallBench bench;
  SelectTool tool(bench.context);
  tool.hover(at_pixel(100, 140));
  CHECK_FALSE(tool.wheel(at_pixel(100, 140), 1));  // not selected: the view zooms
  click(tool, at_pixel(100, 140));
  for (int i = 0; i < 5; ++i) CHECK(tool.wheel(at_pixel(100, 140), 1));
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(20.0 * std::pow(1.1, 5)));
  CHECK(bench.document().disk(BallSlot(0)).center == at_pixel(100, 100).world);
  CHECK(bench.document().disk(BallSlot(1)).radius == 20.0);
  tool.hover(at_pixel(100, 141));
  CHECK(tool.wheel(at_pixel(100, 141), -5));
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(20.0));
  CHECK(tool.wheel(at_pixel(100, 141), -1));
  CHECK(bench.editor.undo_name() == "Change radius");
  bench.editor.undo();
  CHECK(bench.document().disk(BallSlot(0)).radius == 20.0);
  CHECK_FALSE(bench.editor.can_undo());

  // The pointer moved on and came back: a step of its own.
  CHECK(tool.wheel(at_pixel(100, 140), 1));
  tool.hover(at_pixel(100, 200));
  CHECK_FALSE(tool.wheel(at_pixel(100, 200), 1));
  tool.hover(at_pixel(100, 100));
  CHECK(tool.wheel(at_pixel(100, 100), 1));
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(20.0 * 1.1 * 1.1));
  bench.editor.undo();
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(20.0 * 1.1));
  bench.editor.undo();
  CHECK(bench.document().disk(BallSlot(0)).radius == 20.0);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("the wheel changes all selected balls, a step between two turns parts them, and zero grows") {
  BallBench bench;
  REQUIRE(bench.editor.insert_balls(std::vector{Disk{at_pixel(100, 300).world, 0.0}}, "ball"));
  SelectTool tool(bench.context);
  bench.editor.selection().select_all(bench.document());
  CHECK(tool.wheel(at_pixel(100, 300), 1));
  CHECK(bench.document().disk(BallSlot(3)).radius == Approx(0.5 * 1.1));
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(22.0));
  CHECK(bench.editor.undo_name() == "Change radii");
  REQUIRE(bench.editor.nudge_selection({1, 0}));
  CHECK(tool.wheel(at_pixel(100, 300), 1));
  bench.editor.undo();
  CHECK(bench.editor.undo_name() == "Nudge");
  // After an undo the turning begins a new step, and what was undone is gone.
  CHECK(tool.wheel(at_pixel(100, 300), 1));
  CHECK_FALSE(bench.editor.can_redo());
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(24.2));
  // Deleted balls take no turns.
  REQUIRE(bench.editor.remove_selection());
  CHECK_FALSE(tool.wheel(at_pixel(100, 300), 1));
}

TEST_CASE("the canvas zooms unless the wheel is on a selected ball") {
  BallBench bench;
  Canvas canvas(bench.context);
  canvas.view().set_viewport(800, 600);
  canvas.view().fit({{0, -300}, {400, 0}}, 0.0, true);
  const Vec2 on_circle = canvas.view().camera().to_screen({70.0, -50.0});
  canvas.move(on_circle, {});
  const auto scale = [&] {
    canvas.advance(10.0);
    return canvas.view().camera().units_per_pixel();
  };
  const double before = scale();
  canvas.press(PointerButton::left, on_circle, {});
  canvas.release(PointerButton::left, on_circle, {});
  REQUIRE(bench.balls() == rows<BallSlot>({0}));
  canvas.wheel(on_circle, 1);
  CHECK(scale() == before);
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(22.0));
  canvas.choose_tool(ToolId::ball);
  canvas.wheel(on_circle, 1);
  CHECK(scale() < before);
  CHECK(bench.document().disk(BallSlot(0)).radius == Approx(22.0));
}

TEST_CASE("deleting, nudging, selecting all and inverting take balls and samples alike") {
  BallBench bench;
  Editor& editor = bench.editor;
  editor.selection().select_all(bench.document());
  CHECK(editor.selection().sample_count() == 2);
  CHECK(editor.selection().ball_count() == 3);
  REQUIRE(editor.nudge_selection({1, 2}));
  CHECK(bench.document().disk(BallSlot(1)) == Disk{at_pixel(300, 100).world + Vec2{1, 2}, 20.0});
  CHECK(bench.document().position(SampleSlot(0)) == at_pixel(200, 100).world + Vec2{1, 2});
  editor.undo();
  CHECK(bench.document().disk(BallSlot(1)).center == at_pixel(300, 100).world);
  CHECK(bench.document().position(SampleSlot(0)) == at_pixel(200, 100).world);
  editor.selection().remove_ball(BallSlot(1));
  editor.selection().remove(SampleSlot(0));
  editor.selection().invert(bench.document());
  CHECK(bench.balls() == rows<BallSlot>({1}));
  CHECK(bench.samples() == rows<SampleSlot>({0}));
  REQUIRE(editor.remove_selection());
  CHECK(editor.undo_name() == "Delete sample and ball");
  CHECK(bench.document().ball_count() == 2);
  CHECK(bench.document().sample_count() == 1);
  CHECK(editor.selection().is_empty());
  editor.undo();
  CHECK(bench.document().ball_count() == 3);
  CHECK(bench.document().sample_count() == 2);
  CHECK_FALSE(editor.can_undo());
  editor.selection().select_all(bench.document());
  REQUIRE(editor.load({}));
  CHECK(editor.selection().is_empty());
}

TEST_CASE("what is selected is called by its name") {
  CHECK(counted(0, 0) == "nothing");
  CHECK(counted(1551, 1000) == "1,551 samples and 1,000 balls");
  CHECK(counted(999, 1234567) == "999 samples and 1,234,567 balls");
  CHECK(counted(1, 0) == "1 sample");
  CHECK(counted(0, 2) == "2 balls");
  CHECK(counted(3, 1) == "3 samples and 1 ball");
}

TEST_CASE("picking balls agrees with looking at every ball from every place") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-10, 10);
  Document document;
  std::vector<Disk> disks(60);
  for (Disk& disk : disks) disk = {{coordinate(random), coordinate(random)}, std::abs(coordinate(random)) / 3};
  disks.push_back(disks.back());
  document.apply(insert_balls(document, disks).value());
  document.apply(remove_balls(document, std::vector{document.ball_id(BallSlot(7))}).value());
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p{coordinate(random), coordinate(random)};
    const BallPick pick = nearest_ball(document, p, 0.3);
    double best = 0.3;
    for (std::size_t slot = 0; slot < disks.size(); ++slot) {
      const double d = distance(disks[slot].center, p);
      if (slot != 7) best = std::min({best, d, std::abs(d - disks[slot].radius)});
    }
    if (pick.slot == kNoSlot) {
      CHECK(best == 0.3);
      continue;
    }
    CHECK(pick.slot != BallSlot(7));
    CHECK(pick.slot != BallSlot(59));  // lies under its double
    CHECK(pick.distance == best);
  }
  CHECK(nearest_ball(document, {std::numeric_limits<double>::quiet_NaN(), 0}, 1.0).slot == kNoSlot);
  CHECK(nearest_ball(Document(), {0, 0}, 1e300).slot == kNoSlot);
}
