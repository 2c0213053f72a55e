// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>

#include "app/canvas/canvas.h"

using namespace mes;

namespace {

struct ViewBench {
  Editor editor{{}};
  double spacing = 10.0;
  AnnotationEditor annotations{editor};
  ToolContext context{editor, annotations, spacing, {}};
  Canvas canvas{context};
  ViewMotion& view = canvas.view();

  ViewBench() {
    view.set_viewport(1000, 800);
    view.fit({{-100, -100}, {100, 100}}, 0.0, true);
  }
  void settle() {
    for (int i = 0; i < 1000 && view.is_moving(); ++i) canvas.advance(0.016);
    REQUIRE_FALSE(view.is_moving());
  }
};

}  // namespace

TEST_CASE("while zooming the point under the cursor stays there in every frame") {
  ViewBench bench;
  const Vec2 cursor{730, 120};
  const Vec2 world = bench.view.camera().to_world(cursor);
  const double before = bench.view.camera().units_per_pixel();
  bench.canvas.wheel(cursor, 3);
  int frames = 0;
  while (bench.view.is_moving()) {
    bench.canvas.advance(0.016);
    CHECK(distance(bench.view.camera().to_screen(world), cursor) < 1e-6);
    REQUIRE(++frames < 200);
  }
  CHECK(frames > 3);
  CHECK(bench.view.camera().units_per_pixel() == Approx(before / (1.2 * 1.2 * 1.2)));
}

TEST_CASE("fitting stays clear of the panels and ends exactly there") {
  ViewBench bench;
  bench.view.set_insets({.left = 100, .top = 50, .right = 300, .bottom = 30});
  const Box2 box{{10, 20}, {50, 40}};
  bench.view.fit(box, 20.0);
  bench.settle();
  const auto& camera = bench.view.camera();
  const Vec2 low = camera.to_screen(box.low);
  const Vec2 high = camera.to_screen(box.high);
  CHECK(low.x == Approx(100 + 20));
  CHECK(high.x == Approx(1000 - 300 - 20));
  CHECK(0.5 * (low.y + high.y) == Approx(0.5 * (50 + 800 - 30)));
}

TEST_CASE("a view is as fitted until somebody moves it") {
  ViewBench bench;
  const auto fit = [&] {
    bench.view.fit({{10, 20}, {50, 40}}, 20.0);
    bench.settle();
    CHECK(bench.view.is_as_fitted());
  };
  fit();
  bench.view.set_viewport(900, 700);
  CHECK(bench.view.is_as_fitted());
  bench.view.pan({1, 0});
  CHECK_FALSE(bench.view.is_as_fitted());
  fit();
  bench.canvas.wheel({500, 400}, 1);
  CHECK_FALSE(bench.view.is_as_fitted());
  bench.settle();
  fit();
  bench.view.back();
  CHECK_FALSE(bench.view.is_as_fitted());
}

TEST_CASE("previous view returns to what was left") {
  ViewBench bench;
  const render::Camera first = bench.view.camera();
  CHECK_FALSE(bench.view.can_go_back());
  bench.canvas.advance(5.0);
  bench.canvas.wheel({500, 400}, 4);
  bench.settle();
  bench.canvas.advance(5.0);
  const render::Camera second = bench.view.camera();
  bench.view.fit({{1000, 1000}, {1001, 1001}}, 0.0);
  bench.settle();
  bench.view.back();
  bench.settle();
  CHECK(bench.view.camera() == second);
  bench.view.back();
  bench.settle();
  CHECK(bench.view.camera() == first);
}

TEST_CASE("resizing the window leaves the drawing in its place") {
  ViewBench bench;
  const Vec2 before = bench.view.camera().to_screen({17, 23});
  bench.view.set_viewport(1400, 700);
  CHECK(distance(bench.view.camera().to_screen({17, 23}), before) < 1e-9);
}

TEST_CASE("middle, right and Space drags pan, and change nothing else") {
  ViewBench bench;
  REQUIRE(bench.editor.insert(std::array{Vec2{0, 0}}, "insert"));
  const auto digest = bench.editor.document().digest();
  const auto drag = [&](PointerButton button) {
    const Vec2 before = bench.view.camera().to_screen({0, 0});
    bench.canvas.press(button, before, {});
    bench.canvas.move(before + Vec2{30, 10}, {});
    bench.canvas.release(button, before + Vec2{50, -20}, {});
    return bench.view.camera().to_screen({0, 0}) - before;
  };
  for (const PointerButton button : {PointerButton::middle, PointerButton::right}) {
    CHECK(distance(drag(button), {50, -20}) < 1e-9);
  }
  bench.canvas.set_space_held(true);
  CHECK(distance(drag(PointerButton::left), {50, -20}) < 1e-9);
  bench.canvas.set_space_held(false);
  CHECK(bench.editor.document().digest() == digest);
  CHECK(distance(drag(PointerButton::left), {0, 0}) < 1e-9);
  CHECK(bench.editor.document().digest() != digest);
  CHECK(bench.canvas.has_pointer() == false);
}

