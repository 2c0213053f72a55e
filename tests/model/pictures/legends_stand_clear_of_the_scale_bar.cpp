// SPDX-License-Identifier: GPL-3.0-or-later
// One rule says where legends stand: clear of the scale bar wherever there is room, in the corner that hides least.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/legend_place.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/picture/shapes_below.h"
#include "core/base/rng.h"
#include "tests/model/pictures/letters_of_one_width.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/workbench.h"

using namespace mes;

namespace {

std::vector<LegendEntry> key_of(std::size_t layers) {
  std::vector<LegendEntry> out;
  for (std::size_t i = 0; i < layers; ++i)
    out.push_back({"Layer number " + std::string(1 + i % 7, 'x'), {}, nullptr, {}, {PrimitiveKind::segment, {}}});
  return out;
}

Box2 box_of(const PlacedLegend& legend) {
  return {legend.corner, legend.corner + legend.shrink * Vec2{legend.drawing.width, legend.drawing.height}};
}

bool share_area(const Box2& a, const Box2& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool is_within(const Box2& box, const Box2& room) {
  return room.low.x <= box.low.x && box.high.x <= room.high.x && room.low.y <= box.low.y && box.high.y <= room.high.y;
}

/// Somewhere on a grid of the room a box of this size is clear of the bar by `apart`.
bool has_place(Vec2 size, const Box2& room, const Box2& bar, double apart) {
  for (double x = room.low.x; x + size.x <= room.high.x; x += 1.0)
    for (double y = room.low.y; y + size.y <= room.high.y; y += 1.0)
      if (!share_area({{x - apart, y - apart}, {x + size.x + apart, y + size.y + apart}}, bar)) return true;
  return false;
}

MarksPlace marks_of(const ScaleMarks& marks, double width, double height, double units_per_pixel = 0.01) {
  return place_of_marks(marks, {.units_per_pixel = units_per_pixel, .width = width, .height = height},
                        test::half_size_a_byte);
}

PaperCorner corner(std::uint64_t i) {
  return static_cast<PaperCorner>(i % 4);
}

}  // namespace

TEST_CASE("no legend overlaps the scale bar, and one is left out only where not even a layer has room") {
  Rng rng(36);
  int left_out = 0;
  int shortened = 0;
  for (int round = 0; round < 3000; ++round) {
    const double width = rng.uniform(60.0, 900.0);
    const double height = rng.uniform(30.0, 700.0);
    ScaleMarks marks{.bar = true, .axes = rng.below(2) == 0};
    if (rng.below(2) == 0) marks.bar_at = PaperPlace{corner(rng.below(4)), {rng.uniform(0, 40), rng.uniform(0, 40)}};
    const MarksPlace at = marks_of(marks, width, height, rng.uniform(0.001, 10.0));
    REQUIRE(at.bar.has_value());
    LegendSurroundings around{.room = at.room, .bar = at.longest_bar};
    if (rng.below(2) == 0) around.place = PaperPlace{corner(rng.below(4)), {rng.uniform(0, 60), rng.uniform(0, 60)}};
    const std::vector<LegendEntry> entries = key_of(1 + rng.below(25));
    const double shrink = rng.uniform(0.7, 1.0);
    const PlacedLegend legend = place_legend(entries, test::half_size_a_byte, shrink, around, kWhiteCanvas);
    CAPTURE(width, height, entries.size(), around.place.has_value());
    CHECK(legend.lacks_room == legend.drawing.is_empty());
    if (legend.lacks_room) {
      ++left_out;
      const PaperDrawing least = layout_legend(entries, test::half_size_a_byte, 0.0, kWhiteCanvas);
      CHECK_FALSE(has_place(shrink * Vec2{least.width, least.height}, at.room, *at.longest_bar, 8.0));
      continue;
    }
    CHECK_FALSE(share_area(box_of(legend), *at.longest_bar));
    CHECK_FALSE(share_area(box_of(legend), *at.bar));
    CHECK(is_within(box_of(legend), at.room));
    shortened += legend.drawing.lines.back().text.starts_with("and ") ? 1 : 0;
  }
  CHECK(left_out > 50);
  CHECK(left_out < 2000);
  CHECK(shortened > 100);
}

TEST_CASE("a legend that takes too large a share of the room is left out, and no other one") {
  const std::vector<LegendEntry> entries = key_of(4);
  const PlacedLegend whole =
      place_legend(entries, test::half_size_a_byte, 1.0, {.room = {{}, {900, 700}}}, kWhiteCanvas);
  const Vec2 size = whole.size();
  // Rooms of the legend's width and twice that, with a height from one to eight times its own.
  for (const double wide : {1.2, 2.0})
    for (double high = 1.2; high < 8.0; high += 0.4) {
      const LegendSurroundings around{.room = {{}, {wide * size.x, high * size.y}}, .most_of_room = 0.25};
      const PlacedLegend legend = place_legend(entries, test::half_size_a_byte, 1.0, around, kWhiteCanvas);
      INFO(wide << " x " << high);
      CHECK(legend.lacks_room == (wide * high < 4.0));
      CHECK(legend.drawing.is_empty() == legend.lacks_room);
    }
}

TEST_CASE("where nothing is known of the drawing, the legend is in the lower right corner, at every zoom the same") {
  const std::vector<LegendEntry> entries = key_of(4);
  const PlacedLegend first =
      place_legend(entries, test::half_size_a_byte, 1.0, {.room = {{0, 0}, {800, 600}}}, kWhiteCanvas);
  CHECK(box_of(first).high.x == Approx(800 - kUsualMarginPx));
  CHECK(box_of(first).high.y == Approx(600 - kUsualMarginPx));
  Rng rng(4);
  for (const double width : {800.0, 330.0, 250.0, 200.0}) {
    for (const auto& bar_at :
         {std::optional<PaperPlace>(), std::optional(PaperPlace{PaperCorner::bottom_right, {3, 3}})}) {
      std::optional<Vec2> there;
      for (int i = 0; i < 50; ++i) {
        const MarksPlace at =
            marks_of({.bar = true, .bar_at = bar_at}, width, 400.0, std::pow(10.0, rng.uniform(-3.0, 3.0)));
        const PlacedLegend legend = place_legend(entries, test::half_size_a_byte, 1.0,
                                                 {.room = at.room, .bar = at.longest_bar}, kWhiteCanvas);
        REQUIRE_FALSE(legend.lacks_room);
        if (!there) there = legend.corner;
        // The number of the bar may be wider than the bar, and letters move nothing.
        CHECK(legend.corner.x == there->x);
        CHECK(legend.corner.y == there->y);
      }
    }
  }
}

TEST_CASE("of the corners it takes the one that hides least, without words if it can") {
  const std::vector<LegendEntry> entries = key_of(3);
  const Box2 room{{0, 20}, {800, 600}};
  const auto with = [&](LegendSurroundings around) {
    around.room = room;
    return box_of(place_legend(entries, test::half_size_a_byte, 1.0, around, kWhiteCanvas)).center();
  };
  const auto is_at = [&](Vec2 center, bool is_right, bool is_bottom) {
    return (center.x > 400) == is_right && (center.y > 310) == is_bottom;
  };
  for (const bool is_right : {false, true})
    for (const bool is_bottom : {false, true})
      CHECK(is_at(with({.hides = [&](const Box2& box) -> std::size_t {
                    return is_at(box.center(), is_right, is_bottom) ? 3 : 4;
                  }}),
                  is_right, is_bottom));
  const std::vector<Box2> words{{}, {{700, 560}, {760, 580}}, {{20, 560}, {60, 580}}};
  CHECK(is_at(with({.words = words}), true, false));
  CHECK(is_at(with({.words = words, .hides = [](const Box2& box) -> std::size_t { return box.low.y < 100 ? 9 : 0; }}),
              true, false));
  // A place that was given holds, whatever is there.
  const PaperPlace place{PaperCorner::bottom_left, {1, 1}};
  CHECK(is_at(with({.place = place, .words = words}), false, true));
}

TEST_CASE("a place that is the scale bar's is next to it") {
  const MarksPlace at = marks_of({.bar = true}, 800.0, 600.0);
  const auto legend =
      place_legend(key_of(3), test::half_size_a_byte, 1.0,
                   {.room = at.room, .bar = at.longest_bar, .place = PaperPlace{.corner = PaperCorner::bottom_left}},
                   kWhiteCanvas);
  CHECK(legend.corner.x == Approx(kUsualMarginPx));
  CHECK(box_of(legend).high.y < at.longest_bar->low.y);
  CHECK(box_of(legend).high.y > at.longest_bar->low.y - 10.0);
}

TEST_CASE("what lies below a box is counted primitive by primitive") {
  test::TestBench bench(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 3}});
  const auto count = [&](const char* layer, const Box2& box) {
    const VariantLayer index = find_layer(layer);
    return shapes_below(bench.mirror(), {&index, 1}, box);
  };
  // A triangle with a right angle, whose circle is about (2, 1.5) with the radius 2.5.
  CHECK(count("points", {{-1, -1}, {5, 5}}) == 3);
  CHECK(count("points", {{-1, -1}, {3, 5}}) == 1);
  CHECK(count("delaunay", {{1, 0.1}, {1.1, 0.2}}) == 0);
  CHECK(count("delaunay", {{1, -0.1}, {1.1, 0.1}}) == 1);
  CHECK(count("delaunay", {{3.5, -0.5}, {4.5, 0.5}}) == 2);
  // Its Voronoi diagram is three rays from the centre.
  CHECK(count("voronoi", {{1.9, 1.4}, {2.1, 1.6}}) == 3);
  CHECK(count("voronoi", {{1.9, -50}, {2.1, -40}}) == 1);
  CHECK(count("voronoi", {{40, 1.4}, {50, 1.6}}) == 1);
  CHECK(count("voronoi", {{-50, 1.4}, {-40, 1.6}}) == 0);
  // A circle counts where its line is, and a disk also inside.
  bench.load({.balls = {{{2, 1.5}, 2.5}}});
  for (const Box2& inside : {Box2{{1.9, 1.4}, {2.1, 1.6}}, Box2{{3.5, 2}, {3.6, 2.1}}}) {
    CHECK(count("b-inner-circles", inside) == 0);
    CHECK(count("b-inner-disks", inside) == 1);
  }
  for (const char* layer : {"b-inner-circles", "b-inner-disks"}) {
    CHECK(count(layer, {{4.4, 1.4}, {4.6, 1.6}}) == 1);
    CHECK(count(layer, {{-9, -9}, {9, 9}}) == 1);
    CHECK(count(layer, {{4, 3.5}, {5, 4}}) == 0);  // in the box around it
  }
  // Its boundary is arcs that are all of the circle.
  CHECK(count("b-union-boundary", {{1.9, 1.4}, {2.1, 1.6}}) == 0);
  CHECK(count("b-union-boundary", {{4.4, 1.4}, {4.6, 1.6}}) >= 1);
}

