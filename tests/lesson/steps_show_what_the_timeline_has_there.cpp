// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <vector>

#include "app/playing/lesson_walk.h"
#include "core/builtins/builtins.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

Box2 box(double low, double high) {
  Box2 out;
  out.add(Vec2{low, low});
  out.add(Vec2{high, high});
  return out;
}

LayersChanged shows(const char* layer, bool visible) {
  return {.changed = {{layer, visible, layer_descriptors()[find_layer(layer)].style}}};
}

Session session_with_edits() {
  Session session;
  session.data = std::make_shared<const SampleData>(SampleData{.positions = {{0, 0}, {1, 0}}});
  session.layers = {{{"points", true, {}}}, {}};
  ComputationSettings exact;
  exact.precision = Precision::exact;
  session.entries = {shows("curve", true),
                     ViewChanged{box(0, 1)},
                     TimelineEdit{.name = "Insert", .inserted = {{2, 2}}},
                     SettingsChanged{exact},
                     TimelineEdit{.name = "Insert", .inserted = {{3, 3}}},
                     Undone{},
                     shows("curve", false),
                     ViewChanged{box(5, 6)}};
  return session;
}

bool is_shown(const LessonScene& scene, const char* layer) {
  return scene.layers.is_visible(find_layer(layer));
}

}  // namespace

TEST_CASE("a step shows the document, layers, view and settings of its place on the timeline") {
  Session session = session_with_edits();
  for (std::size_t position = 0; position <= session.entries.size(); ++position)
    session.lesson.steps.push_back({.position = position});
  const std::vector<std::size_t> samples{2, 2, 2, 3, 3, 4, 3, 3, 3};
  const std::vector<bool> has_curve{true, true, true, true, true, true, true, false, false};
  LessonWalk walk(builtins(), session);
  // There and back again: a scene does not depend on those before.
  for (const int direction : {1, -1})
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const std::size_t i = direction > 0 ? k : samples.size() - 1 - k;
      INFO("step " << i);
      const auto scene = walk.scene(i);
      REQUIRE(scene);
      CHECK(scene->data.positions.size() == samples[i]);
      if (i > 0) CHECK(is_shown(*scene, "curve") == has_curve[i]);
      CHECK((scene->settings.precision == Precision::exact) == (i >= 4));
      CHECK(scene->view == (i >= 8 ? box(5, 6) : i >= 2 ? box(0, 1) : Box2{}));
    }
}

TEST_CASE("what a step says itself goes before what the timeline has") {
  Session session = session_with_edits();
  ComputationSettings roots;
  roots.precision = Precision::exact_roots;
  const LayerStyle style{.color = {1, 2, 3}};
  session.lesson.steps = {
      {.position = 3, .layers = {{{"voronoi", true, style}}, {}}, .settings = roots, .view = box(-1, 1)}};
  const auto scene = LessonWalk(builtins(), session).scene(0);
  REQUIRE(scene);
  CHECK(scene->layers.visible_layers() == std::vector<LayerIndex>{find_layer("voronoi")});
  CHECK(scene->layers.style(find_layer("voronoi")) == style);
  CHECK(scene->settings == roots);
  CHECK(scene->view == box(-1, 1));
}

TEST_CASE("a timeline without layers and view shows what the session shows") {
  Session session;
  session.data = std::make_shared<const SampleData>(SampleData{.positions = {{0, 0}}});
  session.layers = {{{"delaunay", true, {}}}, {}};
  session.view = box(2, 3);
  session.settings.precision = Precision::exact;
  session.lesson.steps.resize(1);
  const auto scene = LessonWalk(builtins(), session).scene(0);
  REQUIRE(scene);
  CHECK(scene->layers.visible_layers() == std::vector<LayerIndex>{find_layer("delaunay")});
  CHECK(scene->view == box(2, 3));
  CHECK(scene->settings.precision == Precision::exact);
}

TEST_CASE("an entry that makes no sense is named, and steps before it are still shown") {
  Session session = session_with_edits();
  session.entries.push_back(TimelineEdit{.name = "Delete", .removed = {77}});
  session.lesson.steps = {{.position = 9}, {.position = 3}, {.position = 9}};
  LessonWalk walk(builtins(), session);
  for (const std::size_t bad : {0U, 2U}) {
    const auto refused = walk.scene(bad);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().text, Catch::Contains("entry 9 of the timeline"));
  }
  CHECK(walk.scene(1));
}

TEST_CASE("a step without a time stays as long as its words need") {
  CHECK(seconds_of({.caption = "", .seconds = 2.5}) == 2.5);
  CHECK(seconds_of({.caption = ""}) == 4.0);
  CHECK(seconds_of({.caption = std::string(150, 'a')}) == 10.0);
  CHECK(seconds_of({.caption = std::string(10'000, 'a')}) == 30.0);
}
