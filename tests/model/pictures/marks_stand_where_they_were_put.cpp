// SPDX-License-Identifier: GPL-3.0-or-later
// Places of the legend and the scale bar: the same corner and the same distance from it on pages of every size.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "app/picture/paper/scale_drawing.h"
#include "app/settings/paper_place.h"
#include "core/base/rng.h"
#include "tests/model/pictures/letters_of_one_width.h"

using namespace mes;
using mes::test::six_px_a_byte;

namespace {

constexpr Box2 kPage{{0, 0}, {800, 600}};
constexpr double kMm = kMillimetersPerPixel;

bool is_near(Vec2 a, Vec2 b) {
  return length(a - b) < 1e-9;
}

}  // namespace

TEST_CASE("what is placed is that far from its corner, on each page") {
  const Vec2 size{100, 50};
  for (const Vec2 page : {Vec2{800, 600}, Vec2{300, 900}}) {
    const Box2 room{{0, 20}, page};
    const Vec2 mm{10 * kMm, 7 * kMm};
    CHECK(is_near(placed({PaperCorner::top_left, mm}, size, room), {10, 27}));
    CHECK(is_near(placed({PaperCorner::top_right, mm}, size, room), {page.x - 110, 27}));
    CHECK(is_near(placed({PaperCorner::bottom_left, mm}, size, room), {10, page.y - 57}));
    CHECK(is_near(placed({PaperCorner::bottom_right, mm}, size, room), {page.x - 110, page.y - 57}));
  }
  // An inch has 96 logical pixels.
  CHECK(is_near(placed({PaperCorner::top_left, {25.4, 50.8}}, size, kPage), {96, 192}));
}

TEST_CASE("what is dropped somewhere stays there, in the room and nowhere else") {
  Rng rng(7);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 size{rng.uniform(1, 400), rng.uniform(1, 300)};
    const Vec2 at{rng.uniform(0, 800 - size.x), rng.uniform(0, 600 - size.y)};
    const PaperPlace place = place_of(at, size, kPage);
    CAPTURE(at.x, at.y, size.x, size.y, to_text(place));
    CHECK(length(placed(place, size, kPage) - at) < 1e-9);
    // Of the four corners it has the nearest.
    const bool is_right = at.x + 0.5 * size.x > 400;
    const bool is_bottom = at.y + 0.5 * size.y > 300;
    CHECK((place.corner == PaperCorner::top_right || place.corner == PaperCorner::bottom_right) == is_right);
    CHECK((place.corner == PaperCorner::bottom_left || place.corner == PaperCorner::bottom_right) == is_bottom);
    // Dragged beyond the edges, or put on a page of any size, it is all on the page.
    const Vec2 beyond{rng.uniform(-900, 900), rng.uniform(-900, 900)};
    const Box2 page{{0, 0}, {rng.uniform(400, 2000), rng.uniform(300, 2000)}};
    const Vec2 there = placed(place_of(beyond, size, kPage), size, page);
    CHECK((there.x >= 0 && there.y >= 0));
    CHECK((there.x + size.x <= page.high.x + 1e-9 && there.y + size.y <= page.high.y + 1e-9));
  }
  // Larger than the page: its beginning is seen.
  CHECK(placed({PaperCorner::bottom_right, {5, 5}}, {900, 50}, kPage).x == 0.0);
}

TEST_CASE("near the usual margin it takes that, along each side alone") {
  const Vec2 size{100, 50};
  const PaperPlace near = place_of({kUsualMarginPx + 5, 600 - 50 - kUsualMarginPx + 7}, size, kPage, 8.0);
  CHECK(near == PaperPlace{.corner = PaperCorner::bottom_left});
  CHECK(is_near(placed(near, size, kPage), {kUsualMarginPx, 600 - 50 - kUsualMarginPx}));
  const PaperPlace along = place_of({300, kUsualMarginPx - 7}, size, kPage, 8.0);
  CHECK(along.corner == PaperCorner::top_left);
  CHECK(along.mm.x == Approx(300 * kMm));
  CHECK(along.mm.y == PaperPlace{}.mm.y);
  CHECK(place_of({kUsualMarginPx + 9, 100}, size, kPage, 8.0).mm.x == Approx((kUsualMarginPx + 9) * kMm));
}

TEST_CASE("places are read as they are written, and nothing else is") {
  CHECK(parse_place("top-left") == PaperPlace{.corner = PaperCorner::top_left});
  CHECK(parse_place("bottom-right:5,7.5") == PaperPlace{PaperCorner::bottom_right, {5, 7.5}});
  CHECK(parse_place("top-right:0,0") == PaperPlace{PaperCorner::top_right, {0, 0}});
  Rng rng(8);
  for (int i = 0; i < 200; ++i) {
    const PaperPlace place{static_cast<PaperCorner>(rng.below(4)), {rng.uniform(0, 5080), rng.uniform(0, 5080)}};
    CHECK(parse_place(to_text(place)) == place);
  }
  CHECK(parse_place(to_text(PaperPlace{})) == PaperPlace{});
  for (const char* text :
       {"", "left", "top", "top-left:", "top-left:5", "top-left:5,", "top-left:5,5,5", "top-left:-1,5",
        "top-left:5,5081", "top-left:nan,5", "Top-Left", "top-left 5,5", "top-left:5mm,5mm", ":5,5"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_place(text));
  }
}

TEST_CASE("a scale bar with a place is there, apart from axes, title and caption") {
  const SeenPlane plane{.units_per_pixel = 0.01, .width = 800, .height = 600, .covered = 30, .covered_above = 40};
  const auto bar = [&](const ScaleMarks& marks) {
    const MarksPlace out = place_of_marks(marks, plane, six_px_a_byte);
    REQUIRE(out.bar.has_value());
    // The line is where the place says: the drawing has a box that ends at its foot.
    const PaperDrawing drawing = layout_scale_marks(marks, plane, six_px_a_byte, Rgb{255, 255, 255});
    CHECK(std::ranges::any_of(drawing.boxes, [&](const PaperDrawing::Box& box) {
      return box.height == 2.0 && box.left == Approx(out.bar->low.x) && box.top + 2.0 == Approx(out.bar->high.y);
    }));
    return *out.bar;
  };
  const Box2 own = bar({.bar = true});
  CHECK(is_near(own.low, bar({.bar = true, .bar_at = PaperPlace{PaperCorner::bottom_left}}).low));
  CHECK(own.high.y == Approx(600 - 30 - kUsualMarginPx));
  const Vec2 mm{10 * kMm, 5 * kMm};
  const Box2 above = bar({.bar = true, .bar_at = PaperPlace{PaperCorner::top_right, mm}});
  CHECK(is_near({above.high.x, above.low.y}, {790, 45}));
  const Box2 beside = bar({.bar = true, .axes = true, .bar_at = PaperPlace{PaperCorner::bottom_left, mm}});
  CHECK(beside.high.y == Approx(600 - 30 - kAxisRoom - 5));
  CHECK(beside.low.x > 10 + 6);  // the numbers of the axis
  const MarksPlace none = place_of_marks({.axes = true}, plane, six_px_a_byte);
  CHECK_FALSE(none.bar.has_value());
  CHECK(none.room.low.x > 6);
}
