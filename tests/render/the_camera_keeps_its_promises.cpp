// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/rng.h"
#include "render/camera.h"
#include "tests/support/not_finite.h"

using namespace mes;
using mes::test::kInfinity;
using mes::test::kNan;
using render::Camera;

namespace {

Camera wide_camera() {
  Camera camera;
  camera.set_viewport(1600, 1000);
  camera.look_at({3.0, -2.0}, 0.01);
  return camera;
}

bool is_sound(const Camera& camera) {
  const Box2 box = camera.visible();
  return is_finite(camera.center()) && is_finite(camera.center_low()) && std::isfinite(camera.units_per_pixel()) &&
         camera.units_per_pixel() > 0.0 && is_finite(box.low) && is_finite(box.high) && !box.is_empty() &&
         is_finite(camera.to_screen({1.0, 1.0}));
}

}  // namespace

TEST_CASE("screen and world are each other's inverse, y up in the world and down on the screen") {
  const Camera camera = wide_camera();
  CHECK(camera.to_world({800.0, 500.0}) == Vec2{3.0, -2.0});
  CHECK(camera.to_world({800.0, 400.0}).y == Approx(-1.0));
  CHECK(camera.to_world({900.0, 500.0}).x == Approx(4.0));
  Rng random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec2 p{random.uniform(-100.0, 1700.0), random.uniform(-100.0, 1100.0)};
    const Vec2 back = camera.to_screen(camera.to_world(p));
    CHECK(back.x == Approx(p.x).margin(1e-9));
    CHECK(back.y == Approx(p.y).margin(1e-9));
  }
}

TEST_CASE("the point under the cursor stays there, down to the deepest zoom and back") {
  Camera camera = wide_camera();
  const Vec2 cursor{417.0, 881.0};
  const Vec2 anchor = camera.to_world(cursor);
  for (int i = 0; i < 300; ++i) {
    camera.zoom_at(cursor, 1.1);
    const Vec2 at = camera.to_screen(anchor);
    // What a double of the anchor's size can say, in pixels, and a hair.
    const double limit =
        1e-6 + 4.0 * std::numeric_limits<double>::epsilon() * length(anchor) / camera.units_per_pixel();
    REQUIRE(std::abs(at.x - cursor.x) < limit);
    REQUIRE(std::abs(at.y - cursor.y) < limit);
  }
  CHECK(camera.units_per_pixel() == Approx(0.01 / std::pow(1.1, 300)).epsilon(1e-9));
  for (int i = 0; i < 300; ++i) camera.zoom_at(cursor, 1.0 / 1.1);
  CHECK(camera.center().x == Approx(3.0).margin(1e-9));
  CHECK(camera.center().y == Approx(-2.0).margin(1e-9));
  CHECK(camera.units_per_pixel() == Approx(0.01).epsilon(1e-9));
}

TEST_CASE("the zoom ends where doubles end, and the view stays put there") {
  Camera camera = wide_camera();
  for (int i = 0; i < 5000; ++i) camera.zoom_at({10.0, 10.0}, 2.0);
  CHECK(is_sound(camera));
  CHECK(camera.units_per_pixel() < 1e-15);
  CHECK(camera.units_per_pixel() > 1e-20);
  const Vec2 center = camera.center();
  camera.zoom_at({10.0, 10.0}, 1000.0);
  CHECK(camera.center() == center);
  for (int i = 0; i < 5000; ++i) camera.zoom_at({10.0, 10.0}, 0.5);
  CHECK(is_sound(camera));
}

TEST_CASE("panning there and back again is exact where a double alone would round") {
  Camera camera;
  camera.set_viewport(800, 600);
  camera.look_at({1e15, 0.3}, 1e-3);
  const Camera before = camera;
  for (int i = 0; i < 1000; ++i) camera.pan({7.0, 3.0});
  // 7 pixels are far below what numbers around 10^15 tell apart, but not lost.
  CHECK((camera.center().x - 1e15) + camera.center_low().x == Approx(-7.0).epsilon(1e-9));
  for (int i = 0; i < 1000; ++i) camera.pan({-7.0, -3.0});
  CHECK(camera.center() == before.center());
  CHECK(camera.center_low().x == Approx(0.0).margin(1e-12));
}

