// SPDX-License-Identifier: GPL-3.0-or-later
// The light and the drawing while another document is computed, and the places the light leads to.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/base/rng.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr PixelBox kLight{780, 775, 1270, 798};
bool is_green(Color c) {
  return c.g > 130 && c.r < 60 && c.b < 150;
}
bool is_amber(Color c) {
  return c.r > 160 && c.g > 105 && c.g < 180 && c.b < 60;
}

std::string poff_of(const std::vector<Vec2>& points) {
  std::string out = "POFF " + std::to_string(points.size()) + " 0 0\n";
  for (const Vec2 p : points) out += std::to_string(p.x) + ' ' + std::to_string(p.y) + '\n';
  return out;
}

}  // namespace

TEST_CASE("while another document is computed the drawing of the one before is dimmed, and the light says so") {
  DrivenProgram window;
  // Numbers with roots take longer than any test for samples without a shape.
  Session square;
  square.data = std::make_shared<const SampleData>(SampleData{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}, {}});
  square.settings.precision = Precision::exact_roots;
  square.settings[Parameter::union_shortcut] = 0.0;
  square.layers.layers = {{"a-ball-medial-axis", true, {}}, {"points", true, {.point_size_px = 20.0}}};
  window.folder.write("a_square.json", write_session(square));
  Rng rng(1);
  // Within the square, so that the view stays.
  std::vector<Vec2> points{{0, 0}, {4, 4}};
  while (points.size() < 2000) points.push_back({rng.uniform(0.0, 4.0), rng.uniform(0.0, 4.0)});
  window.folder.write("many.poff", poff_of(points));
  window.start("a_square.json");
  const auto is_dark = [](Color c) { return c.r < 60 && c.g < 60 && c.b < 60; };
  REQUIRE(eventually([&] {
    const Screenshot shot = window.screen.shoot();
    return !shot.box_of(kLight, is_green).is_empty() && !shot.box_of(kCanvas, is_dark).is_empty();
  }));
  const Screenshot drawn = window.screen.settled();
  const PixelBox samples = drawn.box_of(kCanvas, is_dark);
  const std::array<int, 2> corner{samples.left + 5, samples.top + 5};
  REQUIRE(drawn.is_dark(corner[0], corner[1]));

  window.press("ctrl+o");
  static_cast<void>(window.other_than(drawn));
  window.screen.xdotool("type ma");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  REQUIRE(eventually([&] { return window.title().starts_with("many.poff"); }));
  // Pale, but still there, in the place where it was.
  CHECK(eventually([&] {
    const Color c = window.screen.shoot().at(corner[0], corner[1]);
    return c.r > 150 && c.r < 245 && c.r == c.g && c.g == c.b;
  }));
  const Screenshot waiting = window.screen.shoot();
  CHECK(waiting.box_of(kLight, is_green).is_empty());
  CHECK(waiting.box_of(kLight, is_amber).is_empty());
}

TEST_CASE("a place that the light names is shown with its neighbours") {
  DrivenProgram window;
  // A circle, and on it a bristle: two samples with one and with three edges of the curve.
  constexpr int kSamples = 200;
  std::vector<Vec2> points;
  for (int i = 0; i < kSamples; ++i) {
    const double t = 2.0 * std::numbers::pi * i / kSamples;
    points.push_back(100.0 * Vec2{std::cos(t), std::sin(t)});
  }
  for (const double x : {103.0, 106.0, 109.0}) points.push_back({x, 0.0});
  window.folder.write("bristle.poff", poff_of(points));
  window.start("bristle.poff");
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(kLight, is_amber).is_empty(); }));
  const Screenshot before = window.screen.settled();
  window.screen.click(before.box_of(kLight, is_amber).middle());
  constexpr PixelBox kReasons{780, 520, 950, 770};
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(kReasons, is_amber).is_empty(); }));
  const Screenshot reasons = window.screen.settled();
  // The first dot, a sentence of two lines beside it, and below that a button for each place.
  const PixelBox dots = reasons.box_of(kReasons, is_amber);
  window.screen.click({dots.left + 24, dots.top + 41});
  static_cast<void>(window.other_than(reasons));
  window.press("Escape");
  window.save_as("place.json");
  const auto session = read_session(bytes_of(window.folder / "place.json"), "place.json");
  REQUIRE(session);
  const Box2 view = session->view;
  const Vec2 middle = 0.5 * (view.low + view.high);
  CHECK(std::min(distance(middle, {109.0, 0.0}), distance(middle, {100.0, 0.0})) < 1e-3);
  // Ten samples on either side, a little more or less, and not the whole shape.
  const auto seen = std::ranges::count_if(points, [&](Vec2 p) { return view.contains(p); });
  CHECK(seen >= 12);
  CHECK(seen <= 60);
}

// Undo leads to revisions before the one at which the session was opened.
TEST_CASE(
    "what was done before a session was saved is undone, and the drawing is no longer that of a document before") {
  DrivenProgram window;
  std::filesystem::copy("assets/lessons/crust.json", window.folder / "crust.json");
  window.start("crust.json");
  const auto is_black = [](Color c) { return c.r + c.g + c.b == 0; };
  static_cast<void>(window.drawn());
  // Annotations and views of its steps.
  for (int i = 0; i < 6; ++i) window.press("ctrl+z");
  REQUIRE(eventually([&] { return window.title().starts_with('*'); }));
  const Screenshot undone = window.drawn();
  CHECK_FALSE(undone.box_of(kCanvas, is_black).is_empty());
}
