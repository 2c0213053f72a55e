// SPDX-License-Identifier: GPL-3.0-or-later
// The areas that lines enclose, on known shapes and against counting crossings.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "app/store/texts/internal/line_areas.h"
#include "core/base/rng.h"

using namespace mes;

namespace {

using Line = std::vector<Vec2>;

Line square(Vec2 low, double side) {
  return {low, low + Vec2{side, 0}, low + Vec2{side, side}, low + Vec2{0, side}, low};
}

double area_of(const LineAreas& areas) {
  double out = 0.0;
  for (const LineArea& area : areas.areas) {
    CHECK(area_of(area.outer) > 0.0);
    CHECK(area.outer.front() == area.outer.back());
    out += area_of(area.outer);
    for (const Line& hole : area.holes) {
      CHECK(area_of(hole) < 0.0);
      CHECK(hole.front() == hole.back());
      out += area_of(hole);
    }
  }
  return out;
}

/// The ring in pieces, which are listed and directed at random.
void add_in_pieces(const Line& ring, Rng& rng, std::vector<Line>& out) {
  for (std::size_t i = 1; i < ring.size();) {
    const std::size_t end = std::min(ring.size() - 1, i + rng.below(3));
    Line piece(ring.begin() + static_cast<std::ptrdiff_t>(i - 1),
               ring.begin() + static_cast<std::ptrdiff_t>(end + 1));
    if (rng.below(2) == 0) std::ranges::reverse(piece);
    out.insert(out.begin() + static_cast<std::ptrdiff_t>(rng.below(out.size() + 1)), std::move(piece));
    i = end + 1;
  }
}

}  // namespace

TEST_CASE("a ring in a ring is a hole, and one in a hole an area again") {
  const LineAreas areas = areas_of({square({3, 3}, 1), square({0, 0}, 7), square({2, 2}, 3), square({10, 0}, 1)});
  CHECK(areas.left_out == 0);
  REQUIRE(areas.areas.size() == 3);
  CHECK(areas.areas[0].holes.size() == 1);
  CHECK(areas.areas[1].holes.empty());
  CHECK(area_of(areas) == 49.0 - 9.0 + 1.0 + 1.0);
}

