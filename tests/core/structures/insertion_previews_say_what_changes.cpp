// SPDX-License-Identifier: GPL-3.0-or-later
// What an insertion is said to change is what it changes, judged by the tables before and after.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/base/rng.h"
#include "core/structures/crust/one_step_crust.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

std::set<PlaceEdge> delaunay_edges(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  std::set<PlaceEdge> out;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(edge);
    if (row.is_alive()) out.insert(place_edge(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1])));
  }
  return out;
}

std::set<PlaceEdge> segments_of(const Provenance& answer, ProvenanceRole role, bool is_heavy) {
  std::set<PlaceEdge> out;
  for (const ProvenanceLine& line : answer.lines)
    if (line.role == role && line.is_heavy == is_heavy)
      for (const ProvenanceShape& shape : line.shapes)
        if (shape.kind == PrimitiveKind::segment)
          out.insert(place_edge({shape.values[0], shape.values[1]}, {shape.values[2], shape.values[3]}));
  return out;
}

std::size_t shapes_of(const Provenance& answer, ProvenanceRole role, PrimitiveKind kind) {
  std::size_t out = 0;
  for (const ProvenanceLine& line : answer.lines)
    if (line.role == role)
      for (const ProvenanceShape& shape : line.shapes) out += shape.kind == kind ? 1U : 0U;
  return out;
}

std::set<PlaceEdge> only_in(const std::set<PlaceEdge>& a, const std::set<PlaceEdge>& b) {
  std::set<PlaceEdge> out;
  std::ranges::set_difference(a, b, std::inserter(out, out.end()));
  return out;
}

Provenance preview(TestBench& bench, Vec2 at) {
  ProvenanceQuestion question;
  question.at = at;
  question.wish = ProvenanceWish::insertion;
  return bench.ask(std::move(question));
}

}  // namespace

TEST_CASE("an insertion changes what its preview says") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng(seed);
    // In general position, far from the origin, or on a curve, with places inside and outside of the hull.
    const double scale = seed % 3 == 0 ? 1e-30 : 1.0;
    const Vec2 shift = seed % 3 == 1 ? Vec2{1e6, -3e6} : Vec2{};
    const auto some_point = [&] { return Vec2{shift.x + scale * rng.uniform(), shift.y + scale * rng.uniform()}; };
    std::vector<Vec2> positions;
    for (std::uint64_t i = 0; i < 3 + rng.below(40); ++i)
      positions.push_back(seed % 2 == 0 ? some_point()
                                        : Vec2{shift.x + scale * (0.5 + 0.4 * std::cos(0.37 * double(i))),
                                               shift.y + scale * (0.5 + 0.3 * std::sin(0.37 * double(i)))});
    TestBench bench(positions);
    bench.show({"delaunay", "curve"});
    for (int step = 0; step < 12; ++step) {
      const Vec2 at = some_point();
      const Provenance answer = preview(bench, at);
      const auto edges_before = delaunay_edges(bench);
      const auto crust_before = crust_edges(bench.graph());
      REQUIRE_FALSE(answer.lines.empty());
      bench.insert({at});
      const auto edges = delaunay_edges(bench);
      const auto crust = crust_edges(bench.graph());
      CHECK(segments_of(answer, ProvenanceRole::product, false) == only_in(edges, edges_before));
      CHECK(segments_of(answer, ProvenanceRole::product, true) == only_in(crust, crust_before));
      CHECK(segments_of(answer, ProvenanceRole::origin, true) == only_in(crust_before, crust));
      // Each inner edge of the region that goes is between two of its triangles, or at the hull.
      const std::size_t degree = only_in(edges, edges_before).size();
      const std::size_t cell = shapes_of(answer, ProvenanceRole::itself, PrimitiveKind::segment) +
                               shapes_of(answer, ProvenanceRole::itself, PrimitiveKind::ray);
      CHECK(cell == degree);
    }
  }
}

TEST_CASE(
    "where a sample is, on an edge, on a corner of the hull and below dimension 2 the preview is right or empty") {
  TestBench bench({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}});
  bench.show({"delaunay", "curve"});
  CHECK(preview(bench, {1, 2}).lines.empty());
  CHECK(preview(bench, {0, 0}).lines.empty());
  for (const Vec2 at : {Vec2{2, 0}, Vec2{2.5, 2}, Vec2{-1, 0}, Vec2{9, 9}, Vec2{0, 2}, Vec2{4, 5}}) {
    const Provenance answer = preview(bench, at);
    REQUIRE_FALSE(answer.lines.empty());
    const auto before = delaunay_edges(bench);
    bench.insert({at});
    CHECK(segments_of(answer, ProvenanceRole::product, false) == only_in(delaunay_edges(bench), before));
    bench.undo();
  }
  CHECK(preview(bench, {std::nan(""), 0}).lines.empty());
  for (const std::vector<Vec2>& few :
       {std::vector<Vec2>{}, {{1, 1}}, {{1, 1}, {2, 2}}, {{1, 1}, {2, 2}, {3, 3}}, {{1, 1}, {1, 1}, {1, 1}}}) {
    TestBench small(few);
    small.show({"delaunay", "curve"});
    CHECK(preview(small, {5, 1}).lines.empty());
  }
}

TEST_CASE("what elements with a value in a range come from is found") {
  TestBench bench({{0, 0}, {1, 0}, {2, 0.1}, {3, 0}, {7, 3}});
  bench.show({"points"});
  ProvenanceQuestion question;
  question.layers = {find_layer("points")};
  question.wish = ProvenanceWish::sources_of_values;
  const double first = bench.ids().front().value;
  question.low = first + 1;
  question.high = first + 2;
  const Provenance answer = bench.ask(question);
  REQUIRE(answer.lines.size() == 1);
  CHECK(answer.lines.front().text == "2 elements");
  std::set<std::pair<double, double>> places;
  for (const ProvenanceShape& shape : answer.lines.front().shapes) places.emplace(shape.values[0], shape.values[1]);
  CHECK(places == std::set<std::pair<double, double>>{{1, 0}, {2, 0.1}});
  question.low = first + 100;
  question.high = first + 200;
  CHECK(bench.ask(question).lines.empty());
}
