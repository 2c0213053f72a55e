// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "app/recording/frame_view.h"
#include "app/recording/recorder.h"

using namespace mes;

TEST_CASE("each change gets one frame, once its picture is complete") {
  ShownState now;
  Recorder recorder(now, false);
  recorder.note_complete(now);
  CHECK_FALSE(recorder.is_due(now, {}));
  CHECK_FALSE(recorder.holds_input(now, {}, false));

  now.document = 1;
  CHECK_FALSE(recorder.is_due(now, {}));  // the results of the old state were complete
  CHECK(recorder.holds_input(now, {}, false));
  recorder.note_complete(std::nullopt);
  CHECK_FALSE(recorder.is_due(now, {}));
  recorder.note_complete(now);
  REQUIRE(recorder.is_due(now, {}));
  CHECK(recorder.change(now) == Change::document);
  recorder.note_captured(now);
  CHECK_FALSE(recorder.is_due(now, {}));
  CHECK_FALSE(recorder.holds_input(now, {}, false));

  // Undo goes back to an earlier revision: that is a change as well.
  now.document = 0;
  recorder.note_complete(now);
  CHECK(recorder.is_due(now, {}));
}

TEST_CASE("what was cancelled delays nothing and is not a frame") {
  ShownState now;
  Recorder recorder(now, false);
  now.document = 1;
  recorder.note_complete(std::nullopt);
  CHECK_FALSE(recorder.holds_input(now, {}, true));
  CHECK_FALSE(recorder.is_due(now, {}));
}

TEST_CASE("a view is a frame at rest, or at each step if that is asked for") {
  ShownState now;
  Recorder at_rest(now, false);
  Recorder each(now, true);
  now.view.pan({3, 4});
  at_rest.note_complete(now);
  each.note_complete(now);
  const AtRest moving{.view = false};
  CHECK_FALSE(at_rest.is_due(now, moving));
  CHECK_FALSE(at_rest.holds_input(now, moving, false));
  CHECK(at_rest.is_due(now, {}));
  CHECK(at_rest.holds_input(now, {}, false));
  CHECK(each.is_due(now, moving));
  CHECK(each.holds_input(now, moving, false));
  CHECK(each.change(now) == Change::view);
  // An edit while the view glides is a frame at once.
  now.document = 1;
  at_rest.note_complete(now);
  CHECK(at_rest.is_due(now, moving));
}

TEST_CASE("a slider is a frame when it is let go") {
  ShownState now;
  Recorder recorder(now, false);
  now.layers = 5;
  recorder.note_complete(now);
  CHECK_FALSE(recorder.is_due(now, {.controls = false}));
  CHECK(recorder.is_due(now, {}));
  CHECK(recorder.change(now) == Change::layers);
  now.settings.precision = Precision::exact;
  CHECK(recorder.change(now) == Change::settings);
}

TEST_CASE("a frame is named after what was done") {
  TimelineLog timeline;
  CHECK(name_of(Change::document, timeline) == "Open");
  timeline.emplace_back(TimelineEdit{.name = "Insert sample"});
  CHECK(name_of(Change::document, timeline) == "Insert sample");
  timeline.emplace_back(GestureBegun{"Spray"});
  timeline.emplace_back(TimelineEdit{});
  timeline.emplace_back(TimelineEdit{});
  timeline.emplace_back(LayersChanged{});
  CHECK(name_of(Change::document, timeline) == "Spray");
  CHECK(name_of(Change::settings, timeline) == "Computation");
  timeline.emplace_back(Undone{});
  CHECK(name_of(Change::document, timeline) == "Undo");
}

TEST_CASE("impossible frames are refused in one line") {
  RecordSettings settings;
  CHECK(check(settings));
  settings.width = 1920;
  CHECK_THAT(check(settings).error().message(), Catch::Contains("1920x0"));
  settings.height = 1080;
  CHECK(check(settings));
  settings.width = 20'000;
  CHECK_THAT(check(settings).error().message(), Catch::Contains("at most 16384"));
  settings.width = settings.height = 16'384;
  CHECK_THAT(check(settings).error().message(), Catch::Contains("million"));
  settings.width = -1;
  CHECK_FALSE(check(settings));
  settings = {.supersampling = 3};
  CHECK_FALSE(check(settings));
  settings = {.fps = 0.0};
  CHECK_FALSE(check(settings));
}

TEST_CASE("a frame of another size shows all that the window shows, to scale") {
  render::Camera window;
  window.set_viewport(800, 600);
  window.look_at({3, 4}, 0.01);
  constexpr WindowPart kAll{0, 0, 800, 600};
  const FrameView wide = frame_view(window, kAll, 2.0, {.width = 1920, .height = 1200});
  CHECK(wide.camera.width() == 1920);
  CHECK(wide.camera.center() == Vec2{3, 4});
  CHECK(wide.camera.units_per_pixel() == Approx(0.005));
  CHECK(wide.content_scale == Approx(4.0));
  CHECK(frame_view(window, kAll, 2.0, {}).camera == window);
  // Deep zoom: the low bits of the centre stay.
  window.look_at({1e6, 0}, 1e-12);
  window.pan({5, 7});
  const FrameView same = frame_view(window, kAll, 1.0, {.width = 800, .height = 600});
  CHECK(same.camera == window);
}

TEST_CASE("a frame shows what is between the panels") {
  CHECK(part_between({}, 800, 600) == WindowPart{0, 0, 800, 600});
  const WindowPart part = part_between({50, 20.5, 149.5, 30}, 800, 600);
  CHECK(part == WindowPart{50, 21, 600, 549});
  // A window that is all panels is shown whole.
  CHECK(part_between({400, 0, 390, 0}, 800, 600) == WindowPart{0, 0, 800, 600});
  render::Camera window;
  window.set_viewport(800, 600);
  window.look_at({0, 0}, 1.0);
  const FrameView own = frame_view(window, part, 2.0, {});
  CHECK(own.camera.width() == 600);
  CHECK(own.camera.height() == 549);
  CHECK(own.camera.center().x == Approx(-50.0));
  CHECK(own.camera.center().y == Approx(300.0 - 21.0 - 274.5));
  CHECK(own.content_scale == 2.0);
  const FrameView twice = frame_view(window, part, 2.0, {.width = 1200, .height = 2000});
  CHECK(twice.camera.center().x == Approx(-50.0));
  CHECK(twice.camera.units_per_pixel() == Approx(0.5));
  CHECK(twice.content_scale == 4.0);
}

TEST_CASE("showing the legend is a frame, and so are a key, a scale bar, axes, and another caption") {
  ShownState now;
  Recorder recorder(now, false);
  const auto check_frame = [&] {
    recorder.note_complete(now);
    CHECK(recorder.is_due(now, {}));
    CHECK(recorder.change(now) == Change::texts);
    recorder.note_captured(now);
    CHECK_FALSE(recorder.is_due(now, {}));
  };
  now.legend = LegendScope::color_maps;
  check_frame();
  now.legend = LegendScope::all_layers;
  check_frame();
  now.marks.bar = true;
  check_frame();
  now.marks.axes = true;
  check_frame();
  now.legend_at = PaperPlace{PaperCorner::top_left};
  check_frame();
  now.marks.bar_at = PaperPlace{PaperCorner::top_right};
  check_frame();
  now.caption = "What of it the union covers";
  recorder.note_complete(now);
  CHECK(recorder.is_due(now, {}));
  // Together with an edit it is that edit.
  now.document = 1;
  CHECK(recorder.change(now) == Change::document);
}
