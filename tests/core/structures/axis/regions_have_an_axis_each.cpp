// SPDX-License-Identifier: GPL-3.0-or-later
// Where contours share borders, each region has an axis of its own, and edits say the same as a fresh computation.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/base/rng.h"
#include "core/curves/sampling.h"
#include "core/document/taken_samples.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/inputs/shared_borders.h"
#include "tests/support/parcels.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

SampleData sampled(std::vector<PlaneCurve> outlines, double resolution, const SamplingRequest* wanted = nullptr) {
  auto curves = std::make_shared<CurveSet>();
  curves->curves = std::move(outlines);
  curves->resolution = resolution;
  const SamplingRequest request = wanted != nullptr ? *wanted : default_sampling(*curves);
  auto samples = sample(*curves, request);
  REQUIRE(samples.has_value());
  auto data = taken_from(curves, *std::move(samples), request);
  REQUIRE(data.has_value());
  return *std::move(data);
}

double axis_of_rectangle(double width, double height) {
  const double low = std::min(width, height);
  return std::max(width, height) - low + 2.0 * std::numbers::sqrt2 * low;
}

/// Contours and all, from nothing.
std::string difference_to_fresh(const TestBench& bench) {
  ComparedBench fresh;
  fresh.load(data_of(bench.document()));
  return difference(bench.state(), fresh.state());
}

}  // namespace

TEST_CASE("parcels have the axes of rectangles, and no axis crosses a border") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const double angle = seed % 3 == 0 ? 0.0 : 0.21 * static_cast<double>(seed);
    const Parcels made = parcels(2 + 2 * seed, angle, 6, seed);
    TestBench bench;
    bench.show({"medial-axis", "curve"});
    bench.load(sampled(made.outlines, 1e-6));
    INFO("seed " << seed);
    double length = 0.0;
    for (const Box2& box : made.boxes) length += axis_of_rectangle(box.width(), box.height());
    CHECK(bench.measure("medial-axis", "length") == Approx(length).epsilon(0.03));
    CHECK(bench.count("medial-axis", "components") == static_cast<std::int64_t>(made.boxes.size()));
    CHECK(bench.count("medial-axis", "cycles") == 0);
    CHECK(bench.count("labels", "conflicts") == 0);
    const auto& delaunay = bench.get<Delaunay>();
    const auto& axis = bench.get<MedialAxis>();
    const auto box_at = [&](FaceSlot face) {
      const Vec2 p = turned(delaunay.circumcenter(face), -angle);
      return std::ranges::find_if(made.boxes, [p](const Box2& box) { return box.contains(p); }) - made.boxes.begin();
    };
    for (const EdgeSlot edge : delaunay.edge_slots()) {
      const EdgeRow& row = delaunay.edge(edge);
      if (row.is_alive() && axis.is_axis_edge(edge) && !axis.is_zero_length(edge))
        CHECK(box_at(row.f[0]) == box_at(row.f[1]));
    }
    CHECK(broken_row(bench.graph()) == "");
  }
}

TEST_CASE("a hole that another outline fills is inside, one that touches its shell is not") {
  const auto square = [](double low, double high) {
    return closed_polygon({{low, low}, {high, low}, {high, high}, {low, high}});
  };
  PlaneCurve hole = closed_polygon({{3, 3}, {3, 7}, {7, 7}, {7, 3}});
  TestBench bench;
  bench.show({"medial-axis", "curve"});
  bench.load(sampled({square(0, 10), hole, square(3, 7)}, 1.0));
  CHECK(bench.count("medial-axis", "components") == 2);
  CHECK(bench.count("medial-axis", "cycles") == 1);  // around the hole
  bench.load(sampled({square(0, 10), hole}, 1.0));
  CHECK(bench.count("medial-axis", "components") == 1);
  bench.load(sampled({square(0, 10), closed_polygon({{0, 5}, {4, 7}, {4, 3}})}, 1.0));
  CHECK(bench.count("medial-axis", "components") == 1);
  CHECK(bench.count("medial-axis", "cycles") == 0);
}

TEST_CASE("the certificate does not speak of regions that share a border") {
  const Parcels made = parcels(5, 0.4, 6, 3);
  TestBench bench;
  bench.load(sampled(made.outlines, 1e-6));
  CHECK(bench.count("axis-certificate", "certified") == 0);
  bench.load(sampled({made.outlines[0]}, 1e-6));
  CHECK(bench.count("shared-borders", "shared_links") == 0);
}

TEST_CASE("edits among shared borders equal a fresh computation") {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const SamplingRequest request{.rule = SamplingRule::spacing, .spacing = 2.0};
    const Parcels made = parcels(6, seed % 2 == 0 ? 0.0 : 0.3, 6, seed);
    // Unions of balls go along with one of the scripts.
    TestBench bench = seed == 1 ? TestBench() : ComparedBench();
    bench.load(sampled(made.outlines, 1e-6, &request));
    REQUIRE(bench.count("shared-borders", "shared_links") > 0);
    Rng rng(seed);
    for (int step = 0; step < 40; ++step) {
      const std::vector<SampleId> ids = bench.ids();
      const auto pick = [&] { return ids[rng.below(ids.size())]; };
      const auto position = [&](SampleId id) { return bench.document().position(bench.document().slot_of(id)); };
      const std::uint64_t action = rng.below(8);
      INFO("seed " << seed << ", step " << step << ", action " << action);
      if (action < 3) {
        const SampleId id = pick();
        bench.move(id, position(id) + Vec2{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)});
      } else if (action == 3) {
        // Two samples change places, or one goes to where another is.
        const SampleId a = pick();
        const SampleId b = pick();
        if (a == b) continue;
        const Vec2 at_a = position(a);
        const Vec2 at_b = position(b);
        if (rng.below(2) == 0)
          bench.move(a, at_b);
        else
          bench.move({{a, at_b}, {b, at_a}});
      } else if (action == 4) {
        bench.remove({pick()});
      } else if (action == 5) {
        bench.insert({{rng.uniform(0.0, 100.0), rng.uniform(0.0, 60.0)}});
      } else if (bench.steps_done() > 1) {
        bench.undo();
        if (action == 7) bench.redo();
      }
      REQUIRE(broken_row(bench.graph()) == "");
      REQUIRE(difference_to_fresh(bench) == "");
    }
  }
}
