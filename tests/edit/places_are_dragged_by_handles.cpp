// SPDX-License-Identifier: GPL-3.0-or-later
// Handles of a frame: what is held comes to lie where it is dragged, what is opposite stays, and maps are what they say.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/edit/frame_handles.h"

using namespace mes;

namespace {

Box2 box_of(const std::vector<Vec2>& places) {
  Box2 out;
  for (const Vec2 p : places) out.add(p);
  return out;
}

constexpr Handle kScaling[] = {Handle::left,       Handle::right,       Handle::bottom,     Handle::top,
                               Handle::lower_left, Handle::lower_right, Handle::upper_left, Handle::upper_right};
constexpr Handle kOpposite[] = {Handle::right,       Handle::left,       Handle::top,         Handle::bottom,
                                Handle::upper_right, Handle::upper_left, Handle::lower_right, Handle::lower_left};

}  // namespace

TEST_CASE("a dragged handle keeps what is opposite, and its own side follows exactly") {
  Rng rng(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec2> places;
    for (int i = 0; i < 9; ++i) places.push_back({1e3 + rng.uniform(), 40 * rng.uniform()});
    const Box2 box = box_of(places);
    for (std::size_t h = 0; h < std::size(kScaling); ++h) {
      const bool is_corner = h >= 4;
      const Vec2 held = held_place(box, kScaling[h]);
      const Vec2 to{held.x + rng.uniform() - 0.3, held.y + 10 * (rng.uniform() - 0.3)};
      const auto result = dragged(places, box, {kScaling[h], held, to});
      REQUIRE(result);
      const Box2 after = box_of(result->places);
      const Vec2 stays = held_place(box, kOpposite[h]);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec2 expected{stays.x + result->factor.x * (places[i].x - stays.x),
                            stays.y + result->factor.y * (places[i].y - stays.y)};
        if (h < 2 || is_corner) CHECK(result->places[i].x == Approx(expected.x).epsilon(1e-12));
        if (h >= 2) CHECK(result->places[i].y == Approx(expected.y).margin(1e-9));
        if (h < 2) CHECK(result->places[i].y == places[i].y);
        if (h == 2 || h == 3) CHECK(result->places[i].x == places[i].x);
      }
      if (h < 2) CHECK((after.low.x == to.x || after.high.x == to.x));
      if (h == 2 || h == 3) CHECK((after.low.y == to.y || after.high.y == to.y));
      CHECK(result->radius_factor == (is_corner ? std::abs(result->factor.x) : 1.0));
      if (is_corner) CHECK(result->factor.x == result->factor.y);
    }
  }
}

TEST_CASE("a side dragged across the other one mirrors, and a factor of zero is not taken") {
  const std::vector<Vec2> places{{0, 0}, {4, 1}, {1, 3}};
  const Box2 box = box_of(places);
  const auto mirrored = dragged(places, box, {Handle::right, {4, 1.5}, {-4, 9}});
  REQUIRE(mirrored);
  CHECK(mirrored->places == std::vector<Vec2>{{0, 0}, {-4, 1}, {-1, 3}});
  CHECK_FALSE(dragged(places, box, {Handle::right, {4, 1.5}, {0, 1}}));
  CHECK_FALSE(dragged(places, box, {Handle::upper_right, {4, 3}, {0, 0}}));
  const auto about_middle = dragged(places, box, {Handle::top, {2, 3}, {2, 4.5}, true});
  REQUIRE(about_middle);
  CHECK(about_middle->places == std::vector<Vec2>{{0, -1.5}, {4, 0.5}, {1, 4.5}});
}

TEST_CASE("turning by steps is exact at right angles") {
  const std::vector<Vec2> places{{0, 0}, {4, 2}, {4, 0}};
  const Box2 box = box_of(places);
  const auto turned = dragged(places, box, {Handle::turn, {2, 5}, {-3, 1.02}, true, true});
  REQUIRE(turned);
  CHECK(turned->degrees == 90.0);
  CHECK(turned->places == std::vector<Vec2>{{3, -1}, {1, 3}, {3, 3}});
  const auto free = dragged(places, box, {Handle::turn, {2, 5}, {6, 5}});
  REQUIRE(free);
  CHECK(free->degrees == Approx(-45.0));
  CHECK(distance(free->places[0], {2, 1}) == Approx(distance(places[0], {2, 1})));
}

TEST_CASE("handles lie outside the box, apart from each other, and only where the box has an extent") {
  const HandleFrame frame({{0, 0}, {1, 1}}, 0.01);
  for (std::size_t i = 0; i < kHandles; ++i) {
    const auto handle = static_cast<Handle>(i);
    const Vec2 at = frame.at(handle);
    CHECK((at.x < 0 || at.x > 1 || at.y < 0 || at.y > 1));
    CHECK(frame.handle_at(at, 0.08) == handle);
    for (std::size_t j = 0; j < i; ++j) CHECK(distance(at, frame.at(static_cast<Handle>(j))) > 0.16);
  }
  CHECK_FALSE(frame.handle_at({0.5, 0.5}, 0.08));
  const HandleFrame flat({{0, 2}, {1, 2}}, 0.01);
  CHECK(flat.has(Handle::left));
  CHECK_FALSE(flat.has(Handle::top));
  CHECK_FALSE(flat.has(Handle::upper_left));
  CHECK(flat.has(Handle::turn));
  CHECK_FALSE(flat.handle_at(flat.at(Handle::top), 0.01));
}
