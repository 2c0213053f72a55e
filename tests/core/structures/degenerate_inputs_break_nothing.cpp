// SPDX-License-Identifier: GPL-3.0-or-later
// Too few samples, collinear and cocircular ones, duplicates, extreme numbers: every structure and layer is built,
// says what is known of the input, and keeps up with edits.
//
// That every node is up to date and every number in a patch is finite is required by the workbench itself.
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

std::int64_t as_count(std::size_t n) {
  return static_cast<std::int64_t>(n);
}

bool has_trouble(const TestBench& bench) {
  const std::string trouble = bench.trouble();
  if (trouble.empty()) return false;
  FAIL(trouble);
  return true;
}

}  // namespace

TEST_CASE("degenerate inputs are computed, and give what is known of them") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    const TestBench bench(input.positions);
    CHECK(bench.count("delaunay", "vertices") == as_count(input.distinct));
    CHECK(bench.count("delaunay", "duplicates") == as_count(input.positions.size() - input.distinct));
    CHECK(bench.count("samples", "samples") == as_count(input.positions.size()));
    CHECK(bench.contents().count(find_layer("points"), PrimitiveKind::point) == input.positions.size());
    if (input.crust_edges) {
      CHECK(bench.count("one-step-crust", "crust_edges") == as_count(*input.crust_edges));
      CHECK(bench.contents().count(find_layer("curve"), PrimitiveKind::segment) == *input.crust_edges);
    }
    if (input.odd_samples) {
      CHECK(bench.count("one-step-crust", "odd_samples") == as_count(*input.odd_samples));
      if (*input.odd_samples == 0) CHECK(bench.count("labels", "conflicts") == 0);
    }
    CHECK(broken_row(bench.graph()) == "");
  }
}

TEST_CASE("Euler's formula holds for every triangulation") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    const TestBench bench(input.positions);
    const std::int64_t vertices = bench.count("delaunay", "vertices");
    const std::int64_t edges = bench.count("delaunay", "edges");
    const std::int64_t faces = bench.count("delaunay", "faces");
    const std::int64_t hull = bench.count("delaunay", "hull_edges");
    switch (bench.count("delaunay", "dimension")) {
      case 2:
        CHECK(vertices - edges + faces == 1);
        CHECK(3 * faces + hull == 2 * edges);
        CHECK(bench.count("one-step-crust", "crust_edges") + bench.count("one-step-crust", "skeleton_edges") ==
              edges);
        CHECK(bench.count("labels", "inside") + bench.count("labels", "outside") == faces);
        break;
      case 1:
        CHECK(edges == vertices - 1);
        CHECK(faces == 0);
        break;
      default: CHECK(edges == 0); CHECK(vertices <= 1);
    }
  }
}

TEST_CASE("every edge was decided by one stage of the filter") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    const TestBench bench(input.positions);
    const std::int64_t decided = bench.count("one-step-crust", "decided_by_static_filter") +
                                 bench.count("one-step-crust", "decided_by_intervals") +
                                 bench.count("one-step-crust", "decided_exactly");
    const bool has_faces = bench.count("delaunay", "dimension") == 2;
    CHECK(decided == (has_faces ? bench.count("delaunay", "edges") : 0));
  }
}

TEST_CASE("the axis of an exact circle is its centre") {
  const TestBench bench(lattice_circle().positions);
  CHECK(bench.count("inner-balls", "balls") == 34);
  CHECK(bench.count("inner-balls", "distinct") == 1);
  CHECK(bench.count("medial-axis", "nodes") == 1);
  CHECK(bench.count("medial-axis", "isolated") == 1);
  CHECK(bench.count("medial-axis", "edges") == 0);
  CHECK(bench.count("medial-axis", "components") == 1);
  CHECK(bench.count("medial-axis", "cycles") == 0);
  CHECK(bench.count("medial-axis", "leaves") == 0);
  CHECK(bench.measure("medial-axis", "length") == 0.0);
  CHECK(bench.measure("medial-axis", "radius_min") == Approx(65.0));
  const auto nodes = bench.instances("axis-nodes", PrimitiveKind::point);
  REQUIRE(nodes.size() == stride_of(PrimitiveKind::point));
  CHECK(std::abs(nodes[0]) < 1e-12);
  CHECK(std::abs(nodes[1]) < 1e-12);
  CHECK(nodes[2] == 0.0);
  const auto disks = bench.instances("interior-voronoi-disks", PrimitiveKind::disk);
  CHECK_FALSE(disks.empty());
  for (std::size_t at = 0; at < disks.size(); at += stride_of(PrimitiveKind::disk)) {
    CHECK(length({disks[at], disks[at + 1]}) < 1e-12);
    CHECK(disks[at + 2] == Approx(65.0).epsilon(1e-14));
  }
}