TEST_CASE("fit shows the whole box with its margin") {
  Camera camera;
  camera.set_viewport(1000, 500);
  camera.fit({{-1.0, -1.0}, {3.0, 1.0}}, 50.0);
  CHECK(camera.center() == Vec2{1.0, 0.0});
  const Vec2 low = camera.to_screen({-1.0, -1.0});
  const Vec2 high = camera.to_screen({3.0, 1.0});
  CHECK(low.y == Approx(450.0));
  CHECK(high.y == Approx(50.0));
  CHECK(low.x >= 50.0);
  CHECK(high.x <= 950.0);

  SECTION("an empty box, a point, and boxes at the end of the number range") {
    camera.fit({}, 20.0);
    CHECK(is_sound(camera));
    CHECK(camera.visible().contains({1.0, 1.0}));
    camera.fit({{5.0, 5.0}, {5.0, 5.0}}, 20.0);
    CHECK(camera.center() == Vec2{5.0, 5.0});
    CHECK(camera.visible().width() < 100.0);
    camera.fit({{0.0, 0.0}, {0.0, 0.0}}, 20.0);
    CHECK(is_sound(camera));
    camera.fit({{-1e308, -1e308}, {1e308, 1e308}}, 20.0);
    CHECK(is_sound(camera));
    camera.fit({{1e-308, 0.0}, {2e-308, 1e-308}}, 20.0);
    CHECK(is_sound(camera));
    camera.fit({{-1.0, -1.0}, {1.0, 1.0}}, 1e9);
    CHECK(is_sound(camera));
    CHECK(camera.visible().contains({1.0, 1.0}));
  }
}

TEST_CASE("nothing said to it makes it unsound") {
  Rng random(11);
  Camera camera;
  const auto number = [&]() -> double {
    switch (random.below(8)) {
      case 0: return kNan;
      case 1: return kInfinity;
      case 2: return -kInfinity;
      case 3: return 0.0;
      case 4: return 1e308 * random.uniform(-1.0, 1.0);
      case 5: return 1e-308 * random.uniform(-1.0, 1.0);
      default: return random.uniform(-1000.0, 1000.0);
    }
  };
  for (int i = 0; i < 20000; ++i) {
    switch (random.below(6)) {
      case 0: camera.pan({number(), number()}); break;
      case 1: camera.zoom_at({number(), number()}, number()); break;
      case 2: camera.look_at({number(), number()}, number()); break;
      case 3: {
        Box2 box;
        box.add(Vec2{number(), number()});
        box.add(Vec2{number(), number()});
        camera.fit(box, number());
        break;
      }
      case 4:
        camera.set_viewport(static_cast<int>(random.below(4000)) - 100, static_cast<int>(random.below(3000)) - 100);
        break;
      default: camera = camera.part(static_cast<int>(random.below(100)), 3, 64, 64); break;
    }
    REQUIRE(is_sound(camera));
    REQUIRE(is_finite(camera.to_world({number(), number()})));
    const Vec2 far = camera.to_screen({1e308, -1e308});
    REQUIRE(is_finite(far));
  }
}

TEST_CASE("a part of a view sees what the whole sees there") {
  const Camera camera = wide_camera();
  const Camera part = camera.part(301, 77, 333, 501);
  for (const Vec2 p : {Vec2{0.0, 0.0}, Vec2{100.5, 33.0}}) {
    const Vec2 whole = camera.to_world({p.x + 301.0, p.y + 77.0});
    CHECK(part.to_world(p).x == Approx(whole.x).epsilon(1e-12));
    CHECK(part.to_world(p).y == Approx(whole.y).epsilon(1e-12));
  }
}
