// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/rng.h"
#include "core/structures/delaunay/voronoi_cells.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using Ring = std::vector<Vec2>;

Box2 box_around(const std::vector<Vec2>& points) {
  Box2 out;
  for (const Vec2 p : points) out.add(p);
  const double room =
      0.25 * std::max({out.width(), out.height(), std::abs(out.high.x), std::abs(out.high.y), 1e-200});
  return {out.low - Vec2{room, room}, out.high + Vec2{room, room}};
}

/// Relative to the first corner, so that far cells lose nothing.
double area_of(const Ring& ring, double unit) {
  double out = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    out += cross((1.0 / unit) * (ring[i] - ring[0]), (1.0 / unit) * (ring[(i + 1) % ring.size()] - ring[0]));
  return 0.5 * out;
}

std::map<SiteSlot, Ring> cells_of(const Delaunay& delaunay, const Box2& box) {
  const VoronoiCells cells(delaunay);
  std::map<SiteSlot, Ring> out;
  for (const SiteSlot site : delaunay.site_slots())
    if (delaunay.is_site(site)) out[site] = cells.cell(site, box);
  return out;
}

/// Each side within the box is that of one other cell, in the opposite direction.
void check_neighbors(const std::map<SiteSlot, Ring>& cells, const Box2& box) {
  std::map<std::array<double, 4>, int> sides;
  for (const auto& [site, ring] : cells) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i];
      const Vec2 b = ring[(i + 1) % ring.size()];
      const bool is_of_box = (a.x == b.x && (a.x == box.low.x || a.x == box.high.x)) ||
                             (a.y == b.y && (a.y == box.low.y || a.y == box.high.y));
      if (is_of_box) continue;
      ++sides[{a.x, a.y, b.x, b.y}];
      --sides[{b.x, b.y, a.x, a.y}];
    }
  }
  CHECK(std::ranges::count_if(sides, [](const auto& side) { return side.second != 0; }) == 0);
}

/// The least distance within the ring from its sides, in units; negative outside.
double depth_in(const Ring& ring, Vec2 place, double unit) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 side = (1.0 / unit) * (ring[(i + 1) % ring.size()] - ring[i]);
    if (length(side) > 1e-9) out = std::min(out, cross(side, (1.0 / unit) * (place - ring[i])) / length(side));
  }
  return out;
}

void check_cells(const std::vector<Vec2>& points) {
  const ComparedBench bench(points);
  const auto& delaunay = bench.get<Delaunay>();
  const Box2 box = box_around(points);
  const double unit = std::max(box.width(), box.height());
  const auto cells = cells_of(delaunay, box);
  REQUIRE(cells.size() == delaunay.site_count());
  double sum = 0.0;
  for (const auto& [site, ring] : cells) {
    REQUIRE(ring.size() >= 3);
    CHECK(std::ranges::all_of(ring, [&](Vec2 p) { return box.contains(p); }));
    sum += area_of(ring, unit);
  }
  CHECK(sum == Approx(box.width() / unit * (box.height() / unit)).epsilon(1e-9));
  check_neighbors(cells, box);
  // A place lies in the cell of its nearest site.
  Rng rng(7);
  for (int i = 0; i < 50; ++i) {
    const Vec2 place{rng.uniform(box.low.x, box.high.x), rng.uniform(box.low.y, box.high.y)};
    const auto far = [&](SiteSlot site) { return length((1.0 / unit) * (delaunay.site_position(site) - place)); };
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [site, ring] : cells) least = std::min(least, far(site));
    // Each of several sites at nearly the same distance may be the nearest.
    CHECK(std::ranges::any_of(cells, [&](const auto& cell) {
      return far(cell.first) <= (1.0 + 1e-12) * least && depth_in(cell.second, place, unit) > -1e-7;
    }));
  }
}

}  // namespace

TEST_CASE("Voronoi cells cover the box without gaps, each around the places that are nearest to its site") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    if (input.positions.empty()) continue;
    INFO(input.name);
    check_cells(input.positions);
  }
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    INFO(seed);
    Rng rng(seed);
    std::vector<Vec2> points;
    // Rounded to a coarse grid some are equal, on a line or on a circle with others.
    const double grid = seed % 4 == 0 ? 0.0 : std::ldexp(1.0, -static_cast<int>(seed % 4) - 1);
    for (std::uint64_t i = 0; i < 1 + seed; ++i) {
      const Vec2 p{rng.uniform(), rng.uniform()};
      points.push_back(grid == 0.0 ? p : Vec2{grid * std::round(p.x / grid), grid * std::round(p.y / grid)});
    }
    check_cells(points);
  }
}

TEST_CASE("the Voronoi cells of a lattice are its squares") {
  const ComparedBench bench(integer_lattice(4).positions);
  const auto& delaunay = bench.get<Delaunay>();
  for (const auto& [site, ring] : cells_of(delaunay, {{-0.5, -0.5}, {3.5, 3.5}})) {
    CHECK(ring.size() == 4);
    CHECK(area_of(ring, 1.0) == Approx(1.0));
    for (const Vec2 corner : ring) CHECK(length(corner - delaunay.site_position(site)) == Approx(std::sqrt(0.5)));
  }
}