TEST_CASE("a scale bar without a position stands where it hides least, and the legend clear of it") {
  const SeenPlane plane{.units_per_pixel = 1.0, .width = 400.0, .height = 300.0};
  // The drawing fills all but one corner.
  for (const PaperCorner free :
       {PaperCorner::bottom_left, PaperCorner::bottom_right, PaperCorner::top_left, PaperCorner::top_right}) {
    const bool is_right = free == PaperCorner::bottom_right || free == PaperCorner::top_right;
    const bool is_low = free == PaperCorner::bottom_left || free == PaperCorner::bottom_right;
    LegendSurroundings around;
    around.hides = [&](const Box2& box) -> std::size_t {
      const bool is_free =
          (is_right ? box.low.x > 200.0 : box.high.x < 200.0) && (is_low ? box.low.y > 150.0 : box.high.y < 150.0);
      return is_free ? 0 : 1;
    };
    const auto hides = [&](const Box2& box) { return around.cost_of(box); };
    const ScaleMarks marks = with_free_bar({.bar = true}, plane, test::half_size_a_byte, hides);
    const MarksPlace at = place_of_marks(marks, plane, test::half_size_a_byte);
    REQUIRE(at.longest_bar);
    CHECK(around.hides(*at.longest_bar) == 0);
    around.room = at.room;
    around.bar = at.longest_bar;
    const PlacedLegend legend = place_legend(key_of(3), test::half_size_a_byte, 1.0, around, kWhiteCanvas);
    CHECK_FALSE(share_area(box_of(legend), *at.longest_bar));
  }
  // A position that was given stays, and so does the usual one where all are equal.
  const auto covers_all = [](const Box2&) { return std::pair<std::size_t, std::size_t>(1, 1); };
  CHECK_FALSE(with_free_bar({.bar = true}, plane, test::half_size_a_byte, covers_all).bar_at);
  const PaperPlace given{PaperCorner::top_right, {3.0, 4.0}};
  CHECK(with_free_bar({.bar = true, .bar_at = given}, plane, test::half_size_a_byte, covers_all).bar_at == given);
}

