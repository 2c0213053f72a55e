// SPDX-License-Identifier: GPL-3.0-or-later
// The range of coordinates, in the window's model: tools, nudges, radii, evolutions, undo.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/canvas/tools/ball_tool.h"
#include "app/canvas/tools/insert_tool.h"
#include "app/canvas/tools/spray_tool.h"

using namespace mes;

namespace {

const double kMost = std::nextafter(0x1p500, 0.0);

struct RangeBench {
  Editor editor{{}};
  double spacing = 10.0;
  std::vector<std::string> refused;
  AnnotationEditor annotations{editor};
  ToolContext context{editor, annotations, spacing, [this](const Error& error) { refused.push_back(error.text); }};

  explicit RangeBench(const SampleData& data = {{{1.0, 2.0}, {-3.0, 0.0}}, {}, {{{1.0, 1.0}, 0.5}}}) {
    REQUIRE(editor.load(data));
  }
  const Document& document() const { return editor.document(); }
};

// Pixels do not matter to these tools.
Pointer at_point(Vec2 world) {
  return {{0, 0}, world, 1e-3, {}};
}

}  // namespace

// Beside nothing but zeros no number is too small; a constant expression does not overflow.
static_assert(without_traces(1.0, Magnitudes{}.most) == 1.0);
static_assert(without_traces(0x1p-120, 0) == 0.0);

TEST_CASE("a click that is nothing beside the drawing is a click on the axis") {
  RangeBench bench;
  InsertTool tool(bench.context);
  tool.press(at_point({1e-40, 2.0}));
  tool.drag(at_point({-1e-31, 0x1p-99}));
  tool.release(at_point({-1e-31, 0x1p-99}));
  CHECK(bench.refused.empty());
  CHECK(bench.document().position(SampleSlot(2)) == Vec2{0.0, 0x1p-99});
  CHECK_FALSE(std::signbit(bench.document().position(SampleSlot(2)).x));
  SprayTool spray(bench.context);
  spray.press(at_point({3.0, -1e-300}));
  spray.release(at_point({3.0, -1e-300}));
  CHECK(bench.document().position(SampleSlot(3)) == Vec2{3.0, 0.0});
  CHECK(bench.refused.empty());
}

TEST_CASE("among small things small clicks are what they are, and those below the range are zero") {
  RangeBench bench(SampleData{.positions = {{1e-120, 0.0}}});
  InsertTool tool(bench.context);
  tool.press(at_point({1e-140, 3e-121}));
  tool.release(at_point({1e-140, 3e-121}));
  CHECK(bench.document().position(SampleSlot(1)) == Vec2{1e-140, 3e-121});
  tool.press(at_point({5e-324, 1e-130}));
  tool.release(at_point({5e-324, 1e-130}));
  CHECK(bench.document().position(SampleSlot(2)) == Vec2{0.0, 1e-130});
  CHECK(bench.refused.empty());
}