TEST_CASE("two exact circles have an axis of two points") {
  std::vector<Vec2> positions = lattice_circle().positions;
  for (const Vec2 p : lattice_circle().positions) positions.push_back(p + Vec2{400, 30});
  const TestBench bench(positions);
  CHECK(bench.count("medial-axis", "nodes") == 2);
  CHECK(bench.count("medial-axis", "components") == 2);
  CHECK(bench.count("medial-axis", "isolated") == 2);
  CHECK(bench.count("medial-axis", "edges") == 0);
}

TEST_CASE("sparse sets with foreign crossings have ordinary curves") {
  for (int number = 1; number <= 3; ++number) {
    const DegenerateInput input = foreign_crossing(number);
    INFO(input.name);
    const TestBench bench(input.positions);
    CHECK(bench.count("curve", "open_chains") == 0);
    CHECK(bench.count("curve", "isolated") == 0);
    CHECK(bench.count("labels", "conflicts") == 0);
    CHECK(bench.count("medial-axis", "components") >= 1);
  }
}

TEST_CASE("after every edit of a degenerate input everything equals a fresh computation") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    TestBench bench(input.positions);
    if (has_trouble(bench)) continue;
    const std::string before = std::to_string(bench.document().digest());
    Rng rng(17);
    // Edits of the size of the input, so that they matter to it.
    Box2 box;
    for (const Vec2 p : input.positions) box.add(p);
    if (box.is_empty()) box = {{0, 0}, {1, 1}};
    const auto somewhere = [&] {
      const double tx = rng.uniform();
      const double ty = rng.uniform();
      return Vec2{(1.0 - tx) * box.low.x + tx * box.high.x, (1.0 - ty) * box.low.y + ty * box.high.y};
    };
    const auto some_id = [&] {
      const std::vector<SampleId> ids = bench.ids();
      return ids[rng.below(ids.size())];
    };
    for (int round = 0; round < 4; ++round) {
      bench.insert({somewhere()});
      has_trouble(bench);
      // Exactly onto another sample, so that it is a duplicate, and away again.
      const Vec2 taken = bench.document().position(bench.document().slot_of(some_id()));
      bench.insert({taken});
      has_trouble(bench);
      bench.move(bench.ids().back(), somewhere());
      has_trouble(bench);
      bench.move(some_id(), somewhere());
      has_trouble(bench);
      bench.remove({some_id()});
      has_trouble(bench);
      bench.insert({somewhere(), somewhere(), taken});
      has_trouble(bench);
    }
    // The first step is the input itself.
    while (bench.steps_done() > 1) {
      bench.undo();
      if (bench.steps_done() % 5 == 0) has_trouble(bench);
    }
    has_trouble(bench);
    CHECK(std::to_string(bench.document().digest()) == before);
    for (int i = 0; i < 3; ++i) bench.redo();
    has_trouble(bench);
  }
}

TEST_CASE("a degenerate input can be taken away sample by sample, and come back") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    if (input.positions.size() > 40) continue;
    INFO(input.name);
    TestBench bench(input.positions);
    Rng rng(23);
    while (!bench.ids().empty()) {
      const std::vector<SampleId> ids = bench.ids();
      bench.remove({ids[rng.below(ids.size())]});
      has_trouble(bench);
    }
    CHECK(bench.count("delaunay", "dimension") == -1);
    for (const Vec2 p : input.positions) {
      bench.insert({p});
      has_trouble(bench);
    }
    if (input.crust_edges) CHECK(bench.count("one-step-crust", "crust_edges") == as_count(*input.crust_edges));
  }
}