TEST_CASE(
    "a strip for the legend is taken only where it hides much less, at the edge that leaves the drawing larger") {
  using Cost = std::pair<std::size_t, std::size_t>;
  const auto strip_with = [&](Cost corner, Cost below, Cost right, double below_shrinks, double right_shrinks) {
    return strip_for_legend([&](const LegendStrip& strip) {
      LegendTrial out{
          {.drawing = layout_legend(key_of(3), test::half_size_a_byte, 1e9, kWhiteCanvas)}, 800.0, 600.0, 1.0};
      out.legend.hides = strip.is_empty() ? corner : strip.below > 0.0 ? below : right;
      if (!strip.is_empty()) out.units_per_pixel = strip.below > 0.0 ? below_shrinks : right_shrinks;
      return out;
    });
  };
  CHECK(strip_with({0, 0}, {0, 0}, {0, 0}, 1.0, 1.0).is_empty());
  CHECK(strip_with({0, 3}, {0, 1}, {0, 2}, 1.0, 1.0).is_empty());
  CHECK(strip_with({0, 9}, {1, 0}, {0, 3}, 1.0, 1.0).is_empty());
  CHECK(strip_with({0, 4}, {0, 1}, {0, 2}, 2.0, 1.0).below > 0.0);
  CHECK(strip_with({1, 0}, {0, 7}, {1, 0}, 2.0, 1.0).below > 0.0);
  CHECK(strip_with({0, 4}, {0, 0}, {0, 1}, 1.5, 1.2).right > 0.0);
  CHECK(strip_with({0, 4}, {0, 1}, {0, 0}, 1.2, 1.2).below > 0.0);
}

TEST_CASE("a wide legend has all layers in as few rows as the width permits") {
  const std::vector<LegendEntry> entries = key_of(7);
  const auto rows_of = [](const PaperDrawing& drawing) {
    std::vector<double> tops;
    for (const PaperDrawing::Line& line : drawing.lines) tops.push_back(line.top);
    std::ranges::sort(tops);
    return std::ranges::unique(tops).begin() - tops.begin();
  };
  std::ptrdiff_t before = 8;
  for (double width = 50.0; width < 1500.0; width += 10.0) {
    const PaperDrawing drawing = layout_wide_legend(entries, test::half_size_a_byte, width, kWhiteCanvas);
    CHECK(drawing.lines.size() == entries.size());
    const std::ptrdiff_t rows = rows_of(drawing);
    CHECK(rows <= before);
    if (rows < 7) CHECK(drawing.width <= width);
    before = rows;
  }
  CHECK(before == 1);
  CHECK(layout_wide_legend({}, test::half_size_a_byte, 100.0, kWhiteCanvas).is_empty());
}