TEST_CASE("what is too large is refused in one line, and nothing is lost") {
  RangeBench bench;
  const std::uint64_t before = bench.document().digest();
  InsertTool insert(bench.context);
  insert.press(at_point({1e40, 0.0}));
  insert.release(at_point({1e40, 0.0}));
  REQUIRE(bench.refused.size() == 1);
  CHECK(bench.refused[0].starts_with("1e+40 is too large beside numbers of about 0.5: the largest may be 2^100"));
  SprayTool spray(bench.context);
  spray.press(at_point({0.0, 1e200}));
  spray.release(at_point({0.0, 1e200}));
  REQUIRE(bench.refused.size() == 2);
  CHECK(bench.refused[1].starts_with("1e+200 is too large: coordinates and radii are 0, or"));
  CHECK(bench.document().digest() == before);
  CHECK_FALSE(bench.editor.in_gesture());
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("a radius too small beside the drawing is refused, not made zero") {
  RangeBench bench;
  const std::uint64_t before = bench.document().digest();
  CHECK_FALSE(bench.editor.insert_balls(std::vector<Disk>{{{1, 1}, 1e-40}}, "Insert ball"));
  bench.editor.selection().add_ball(BallSlot(0));
  CHECK_FALSE(bench.editor.scale_selected_balls(1e-35, 1.0, false));
  CHECK_FALSE(bench.editor.scale_selected_balls(1e200, 1.0, false));
  CHECK(bench.document().digest() == before);
  CHECK(bench.editor.scale_selected_balls(1e20, 1.0, false));
}

TEST_CASE("a drag of everything to another size is judged as a whole") {
  RangeBench bench;
  const Document& document = bench.document();
  const std::vector<std::pair<SampleId, Vec2>> samples{{document.id(SampleSlot(0)), {1e60, 0.0}},
                                                       {document.id(SampleSlot(1)), {0.0, 1e60}}};
  const std::vector<std::pair<BallId, Disk>> balls{{document.ball_id(BallSlot(0)), {{1e60, 1e60}, 1e40}}};
  CHECK_FALSE(bench.editor.move(samples, "Move"));
  REQUIRE(bench.editor.move(samples, balls, "Move"));
  CHECK(document.magnitudes().most == exponent_of(1e60));
  CHECK(document.magnitudes().least == exponent_of(1e40));
  // What was accepted comes back, whatever is accepted meanwhile.
  REQUIRE(bench.editor.insert(std::vector<Vec2>{{1e68, 1e50}}, "Insert"));
  const std::uint64_t large = document.digest();
  bench.editor.undo();
  bench.editor.undo();
  CHECK(document.position(SampleSlot(0)) == Vec2{1.0, 2.0});
  CHECK(document.magnitudes().least == exponent_of(0.5));
  bench.editor.redo();
  bench.editor.redo();
  CHECK(document.digest() == large);
}

TEST_CASE("taking the smallest away makes room for the largest") {
  RangeBench bench(SampleData{.positions = {{1.0, 0x1p-100}, {1.5, 0.0}, {0.0, 0x1p-100}}});
  const std::vector<Vec2> large{{4.0, 0.0}};
  const std::vector<Vec2> larger{{0x1p3, 0x1p3}};
  CHECK_FALSE(bench.editor.insert(large, "Insert"));
  REQUIRE(bench.editor.remove(std::vector{bench.document().id(SampleSlot(0))}, "Delete"));
  CHECK_FALSE(bench.editor.insert(large, "Insert"));
  REQUIRE(bench.editor.remove(std::vector{bench.document().id(SampleSlot(2))}, "Delete"));
  CHECK(bench.editor.insert(larger, "Insert"));
}

TEST_CASE("a nudge onto an axis ends on the axis, a nudge out of range where it began") {
  RangeBench bench(SampleData{.positions = {{0.3, 1.0}, {2.0, 5.0}}});
  bench.editor.selection().add(SampleSlot(0));
  for (int i = 0; i < 3; ++i) REQUIRE(bench.editor.nudge_selection({-0.1, 0.0}));
  // What rounding leaves of 0.3 - 0.1 - 0.1 - 0.1 is a number among others.
  const double rest = bench.document().position(SampleSlot(0)).x;
  CHECK(rest != 0.0);
  CHECK(std::abs(rest) < 1e-15);
  REQUIRE(bench.editor.nudge_selection({-rest, 0.0}));
  CHECK(bench.document().position(SampleSlot(0)).x == 0.0);
  REQUIRE(bench.editor.nudge_selection({1e-45, 0.0}));
  CHECK(bench.document().position(SampleSlot(0)).x == 0.0);
  const std::uint64_t before = bench.document().digest();
  CHECK_FALSE(bench.editor.nudge_selection({kMost, 0.0}));
  CHECK(bench.document().digest() == before);
}

TEST_CASE("a state of an evolution out of range is refused, and the state before stays") {
  RangeBench bench(SampleData{.positions = {{1.0, 0.0}, {2.0, 5.0}}});
  REQUIRE(bench.editor.evolve(std::vector<Vec2>{{3.0, 0.0}, {2.0, 5.0}}, {}, "Smooth: step 1"));
  const std::uint64_t before = bench.document().digest();
  CHECK_FALSE(bench.editor.evolve(std::vector<Vec2>{{1e-40, 0.0}, {2.0, 5.0}}, {}, "Smooth: step 2"));
  CHECK_FALSE(bench.editor.evolve(std::vector<Vec2>{{1e200, 0.0}, {2.0, 5.0}}, {}, "Smooth: step 2"));
  CHECK(bench.document().digest() == before);
  bench.editor.undo();
  CHECK(bench.document().position(SampleSlot(0)) == Vec2{1.0, 0.0});
}

TEST_CASE("a timeline of edits in range replays, one of edits out of range does not") {
  RangeBench bench;
  CHECK_FALSE(bench.editor.perform(TimelineEdit{.name = "Insert", .inserted = {{1e-40, 0.0}}}));
  CHECK(bench.editor.timeline().entries().empty());
  DocumentReplay replay;
  REQUIRE(replay.begin({.positions = {{1.0, 0.0}}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.name = "Insert", .inserted = {{1e-40, 0.0}}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.name = "Insert", .inserted = {{std::nextafter(0x1p-500, 0.0), 0.0}}}));
  CHECK(replay.document().sample_count() == 1);
}