TEST_CASE("a click of the right button asks for a menu, and a drag of it only pans") {
  ViewBench bench;
  const auto before = bench.view.camera();
  bench.canvas.press(PointerButton::right, {100, 100}, {});
  bench.canvas.move({102, 101}, {});
  CHECK(bench.canvas.has_pointer());
  CHECK(bench.canvas.release(PointerButton::right, {101, 102}, {}));
  CHECK(bench.view.camera() == before);
  // A drag that returns to its start does not count as a click.
  bench.canvas.press(PointerButton::right, {100, 100}, {});
  bench.canvas.move({140, 100}, {});
  bench.canvas.move({100, 100}, {});
  CHECK_FALSE(bench.canvas.release(PointerButton::right, {100, 100}, {}));
  // Neither is one that was cancelled, nor a click of another button.
  bench.canvas.press(PointerButton::right, {100, 100}, {});
  CHECK(bench.canvas.cancel_gesture());
  CHECK_FALSE(bench.canvas.release(PointerButton::right, {100, 100}, {}));
  for (const PointerButton button : {PointerButton::left, PointerButton::middle}) {
    bench.canvas.press(button, {100, 100}, {});
    CHECK_FALSE(bench.canvas.release(button, {100, 100}, {}));
  }
}

TEST_CASE("a view that moves under a held sample takes the sample along with the pointer") {
  ViewBench bench;
  REQUIRE(bench.editor.insert(std::array{Vec2{0, 0}}, "insert"));
  const Vec2 at = bench.view.camera().to_screen({0, 0});
  bench.canvas.press(PointerButton::left, at, {});
  bench.canvas.move(at + Vec2{40, 0}, {});
  bench.canvas.wheel({0, 0}, 2);
  bench.settle();
  const Vec2 now = bench.view.camera().to_screen(bench.editor.document().position(SampleSlot(0)));
  CHECK(distance(now, at + Vec2{40, 0}) < 1e-6);
  bench.canvas.release(PointerButton::left, at + Vec2{40, 0}, {});
  bench.editor.undo();
  CHECK(bench.editor.document().position(SampleSlot(0)) == Vec2{0, 0});
}

TEST_CASE("a second button during a gesture does not disturb it") {
  ViewBench bench;
  bench.canvas.choose_tool(ToolId::insert);
  bench.canvas.press(PointerButton::left, {100, 100}, {});
  bench.canvas.press(PointerButton::right, {100, 100}, {});
  bench.canvas.choose_tool(ToolId::spray);
  bench.canvas.release(PointerButton::right, {100, 100}, {});
  CHECK(bench.canvas.has_pointer());
  bench.canvas.release(PointerButton::left, {120, 100}, {});
  CHECK_FALSE(bench.canvas.has_pointer());
  CHECK(bench.editor.document().sample_count() == 1);
  CHECK(bench.canvas.tool_id() == ToolId::insert);
}

TEST_CASE("a drawing that would lie under the legend is shown above or beside it, where it is larger") {
  const Insets insets{.left = 100, .top = 0, .right = 0, .bottom = 0};
  const Vec2 viewport{1100, 500};
  const Vec2 legend{200, 100};
  const auto is = [](const Insets& out, double right, double bottom) {
    return out.left == 100 && out.top == 0 && out.right == right && out.bottom == bottom;
  };
  CHECK(is(clear_of_corner(insets, viewport, {}, {1, 1}), 0, 0));
  // Narrow or flat, it is not in the way.
  CHECK(is(clear_of_corner(insets, viewport, legend, {1, 1}), 0, 0));
  CHECK(is(clear_of_corner(insets, viewport, legend, {10, 1}), 0, 0));
  // A wide one loses nothing when it is above, one as high as the window less when it is beside.
  CHECK(is(clear_of_corner(insets, viewport, legend, {2.5, 1}), 0, 100));
  CHECK(is(clear_of_corner(insets, viewport, {200, 400}, {1.8, 1}), 200, 0));
  // Neither a single point nor a window without room do harm.
  CHECK(is(clear_of_corner(insets, viewport, legend, {0, 0}), 0, 0));
  CHECK(clear_of_corner(insets, {50, 50}, legend, {1, 1}).left == 100);
}
