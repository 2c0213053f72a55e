// SPDX-License-Identifier: GPL-3.0-or-later
// Metamorphic relations: order, duplicates, translation by integers, scaling by powers of two, reflection and turning
// by right angles change positions and nothing else. Every structure's answer is compared, mapped back.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "core/base/rng.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

struct Input {
  std::string name;
  std::vector<Vec2> positions;
};

std::vector<Vec2> on_grid(std::vector<Vec2> points, double cell) {
  for (Vec2& p : points) p = {std::round(p.x / cell), std::round(p.y / cell)};
  return points;
}

// Integers: every image below is exact.
std::vector<Input> inputs() {
  std::vector<Input> out;
  out.push_back({"smooth curve", on_grid(benchmark_curve(200), 0x1p-8)});
  out.push_back({"rough curve", on_grid(rough_curve(200), 0x1p-8)});
  out.push_back({"noisy curve", on_grid(noisy_curve(150), 0x1p-8)});
  out.push_back({"square", on_grid(uniform_square(120), 0x1p-8)});
  out.push_back({"coarse curve, many ties", on_grid(noisy_curve(150), 16.0)});
  out.push_back({"duplicates", duplicate_heavy(150)});
  out.push_back({"lattice", integer_lattice(5).positions});
  out.push_back({"circle", lattice_circle().positions});
  for (const TestShape& shape : oracle_shapes(0.4, {0.3, 0.2, 3}))
    out.push_back({shape.name, on_grid(shape.data.positions, 0x1p-16)});
  return out;
}

// What is left of a state when places are mapped by `map`, sorted again. `flips` when the map is a reflection.
GeometryState image_of(const GeometryState& state, const std::function<Vec2(Vec2)>& map, bool flips) {
  GeometryState out = state;
  for (Vec2& p : out.sites) p = map(p);
  std::ranges::sort(out.sites, lexicographically_less);
  for (EdgeState& edge : out.edges) {
    edge.a = map(edge.a);
    edge.b = map(edge.b);
    if (flips) std::swap(edge.inside_left, edge.inside_right);
    if (lexicographically_less(edge.b, edge.a)) {
      std::swap(edge.a, edge.b);
      std::swap(edge.inside_left, edge.inside_right);
    }
  }
  std::sort(out.edges.begin(), out.edges.end());
  for (NodeStateOf& node : out.nodes) {
    for (Vec2& p : node.corners) p = map(p);
    std::ranges::sort(node.corners, lexicographically_less);
  }
  std::ranges::sort(out.nodes, [](const NodeStateOf& a, const NodeStateOf& b) {
    return std::ranges::lexicographical_compare(a.corners, b.corners, lexicographically_less);
  });
  // Where chains begin and which way open ones run depends on the lexicographic order, and so on the map; that chains
  // are sound is compared by their edges above. Normals are compared where they are unique: at closed chains.
  out.chains.clear();
  out.normals.clear();
  // Of two equally far poles the lexicographically smaller counts.
  out.poles.clear();
  return out;
}

// `ties_move`: equal edges are distinguished by the lexicographic order, which the map changes; then conflicts and
// labels of inputs with exact ties may differ.
void check_image(const Input& input, const std::function<Vec2(Vec2)>& map, bool flips, bool ties_move) {
  const ComparedBench original(input.positions);
  std::vector<Vec2> moved = input.positions;
  for (Vec2& p : moved) p = map(p);
  const ComparedBench image(moved);
  const auto itself = [](Vec2 p) { return p; };
  GeometryState expected = image_of(original.state(), map, flips);
  GeometryState got = image_of(image.state(), itself, false);
  if (ties_move && original.count("one-step-crust", "odd_samples") != 0) {
    for (GeometryState* state : {&expected, &got}) {
      state->conflicts = 0;
      for (EdgeState& edge : state->edges) edge.conflict = edge.inside_left = edge.inside_right = false;
      for (NodeStateOf& node : state->nodes) {
        node.inside = false;
        node.degree = 0;
      }
    }
  }
  CHECK(difference(got, expected) == "");
  if (ties_move && original.count("one-step-crust", "odd_samples") != 0) return;
  for (const char* key : {"nodes", "edges", "components", "cycles", "leaves", "branch_points", "isolated"})
    CHECK(image.count("medial-axis", key) == original.count("medial-axis", key));
  for (const char* key : {"loops", "open_chains", "isolated"})
    CHECK(image.count("curve", key) == original.count("curve", key));
  for (const char* key : {"inside", "outside", "conflicts"})
    CHECK(image.count("labels", key) == original.count("labels", key));
}

}  // namespace

TEST_CASE("the order of the samples does not matter") {
  Rng rng(1);
  for (Input& input : inputs()) {
    INFO(input.name);
    const ComparedBench original(input.positions);
    for (int round = 0; round < 3; ++round) {
      for (std::size_t i = input.positions.size(); i > 1; --i)
        std::swap(input.positions[i - 1], input.positions[rng.below(i)]);
      const ComparedBench shuffled(input.positions);
      CHECK(difference(shuffled.state(), original.state()) == "");
    }
  }
}

TEST_CASE("duplicates do not matter") {
  Rng rng(2);
  for (Input& input : inputs()) {
    INFO(input.name);
    const ComparedBench original(input.positions);
    std::vector<Vec2> twice = input.positions;
    for (int i = 0; i < 60; ++i) twice.push_back(input.positions[rng.below(input.positions.size())]);
    const ComparedBench doubled(twice);
    CHECK(difference(doubled.state(), original.state()) == "");
    // Deleting one of two leaves the other.
    ComparedBench reduced(twice);
    const std::vector<SampleId> ids = reduced.ids();
    reduced.remove({ids.end() - 60, ids.end()});
    CHECK(difference(reduced.state(), original.state()) == "");
  }
}

TEST_CASE("translation by integers does not matter") {
  for (const Input& input : inputs()) {
    INFO(input.name);
    for (const Vec2 shift : {Vec2{1e6, -1e6}, Vec2{-3.0, 1e15}, Vec2{4e15, 4e15}})
      check_image(
          input, [=](Vec2 p) { return p + shift; }, false, false);
  }
}

TEST_CASE("scaling by powers of two does not matter") {
  for (const Input& input : inputs()) {
    INFO(input.name);
    for (const double scale : {0x1p-480, 0x1p-400, 0x1p-20, 0x1p33, 0x1p400, 0x1p470})
      check_image(
          input, [=](Vec2 p) { return scale * p; }, false, false);
  }
}

TEST_CASE("reflection and turning by right angles do not matter") {
  for (const Input& input : inputs()) {
    INFO(input.name);
    check_image(
        input,
        [](Vec2 p) {
          return Vec2{-p.x, p.y};
        },
        true, true);
    check_image(
        input,
        [](Vec2 p) {
          return Vec2{p.y, p.x};
        },
        true, true);
    check_image(
        input, [](Vec2 p) { return perpendicular(p); }, false, true);
    check_image(
        input, [](Vec2 p) { return -p; }, false, true);
  }
}
