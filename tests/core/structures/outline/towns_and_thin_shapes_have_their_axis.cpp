// SPDX-License-Identifier: GPL-3.0-or-later
// The exact axis of a town, part by part, and of thin shapes far from the origin, as on a map.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "core/structures/outline/internal/outline_parts.h"
#include "core/structures/outline/internal/segment_voronoi.h"
#include "core/structures/outline/outline_sides.h"
#include "tests/core/structures/outline/outline_bench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// A town: polygons in a grid of 4 x 4 cells. Some have courtyards with polygons in them, some have a neighbour with a
/// common side or a common corner, or an open line in them, and some cross the next one.
std::vector<Ring> town(Rng& rng, std::vector<Ring>& open) {
  constexpr double kCell = 4096.0;
  std::vector<Ring> out;
  const auto moved = [](Ring ring, Vec2 by) {
    for (Vec2& p : ring) p = p + by;
    return ring;
  };
  for (int i = 0; i < 16; ++i) {
    const Vec2 middle{kCell * (i % 4), kCell * (i / 4)};
    const std::size_t kind = rng.below(6);
    const Ring& house = out.emplace_back(moved(star_polygon(rng, 5 + rng.below(9), 900.0, 1500.0), middle));
    const Vec2 a = house[0];
    const Vec2 b = house[1];
    if (kind == 0) out.push_back({b, a, a + 0.25 * (a - middle)});
    if (kind == 1) out.push_back({a, a + Vec2{200, 50}, a + Vec2{150, 250}});
    if (kind == 2) open.push_back({middle, middle + Vec2{100, 40}, middle + Vec2{60, 200}});
    if (kind == 3) out.push_back(moved(star_polygon(rng, 9, 900.0, 1500.0), middle + Vec2{700, 0}));
    if (kind < 4) continue;
    out.push_back(moved(star_polygon(rng, 8, 300.0, 400.0), middle));
    for (const double x : {-60.0, 60.0}) out.push_back(moved(star_polygon(rng, 5, 20.0, 50.0), middle + Vec2{x, 0}));
  }
  return out;
}

/// Edges as the positions of their features and nodes.
using PlainEdge = std::array<double, 14>;
std::vector<PlainEdge> edges_of(const OutlineGraph& graph) {
  std::vector<PlainEdge> out;
  for (const OutlineEdge& edge : graph.edges) {
    PlainEdge& plain = out.emplace_back();
    std::size_t k = 0;
    const auto add = [&](Vec2 p) {
      plain[k++] = p.x;
      plain[k++] = p.y;
    };
    for (const OutlineFeatureSlot slot : edge.features)
      for (const Vec2 p : {graph.features[slot].from, graph.features[slot].to}) add(p);
    for (const OutlineNodeSlot slot : edge.nodes) {
      add(graph.nodes[slot].center);
      plain[k++] = graph.nodes[slot].radius;
    }
  }
  std::ranges::sort(out);
  return out;
}

}  // namespace

TEST_CASE("the axes of the parts of a town are the axis of the town") {
  Rng rng(11);
  std::size_t parts = 0;
  std::size_t regions = 0;
  for (int round = 0; round < 40; ++round) {
    INFO("round " << round);
    std::vector<Ring> open;
    const std::vector<Ring> closed = town(rng, open);
    OutlineSides sides;
    for (const auto& [rings, is_closed] : {std::pair{&closed, true}, {&open, false}})
      for (const Ring& ring : *rings)
        for (std::size_t i = 0; i + (is_closed ? 0 : 1) < ring.size(); ++i)
          sides.add(ring[i], ring[(i + 1) % ring.size()], is_closed);
    JobControl job;
    const std::vector<OutlineSide> all = sides.take(job);
    const OutlineGraph whole = inner_voronoi(all, 0.0, job);
    std::vector<PlainEdge> together;
    std::uint32_t own_regions = 0;
    std::size_t own_sides = 0;
    for (const std::vector<OutlineSide>& part : independent_parts(all)) {
      const OutlineGraph graph = inner_voronoi(part, 0.0, job);
      for (const PlainEdge& edge : edges_of(graph)) together.push_back(edge);
      own_regions += graph.regions;
      own_sides += part.size();
      ++parts;
    }
    std::ranges::sort(together);
    const std::vector<PlainEdge> wanted = edges_of(whole);
    REQUIRE(together.size() == wanted.size());
    CHECK(own_regions == whole.regions);
    CHECK(own_sides == all.size());
    regions += whole.regions;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      for (std::size_t k = 0; k < wanted[i].size(); ++k)
        REQUIRE(std::abs(together[i][k] - wanted[i][k]) <= (k < 8 ? 0.0 : 1e-6));
  }
  CHECK(parts > 40 * 16);
  CHECK(regions > parts);
}

