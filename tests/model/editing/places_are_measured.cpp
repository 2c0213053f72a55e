// SPDX-License-Identifier: GPL-3.0-or-later
// The measuring tool: what it says of two and of three places, and that places on samples follow them.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/canvas/canvas.h"
#include "app/canvas/tools/measure_tool.h"
#include "app/editing/places/measurement.h"
#include "tests/model/editing/tool_hand.h"

using namespace mes;
using mes::test::at_pixel;

namespace {

using Words = std::vector<std::string>;

struct MeasureBench {
  Editor editor{{}};
  double spacing = 10.0;
  AnnotationEditor annotations{editor};
  ToolContext context{editor, annotations, spacing, [](const Error&) {}};
  MeasureTool tool{context};

  MeasureBench() {
    SampleData data;
    data.positions = {at_pixel(100, 100).world, at_pixel(200, 100).world};
    REQUIRE(editor.load(data));
  }
  void click(const Pointer& pointer) {
    tool.hover(pointer);
    tool.press(pointer);
    CHECK(tool.is_active());
    tool.release(pointer);
    CHECK_FALSE(tool.is_active());
  }
  std::vector<Vec2> measured() const { return tool.feedback().measured; }
};

}  // namespace

TEST_CASE("two places have a distance and a direction, three an angle and a circle") {
  CHECK(measured_words({}).empty());
  const std::vector<Vec2> one{{1, 2}};
  CHECK(measured_words(one).empty());
  const std::vector<Vec2> two{{1, 1}, {4, 5}};
  CHECK(measured_words(two) == Words{"distance 5", "dx 3, dy 4", "direction 53.1301\u00b0"});
  const std::vector<Vec2> right{{3, 0}, {0, 0}, {0, 4}};
  CHECK(measured_words(right) == Words{"distance 4", "angle 90\u00b0", "circle of radius 2.5", "around 1.5, 2"});
  CHECK(measured_circle(right)->radius == 2.5);
  // The inscribed angle over a diameter is right, wherever its corner is.
  for (const double t : {0.3, 1.1, 2.9}) {
    const std::vector<Vec2> inscribed{{-5, 0}, {5 * std::cos(t), 5 * std::sin(t)}, {5, 0}};
    CHECK(measured_words(inscribed)[1] == "angle 90\u00b0");
    CHECK(measured_words(inscribed)[2] == "circle of radius 5");
  }
}

TEST_CASE("places that coincide or are on one line are said to be that") {
  const std::vector<Vec2> same{{2, 3}, {2, 3}};
  CHECK(measured_words(same) == Words{"distance 0", "dx 0, dy 0"});
  const std::vector<Vec2> line{{0, 0}, {1, 1}, {3, 3}};
  CHECK(measured_words(line) == Words{"distance 2.82843", "angle 180\u00b0", "on one line"});
  CHECK_FALSE(measured_circle(line));
  const std::vector<Vec2> thrice{{1, 1}, {1, 1}, {1, 1}};
  CHECK(measured_words(thrice) == Words{"distance 0", "on one line"});
  // The last place lies one double above the line through the others, on which x = y.
  const std::vector<Vec2> nearly{{0.1, 0.1}, {0.2, 0.2}, {0.3, std::nextafter(0.3, 1.0)}};
  CHECK(measured_circle(nearly).has_value());
}

TEST_CASE("three clicks are three places, a fourth begins anew, and the last one follows the pointer") {
  MeasureBench bench;
  bench.tool.hover(at_pixel(10, 10));
  CHECK(bench.measured().empty());
  bench.click(at_pixel(10, 10));
  bench.tool.hover(at_pixel(50, 10));
  CHECK(bench.measured() == std::vector<Vec2>{at_pixel(10, 10).world, at_pixel(50, 10).world});
  bench.tool.leave();
  CHECK(bench.measured().size() == 1);
  bench.click(at_pixel(50, 10));
  bench.click(at_pixel(50, 60));
  CHECK(bench.measured().size() == 3);
  bench.tool.hover(at_pixel(300, 300));
  CHECK(bench.measured() ==
        std::vector<Vec2>{at_pixel(10, 10).world, at_pixel(50, 10).world, at_pixel(50, 60).world});
  bench.click(at_pixel(70, 70));
  CHECK(bench.measured().front() == at_pixel(70, 70).world);
  CHECK(bench.tool.clear());
  CHECK_FALSE(bench.tool.clear());
  CHECK(bench.measured().empty());
  // Nothing of it is an edit.
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("what a drag has measured is shown until the pointer leaves the second place") {
  MeasureBench bench;
  bench.tool.press(at_pixel(10, 10));
  bench.tool.drag(at_pixel(40, 10));
  bench.tool.release(at_pixel(40, 10));
  CHECK(bench.measured() == std::vector<Vec2>{at_pixel(10, 10).world, at_pixel(40, 10).world});
  bench.tool.hover(at_pixel(40, 10));
  CHECK(bench.measured().size() == 2);
  bench.tool.hover(at_pixel(40, 90));
  CHECK(bench.measured().size() == 3);
  bench.tool.hover(at_pixel(40, 10));
  CHECK(bench.measured().size() == 2);
}

TEST_CASE("a drag measures from where it began, and Esc in the middle of it takes it back") {
  MeasureBench bench;
  bench.tool.press(at_pixel(10, 10));
  bench.tool.drag(at_pixel(30, 10));
  CHECK(bench.measured() == std::vector<Vec2>{at_pixel(10, 10).world, at_pixel(30, 10).world});
  bench.tool.release(at_pixel(40, 10));
  bench.tool.leave();
  CHECK(bench.measured() == std::vector<Vec2>{at_pixel(10, 10).world, at_pixel(40, 10).world});
  bench.tool.press(at_pixel(40, 80));
  bench.tool.cancel();
  bench.tool.leave();
  CHECK(bench.measured().empty());
  CHECK_FALSE(bench.tool.is_active());
}

TEST_CASE("a place on a sample follows it, and is where it was clicked once the sample is deleted") {
  MeasureBench bench;
  // Some pixels beside the samples.
  bench.click(at_pixel(103, 102));
  bench.click(at_pixel(196, 99));
  bench.tool.leave();
  CHECK(measured_words(bench.measured()).front() == "distance 50");
  const SampleId first = bench.editor.document().id(SampleSlot(0));
  const std::array<std::pair<SampleId, Vec2>, 1> target{{{first, at_pixel(100, 200).world}}};
  REQUIRE(bench.editor.move(target, {}));
  CHECK(bench.measured().front() == at_pixel(100, 200).world);
  bench.editor.undo();
  CHECK(bench.measured().front() == at_pixel(100, 100).world);
  bench.editor.selection().select_all(bench.editor.document());
  REQUIRE(bench.editor.remove_selection());
  CHECK(bench.measured() == std::vector<Vec2>{at_pixel(100, 100).world, at_pixel(200, 100).world});
}

TEST_CASE("measurements are discarded with the document") {
  MeasureBench bench;
  Canvas canvas(bench.context);
  canvas.view().set_viewport(800, 600);
  canvas.choose_tool(ToolId::measure);
  canvas.press(PointerButton::left, {10, 10}, {});
  canvas.release(PointerButton::left, {90, 10}, {});
  CHECK(canvas.tool().feedback().measured.size() == 2);
  canvas.clear_all_tools();
  CHECK(canvas.tool().feedback().measured.empty());
}
