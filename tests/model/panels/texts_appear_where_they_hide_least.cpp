// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "app/panels/on_canvas/note_room.h"

using namespace mes;

namespace {

bool share_area(const Box2& a, const Box2& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// Counts the marks that a box covers.
NoteRoom room_with(const std::vector<Box2>& marks) {
  return {{{100, 50}, {900, 650}}, [marks](const Box2& box) {
            std::size_t out = 0;
            for (const Box2& mark : marks) out += share_area(mark, box) ? 1U : 0U;
            return out;
          }};
}

}  // namespace

TEST_CASE("a text appears at the first of the places at which it hides least, within its area") {
  const Vec2 size{200, 40};
  const auto place_in = [&](const NoteRoom& room) {
    return least_hiding(room, size, {{0.5F, 1.0F}, {0.0F, 1.0F}, {1.0F, 0.0F}});
  };
  const NoteRoom empty = room_with({});
  CHECK(place_in(empty).corner(empty.area, size) == Vec2{400, 610});
  const Box2 below{{300, 600}, {700, 640}};
  const NoteRoom half = room_with({below});
  CHECK(place_in(half).corner(half.area, size) == Vec2{100, 610});
  const Box2 left{{0, 0}, {290, 650}};
  const NoteRoom most = room_with({below, left});
  CHECK(place_in(most).corner(most.area, size) == Vec2{700, 50});
  // Where nothing is free the fewest marks decide, and then the order.
  const Box2 right{{710, 0}, {900, 90}};
  const NoteRoom full = room_with({below, left, right});
  CHECK(place_in(full).corner(full.area, size) == Vec2{400, 610});
}