TEST_CASE("the axis of a town that is edited is that of the town as it is now, to the last bit") {
  Rng rng(12);
  std::vector<Ring> open;
  TestBench bench;
  bench.show({"outline-axis"});
  bench.load(data_of_rings(town(rng, open)));
  for (int round = 0; round < 60; ++round) {
    INFO("round " << round);
    const SampleId id = bench.ids()[rng.below(bench.ids().size())];
    const Vec2 at = bench.document().position(bench.document().slot_of(id));
    if (round % 6 == 5)
      bench.undo();
    else if (round % 6 == 4)
      bench.remove({id});
    else
      bench.move(id, at + Vec2{std::round(rng.uniform(-300, 300)), std::round(rng.uniform(-300, 300))});
    TestBench fresh;
    fresh.show({"outline-axis"});
    fresh.load(data_of(bench.document()));
    const OutlineGraph& graph = bench.get<OutlineAxis>().graph();
    const OutlineGraph& other = fresh.get<OutlineAxis>().graph();
    REQUIRE(edges_of(graph) == edges_of(other));
    CHECK(graph.regions == other.regions);
    CHECK(graph.nodes.size() == other.nodes.size());
    CHECK(pieces_of(bench.get<OutlineAxis>(), 1.0) == pieces_of(fresh.get<OutlineAxis>(), 1.0));
  }
}

TEST_CASE("a thin shape far from the origin has the axis that it has there") {
  Rng rng(13);
  const Vec2 far{3'500'000.0, 5'500'000.0};
  constexpr double kGrid = 0x1p-18;  // far away, too, its multiples are doubles
  const auto on_grid = [&](Vec2 p) { return Vec2{kGrid * std::round(p.x / kGrid), kGrid * std::round(p.y / kGrid)}; };
  for (int round = 0; round < 300; ++round) {
    INFO("round " << round);
    const double angle = round % 3 == 0 ? 0.0 : rng.uniform(0.0, 6.28);
    const Vec2 along{std::cos(angle), std::sin(angle)};
    const double size = rng.uniform(20.0, 300.0);
    const double width = std::ldexp(0.01, static_cast<int>(rng.below(9)));
    Ring near;
    for (const Vec2 p :
         {Vec2{0, 0}, {0.4 * size, -0.3 * width}, {size, 0}, {size, width}, {0.7 * size, 1.2 * width}, {0, width}})
      near.push_back(on_grid(p.x * along + p.y * perpendicular(along)));
    Ring moved_away = near;
    for (Vec2& p : moved_away) p = p + far;
    const AxisBench here(data_of_rings({near}));
    const AxisBench there(data_of_rings({moved_away}));
    const OutlineGraph& graph = here.axis().graph();
    const OutlineGraph& other = there.axis().graph();
    REQUIRE(graph.nodes.size() == other.nodes.size());
    REQUIRE(graph.edges.size() == other.edges.size());
    for (const OutlineNodeSlot node : graph.nodes.rows()) {
      const double nearest = [&] {
        double least = distance(graph.nodes[node].center, other.nodes[OutlineNodeSlot(0)].center - far);
        for (const OutlineNodeSlot one : other.nodes.rows())
          least = std::min(least, distance(graph.nodes[node].center, other.nodes[one].center - far));
        return least;
      }();
      CHECK(nearest < 4e-9);  // the coordinates there are multiples of 1e-9
      CHECK(graph.nodes[node].radius < 0.76 * width);
    }
    double most = 0.0;
    double most_there = 0.0;
    for (const OutlineNode& node : graph.nodes) most = std::max(most, node.radius);
    for (const OutlineNode& node : other.nodes) most_there = std::max(most_there, node.radius);
    CHECK(most_there == Approx(most).epsilon(1e-9));
  }
}