TEST_CASE("rings that touch at points are rings of their own") {
  // Two squares with a common corner, from where a line goes around each.
  const LineAreas two =
      areas_of({{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {{1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}}, {{1, 2}, {1, 1}}});
  CHECK(two.areas.size() == 2);
  CHECK(area_of(two) == 2.0);
  // A hole that touches its ring at the leftmost point of both.
  const Line outer{{0, 0}, {4, -3}, {4, 3}, {0, 0}};
  const Line inner{{0, 0}, {3, -1}, {3, 1}, {0, 0}};
  for (const auto& lines : {std::vector{outer, inner}, std::vector{inner, outer}}) {
    const LineAreas touching = areas_of(lines);
    REQUIRE(touching.areas.size() == 1);
    CHECK(touching.areas[0].holes.size() == 1);
    CHECK(area_of(touching) == 12.0 - 3.0);
  }
}

TEST_CASE("lines that enclose nothing are counted and left out") {
  // A tail at a ring, a line alone, a point, and three lines between two points, one of which has a ring beside it.
  std::vector<Line> lines{square({0, 0}, 2), {{2, 2}, {3, 3}}, {{3, 3}, {4, 3}}, {{7, 7}, {8, 8}}, {{5, 5}}};
  lines.insert(lines.end(), {{{20, 0}, {21, 1}, {22, 0}}, {{20, 0}, {22, 0}}, {{20, 0}, {21, -1}, {22, 0}}});
  lines.push_back({{22, 0}, {24, -1}, {24, 1}, {22, 0}});
  const LineAreas areas = areas_of(lines);
  CHECK(areas.left_out == 7);
  CHECK(area_of(areas) == 4.0);
  CHECK(areas_of({}).areas.empty());
  CHECK(areas_of({{{0, 0}, {1, 1}, {0, 0}}}).areas.empty());
}

TEST_CASE("parcels with common borders are an area each, with their holes, and with what fills these") {
  Rng rng(5);
  for (int turn = 0; turn < 60; ++turn) {
    INFO("turn " << turn);
    constexpr std::size_t kSide = 5;
    constexpr double kCell = 100.0;
    // Vertices of a grid; for some turns moved, so that sides are not parallel.
    std::vector<Vec2> grid;
    for (std::size_t i = 0; i <= kSide; ++i)
      for (std::size_t k = 0; k <= kSide; ++k) {
        const auto moved = [&](std::size_t at) {
          return kCell * static_cast<double>(at) + (turn % 3 == 0 ? 0.0 : std::round(rng.uniform(-30, 30)));
        };
        grid.push_back({moved(i), moved(k)});
      }
    std::vector<Line> lines;
    double wanted = 0.0;
    std::size_t count = 0;
    const auto add = [&](Line ring) {
      std::ranges::rotate(ring, ring.begin() + static_cast<std::ptrdiff_t>(rng.below(ring.size())));
      ring.push_back(ring.front());
      if (rng.below(2) == 0) std::ranges::reverse(ring);
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(rng.below(lines.size() + 1)), std::move(ring));
    };
    for (std::size_t i = 0; i < kSide; ++i)
      for (std::size_t k = 0; k < kSide; ++k) {
        const std::size_t at = i * (kSide + 1) + k;
        const Line parcel{grid[at], grid[at + kSide + 1], grid[at + kSide + 2], grid[at + 1]};
        if (rng.below(4) == 0) continue;
        add(parcel);
        ++count;
        wanted += area_of(parcel);
        if (rng.below(3) != 0) continue;
        const Vec2 middle = 0.25 * (parcel[0] + parcel[1] + parcel[2] + parcel[3]);
        Line hole;
        for (const Vec2 p : parcel) hole.push_back(middle + 0.25 * (p - middle));
        add(hole);
        wanted -= area_of(hole);
        if (rng.below(2) != 0) continue;
        add(hole);
        ++count;
        wanted += area_of(hole);
      }
    const LineAreas areas = areas_of(lines);
    CHECK(areas.left_out == 0);
    CHECK(areas.areas.size() == count);
    CHECK(area_of(areas) == Approx(wanted));
  }
}

TEST_CASE("nested rings in random pieces enclose what the even-odd rule says") {
  Rng rng(11);
  for (int turn = 0; turn < 60; ++turn) {
    std::vector<Line> rings;
    // Disjoint groups of concentric polygons.
    for (int group = 0; group < 6; ++group) {
      const Vec2 center{10.0 * group, rng.uniform(-3.0, 3.0)};
      double radius = 4.5;
      while (radius > 0.4) {
        const auto sides = 3 + rng.below(9);
        const double at = rng.uniform(0.0, 6.0);
        Line ring;
        for (std::size_t i = 0; i < sides; ++i) {
          const double angle = at + 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
          ring.push_back(center + radius * Vec2{std::cos(angle), std::sin(angle)});
        }
        ring.push_back(ring.front());
        rings.push_back(ring);
        // Within the inner circle of the triangle.
        radius *= 0.5 * rng.uniform(0.5, 0.99);
      }
    }
    std::vector<Line> pieces;
    for (const Line& ring : rings) add_in_pieces(ring, rng, pieces);
    const LineAreas areas = areas_of(pieces);
    CHECK(areas.left_out == 0);
    area_of(areas);
    const auto is_in = [](const Line& ring, Vec2 p) {
      bool out = false;
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const Vec2 a = ring[i - 1];
        const Vec2 b = ring[i];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) out = !out;
      }
      return out;
    };
    for (int k = 0; k < 50; ++k) {
      const Vec2 p{rng.uniform(-5.0, 55.0), rng.uniform(-8.0, 8.0)};
      bool is_odd = false;
      for (const Line& ring : rings) is_odd = is_odd != is_in(ring, p);
      const auto holds = std::ranges::count_if(areas.areas, [&](const LineArea& area) {
        return is_in(area.outer, p) &&
               std::ranges::none_of(area.holes, [&](const Line& hole) { return is_in(hole, p); });
      });
      CHECK(holds == (is_odd ? 1 : 0));
    }
  }
}
