// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "app/canvas/tools/insert_tool.h"
#include "app/canvas/tools/select_tool.h"
#include "app/canvas/tools/spray_tool.h"
#include "tests/model/editing/tool_hand.h"

using namespace mes;
using mes::test::at_pixel;
using mes::test::click;
using mes::test::drag;
using mes::test::kCtrlShift;
using mes::test::kShift;

namespace {

struct ToolBench {
  Editor editor{{}};
  double spacing = 10.0;
  int refused = 0;
  AnnotationEditor annotations{editor};
  ToolContext context{editor, annotations, spacing, [this](const Error&) { ++refused; }};

  // Samples in a row, 40 pixels apart, beginning at pixel (100, 100).
  ToolBench() {
    SampleData data;
    for (int i = 0; i < 5; ++i) data.positions.push_back(at_pixel(100.0 + 40.0 * i, 100).world);
    REQUIRE(editor.load(data));
  }
  std::vector<SampleSlot> selected() const { return editor.selection().slots(); }
};

}  // namespace

TEST_CASE("insert adds a sample where the button is let go, in one step") {
  ToolBench bench;
  InsertTool tool(bench.context);
  drag(tool, at_pixel(10, 20), at_pixel(30, 40));
  REQUIRE(bench.editor.document().sample_count() == 6);
  CHECK(bench.editor.document().position(SampleSlot(5)) == at_pixel(30, 40).world);
  bench.editor.undo();
  CHECK(bench.editor.document().sample_count() == 5);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("insert that is cancelled leaves nothing") {
  ToolBench bench;
  InsertTool tool(bench.context);
  tool.press(at_pixel(10, 20));
  tool.drag(at_pixel(20, 20));
  tool.cancel();
  tool.release(at_pixel(20, 20));
  CHECK(bench.editor.document().sample_count() == 5);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("spray spaces samples evenly, whatever the pointer reports") {
  for (const int reports : {1, 2, 7, 200}) {
    ToolBench bench;
    SprayTool tool(bench.context);
    tool.press(at_pixel(0, 0));
    for (int i = 1; i <= reports; ++i) tool.drag(at_pixel(205.0 * i / reports, 0));
    tool.release(at_pixel(205, 0));
    CAPTURE(reports);
    REQUIRE(bench.editor.document().sample_count() == 5 + 21);
    for (std::uint32_t i = 0; i < 21; ++i) {
      CHECK(bench.editor.document().position(SampleSlot(5 + i)).x == Approx(0.5 * 10.0 * i).margin(1e-9));
      CHECK(bench.editor.document().position(SampleSlot(5 + i)).y == 0.0);
    }
    bench.editor.undo();
    CHECK(bench.editor.document().sample_count() == 5);
    CHECK_FALSE(bench.editor.can_undo());
  }
}

TEST_CASE("a click selects, Shift adds, Ctrl+Shift removes, empty space deselects") {
  ToolBench bench;
  SelectTool tool(bench.context);
  click(tool, at_pixel(103, 102));
  CHECK(bench.selected() == std::vector{SampleSlot(0)});
  click(tool, at_pixel(140, 100));
  CHECK(bench.selected() == std::vector{SampleSlot(1)});
  click(tool, at_pixel(180, 100, kShift));
  CHECK(bench.selected() == std::vector{SampleSlot(1), SampleSlot(2)});
  click(tool, at_pixel(140, 100, kCtrlShift));
  CHECK(bench.selected() == std::vector{SampleSlot(2)});
  click(tool, at_pixel(300, 300, kShift));
  CHECK(bench.selected() == std::vector{SampleSlot(2)});
  click(tool, at_pixel(300, 300));
  CHECK(bench.selected().empty());
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("a click on one of several selected samples selects it alone") {
  ToolBench bench;
  SelectTool tool(bench.context);
  bench.editor.selection().select_all(bench.editor.document());
  click(tool, at_pixel(180, 100));
  CHECK(bench.selected() == std::vector{SampleSlot(2)});
}

TEST_CASE("a box selects, adds and removes") {
  ToolBench bench;
  SelectTool tool(bench.context);
  drag(tool, at_pixel(120, 80), at_pixel(200, 120));
  CHECK(bench.selected() == std::vector{SampleSlot(1), SampleSlot(2)});
  drag(tool, at_pixel(280, 120, kShift), at_pixel(240, 90, kShift));
  CHECK(bench.selected() == std::vector{SampleSlot(1), SampleSlot(2), SampleSlot(4)});
  drag(tool, at_pixel(170, 80, kCtrlShift), at_pixel(400, 120, kCtrlShift));
  CHECK(bench.selected() == std::vector{SampleSlot(1)});
}

TEST_CASE("a lasso that begins with Ctrl selects what it goes around, and adds with Shift") {
  ToolBench bench;
  SelectTool tool(bench.context);
  constexpr Modifiers kCtrl{.ctrl = true};
  const auto lasso = [&](const std::vector<Vec2>& corners, Modifiers at_end) {
    tool.hover(at_pixel(corners.front().x, corners.front().y, kCtrl));
    tool.press(at_pixel(corners.front().x, corners.front().y, kCtrl));
    for (const Vec2 p : corners) tool.drag(at_pixel(p.x, p.y, kCtrl));
    CHECK(tool.feedback().lasso.size() > 2);
    CHECK_FALSE(tool.feedback().box_px);
    tool.release(at_pixel(corners.back().x, corners.back().y, at_end));
    CHECK(tool.feedback().lasso.empty());
  };
  // Around the first and the third: below the second, whose box the lasso covers.
  lasso({{80, 80}, {120, 80}, {120, 120}, {160, 120}, {160, 80}, {200, 80}, {200, 140}, {80, 140}}, kCtrl);
  CHECK(bench.selected() == std::vector<SampleSlot>{SampleSlot(0), SampleSlot(2)});
  lasso({{240, 80}, {280, 80}, {280, 120}, {240, 120}}, kCtrlShift);
  CHECK(bench.selected() == std::vector<SampleSlot>{SampleSlot(0), SampleSlot(2), SampleSlot(4)});
  lasso({{120, 80}, {160, 80}, {160, 120}, {120, 120}}, {});
  CHECK(bench.selected() == std::vector<SampleSlot>{SampleSlot(1)});
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("dragging a sample moves it exactly as far as the pointer, in one step") {
  ToolBench bench;
  SelectTool tool(bench.context);
  const Vec2 before = bench.editor.document().position(SampleSlot(1));
  drag(tool, at_pixel(143, 101), at_pixel(163, 141));
  CHECK(bench.editor.document().position(SampleSlot(1)) == before + Vec2{10, -20});
  CHECK(bench.editor.undo_name() == "Move sample");
  bench.editor.undo();
  CHECK(bench.editor.document().position(SampleSlot(1)) == before);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("dragging a selected sample moves the whole selection") {
  ToolBench bench;
  SelectTool tool(bench.context);
  bench.editor.selection().add(SampleSlot(0));
  bench.editor.selection().add(SampleSlot(2));
  drag(tool, at_pixel(180, 100), at_pixel(180, 120));
  CHECK(bench.editor.document().position(SampleSlot(0)) == at_pixel(100, 120).world);
  CHECK(bench.editor.document().position(SampleSlot(1)) == at_pixel(140, 100).world);
  CHECK(bench.editor.document().position(SampleSlot(2)) == at_pixel(180, 120).world);
  bench.editor.undo();
  CHECK(bench.editor.document().position(SampleSlot(0)) == at_pixel(100, 100).world);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("a trembling click moves nothing") {
  ToolBench bench;
  SelectTool tool(bench.context);
  drag(tool, at_pixel(140, 100), at_pixel(142, 101));
  CHECK_FALSE(bench.editor.can_undo());
  CHECK(bench.selected() == std::vector{SampleSlot(1)});
}

TEST_CASE("a cancelled move puts everything back") {
  ToolBench bench;
  SelectTool tool(bench.context);
  tool.press(at_pixel(140, 100));
  tool.drag(at_pixel(200, 150));
  CHECK(bench.editor.document().position(SampleSlot(1)) == at_pixel(200, 150).world);
  tool.cancel();
  CHECK(bench.editor.document().position(SampleSlot(1)) == at_pixel(140, 100).world);
  CHECK_FALSE(tool.is_active());
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("a click beside all samples asks what is there; on a sample only with Ctrl or Alt; a box does not") {
  ToolBench bench;
  std::vector<Vec2> asked;
  bench.context.ask_about = [&](const Pointer& pointer) { asked.push_back(pointer.px); };
  SelectTool tool(bench.context);
  click(tool, at_pixel(100, 300));
  CHECK(asked == std::vector<Vec2>{{100, 300}});
  click(tool, at_pixel(100, 100));
  drag(tool, at_pixel(50, 300), at_pixel(90, 340));
  click(tool, at_pixel(100, 300, kShift));
  CHECK(asked.size() == 1);
  click(tool, at_pixel(100, 100, Modifiers{.alt = true}));
  CHECK(asked.size() == 2);
  CHECK(bench.selected().size() == 1);
  click(tool, at_pixel(140, 100, Modifiers{.ctrl = true}));
  CHECK(asked.size() == 3);
  CHECK(bench.selected() == std::vector{SampleSlot(1)});
  // With Shift it takes out of the selection, and asks nothing.
  click(tool, at_pixel(140, 100, kCtrlShift));
  CHECK(asked.size() == 3);
  CHECK(bench.selected().empty());
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("a click that selects one sample says so; one that asks, a box and a drag do not") {
  ToolBench bench;
  std::vector<Vec2> chosen;
  bench.context.ask_about = [](const Pointer&) {};
  bench.context.note_chosen = [&](const Pointer&, const ChosenThing& thing) { chosen.push_back(thing.place); };
  SelectTool tool(bench.context);
  click(tool, at_pixel(101, 100));
  CHECK(chosen == std::vector<Vec2>{at_pixel(100, 100).world});
  click(tool, at_pixel(101, 100));  // selected already
  CHECK(chosen.size() == 2);
  click(tool, at_pixel(100, 300));
  click(tool, at_pixel(140, 100, kShift));
  click(tool, at_pixel(140, 100, Modifiers{.ctrl = true}));
  drag(tool, at_pixel(50, 300), at_pixel(90, 340));
  drag(tool, at_pixel(140, 100), at_pixel(200, 150));
  CHECK(chosen.size() == 2);
}

TEST_CASE("the select tool says when a click would ask: beside samples, in no gesture, without Shift") {
  ToolBench bench;
  SelectTool tool(bench.context);
  tool.hover(at_pixel(100, 300));
  CHECK_FALSE(tool.feedback().asks);  // nothing would answer
  bench.context.ask_about = [](const Pointer&) {};
  CHECK(tool.feedback().asks);
  tool.hover(at_pixel(100, 300, kShift));
  CHECK_FALSE(tool.feedback().asks);
  tool.hover(at_pixel(101, 100));
  CHECK_FALSE(tool.feedback().asks);
  tool.hover(at_pixel(100, 300));
  tool.press(at_pixel(100, 300));
  CHECK_FALSE(tool.feedback().asks);
  tool.release(at_pixel(100, 300));
  CHECK(tool.feedback().asks);
}
