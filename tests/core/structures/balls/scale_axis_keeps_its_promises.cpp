// SPDX-License-Identifier: GPL-3.0-or-later
// The scale axis against formulas, against the axis itself where the factor is 1, and against a fresh computation after
// every edit.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/balls/scale_axis.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr const char* kAxis = "scale-axis";
constexpr std::array kScaleLayers{kAxis, "scale-axis-boundary", "scale-axis-grown-disks", "scale-axis-disks",
                                  "scale-axis-circles"};

void show_scale_axis(TestBench& bench) {
  bench.show({kScaleLayers[0], kScaleLayers[1], kScaleLayers[2], kScaleLayers[3], kScaleLayers[4]});
}

ComputationSettings factor_in(double s, Precision precision = Precision::fast) {
  ComputationSettings out;
  out.precision = precision;
  out[Parameter::scale_axis_factor] = s;
  return out;
}

struct ScalePiece {
  Vec2 a, b;
  double radius;
};

std::vector<ScalePiece> scale_pieces(const TestBench& bench, std::string_view layer) {
  std::vector<ScalePiece> out;
  const auto values = bench.instances(layer, PrimitiveKind::segment);
  for (std::size_t at = 0; at < values.size(); at += stride_of(PrimitiveKind::segment))
    out.push_back({{values[at], values[at + 1]}, {values[at + 2], values[at + 3]}, values[at + 4]});
  return out;
}

std::vector<Disk> disks(const TestBench& bench, std::string_view layer, PrimitiveKind kind = PrimitiveKind::disk) {
  std::vector<Disk> out;
  const auto values = bench.instances(layer, kind);
  for (std::size_t at = 0; at < values.size(); at += stride_of(kind))
    out.push_back({{values[at], values[at + 1]}, values[at + 2]});
  return out;
}

std::vector<Vec2> circle(Vec2 center, double radius, int count, double offset = 0.3) {
  std::vector<Vec2> out;
  for (int i = 0; i < count; ++i) {
    const double t = 2.0 * std::numbers::pi * (i + offset) / count;
    out.push_back({center.x + radius * std::cos(t), center.y + radius * std::sin(t)});
  }
  return out;
}

}  // namespace

TEST_CASE("at a factor of 1 the scale axis is the axis of the union of the inner balls, instance for instance") {
  TestBench bench;
  bench.show({kAxis, "a-ball-medial-axis", "scale-axis-boundary", "a-union-boundary", "scale-axis-disks",
              "a-ball-medial-disks"});
  std::vector<std::vector<Vec2>> inputs;
  for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 4})) inputs.push_back(shape.data.positions);
  for (const DegenerateInput& input : degenerate_inputs()) inputs.push_back(input.positions);
  inputs.push_back(noisy_trefoil(120, 6.0, 2));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    INFO("input " << i);
    bench.replace(inputs[i]);
    const auto same = [&](std::string_view a, std::string_view b) {
      INFO(a);
      CHECK(bench.contents().sorted(find_layer(a)) == bench.contents().sorted(find_layer(b)));
    };
    same(kAxis, "a-ball-medial-axis");
    same("scale-axis-boundary", "a-union-boundary");
    same("scale-axis-disks", "a-ball-medial-disks");
  }
}

TEST_CASE("the scale axis of an ellipse is shorter by a formula, with the radii of the ellipse") {
  // About (x, 0) the ellipse with half axes a and 1 has the ball of radius sqrt(1 - x^2 / c^2), c^2 = a^2 - 1. Times s
  // it is maximal in the union while the derivative of its radius is less than 1: for |x| < c^2 / sqrt(s^2 + c^2). The
  // axis ends at c^2 / a, where this derivative is 1: so shrunk balls are all maximal.
  for (const double a : {2.0, 3.0}) {
    TestBench bench;
    show_scale_axis(bench);
    bench.replace(ellipse(a, 1.0, 400, {0.3, 0.1, 3}).data.positions);
    const double c2 = a * a - 1.0;
    for (const double s : {0.1, 0.3, 0.7, 0.95, 1.1, 1.3, 2.0, 3.0}) {
      for (const Precision precision : {Precision::fast, Precision::exact}) {
        if (precision == Precision::exact && s != 1.3) continue;
        INFO("a " << a << " s " << s);
        bench.choose(factor_in(s, precision));
        CHECK(bench.count("scale-union", "components") == 1);
        CHECK(bench.count("scale-union", "cycles") == 0);
        CHECK(bench.count("scale-union", "contradictions") == 0);
        CHECK(bench.count("scale-union", "leaves") == 2);
        double low = 0.0;
        double high = 0.0;
        std::size_t wrong = 0;
        for (const ScalePiece& piece : scale_pieces(bench, kAxis)) {
          for (const Vec2 p : {piece.a, piece.b}) {
            low = std::min(low, p.x);
            high = std::max(high, p.x);
          }
        }
        const double end = c2 / std::sqrt(std::max(1.0, s * s) + c2);
        CHECK(low == Approx(-end).margin(0.02));
        CHECK(high == Approx(end).margin(0.02));
        for (const Disk& disk : disks(bench, "scale-axis-disks")) {
          const double x = std::min(std::abs(disk.center.x), end);
          if (!(std::abs(disk.center.y) < 0.01)) ++wrong;
          if (!(std::abs(disk.radius - std::sqrt(1.0 - x * x / c2)) < 0.01)) ++wrong;
        }
        CHECK(wrong == 0);
      }
    }
  }
}

TEST_CASE("the scale axis of a stadium is that of the stadium, with its radius, at every factor") {
  const double half = 3.0;
  TestBench bench;
  show_scale_axis(bench);
  bench.replace(stadium(half, 1.0, 0.1, {0.3, 0.2, 5}).data.positions);
  for (const double s : {0.1, 0.4, 0.9, 1.05, 1.3, 2.0, 3.0}) {
    INFO("s " << s);
    bench.choose(factor_in(s));
    CHECK(bench.count("scale-union", "components") == 1);
    CHECK(bench.count("scale-union", "cycles") == 0);
    CHECK(bench.count("scale-union", "leaves") == 2);
    Box2 box;
    for (const ScalePiece& piece : scale_pieces(bench, kAxis)) {
      box.add(piece.a);
      box.add(piece.b);
      CHECK(piece.radius == Approx(1.0).margin(0.02));
    }
    CHECK(box.low.x == Approx(-half).margin(0.03));
    CHECK(box.high.x == Approx(half).margin(0.03));
    CHECK(std::max(-box.low.y, box.high.y) < 0.02);
    // The grown union is a stadium of radius s.
    const double area = std::numbers::pi * s * s + 4.0 * half * s;
    CHECK(bench.measure("scale-union", "area") == Approx(area).epsilon(0.01));
    std::size_t grown = 0;
    for (const Disk& disk : disks(bench, "scale-axis-grown-disks"))
      grown += std::abs(disk.radius - s) < 0.02 * s ? 1U : 0U;
    CHECK(grown == disks(bench, "scale-axis-grown-disks").size());
    CHECK(grown > 0);
  }
}

TEST_CASE("two disks merge at the factor that makes them touch, and a hole closes at the one that fills it") {
  std::vector<Vec2> two = circle({0, 0}, 1.0, 40);
  for (const Vec2 p : circle({3.0, 0.25}, 1.0, 40)) two.push_back(p);
  const double touch = 0.5 * std::hypot(3.0, 0.25);
  TestBench bench;
  show_scale_axis(bench);
  bench.replace(two);
  for (const double s : {1.0, 1.2, 0.995 * touch, 1.005 * touch, 2.0}) {
    INFO("s " << s);
    bench.choose(factor_in(s));
    CHECK(bench.count("scale-union", "components") == (s < touch ? 2 : 1));
  }
  // Closing of a hole: a ring of inner radius 1 and outer radius 3 has balls of radius 1 about a circle of radius 2.
  std::vector<Vec2> ring = circle({0, 0}, 1.0, 60);
  for (const Vec2 p : circle({0, 0}, 3.0, 60, 0.7)) ring.push_back(p);
  bench.replace(ring);
  for (const double s : {1.1, 1.9, 2.1, 3.0}) {
    INFO("s " << s);
    bench.choose(factor_in(s));
    CHECK(bench.count("scale-union", "components") == 1);
    CHECK(bench.count("scale-union", "cycles") == (s < 2.0 ? 1 : 0));
  }
}

TEST_CASE("the scale axis is continuous at a factor of 1") {
  TestBench bench;
  show_scale_axis(bench);
  const auto length = [&] {
    double out = 0.0;
    for (const ScalePiece& piece : scale_pieces(bench, kAxis)) out += distance(piece.a, piece.b);
    return out;
  };
  for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 4})) {
    INFO(shape.name);
    bench.replace(shape.data.positions);
    bench.choose(factor_in(1.0));
    const double whole = length();
    for (const double s : {1.0 - 1e-7, 1.0 + 1e-7}) {
      INFO("s " << s);
      bench.choose(factor_in(s));
      CHECK(length() == Approx(whole).epsilon(0.01).margin(1e-3));
    }
  }
}

TEST_CASE("balls shrunk along an axis do not part, however coarsely it is sampled") {
  TestBench bench;
  show_scale_axis(bench);
  bench.replace(stadium(3.0, 1.0, 0.5, {0.3, 0.2, 5}).data.positions);
  for (const double angle : {90.0, 175.0}) {
    for (const double s : {0.1, 0.2, 0.5, 0.8}) {
      INFO("s " << s << " angle " << angle);
      ComputationSettings settings = factor_in(s);
      settings[Parameter::medial_sampling_angle] = angle;
      bench.choose(settings);
      CHECK(bench.count("scale-union", "components") == 1);
      CHECK(bench.count("scale-union", "cycles") == 0);
    }
  }
}

TEST_CASE("hairs of a noisy outline go as the factor grows, and components and cycles follow the grown union") {
  TestBench bench;
  show_scale_axis(bench);
  bench.replace(noisy_trefoil(400, 1.0, 3));
  bench.choose(factor_in(1.0));
  const std::int64_t leaves = bench.count("scale-union", "leaves");
  bench.choose(factor_in(1.3));
  CHECK(bench.count("scale-union", "components") == 1);
  CHECK(bench.count("scale-union", "chi") == bench.count("scale-union", "chi_dual"));
  const auto length = [&] {
    double out = 0.0;
    for (const ScalePiece& piece : scale_pieces(bench, kAxis)) out += distance(piece.a, piece.b);
    return out;
  };
  const double grown = length();
  bench.choose(factor_in(1.0));
  CHECK(leaves > 100);
  CHECK(grown < 0.5 * length());
}

TEST_CASE("the scale axis follows random edits and changes of its factor as a fresh computation does") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Rng rng(seed);
    TestBench bench;
    show_scale_axis(bench);
    bench.replace(noisy_trefoil(60, 10.0, seed));
    ComputationSettings settings;
    for (int step = 0; step < 40; ++step) {
      INFO("seed " << seed << " step " << step);
      if (step % 5 == 0) {
        settings = factor_in(std::array{1.0, 0.4, 1.1, 1.4, 3.0}[rng.below(5)]);
        settings[Parameter::medial_sampling_angle] = std::array{120.0, 160.0, 175.0}[rng.below(3)];
        bench.choose(settings);
      }
      const auto place = [&] { return Vec2{260.0 * rng.uniform() - 130.0, 260.0 * rng.uniform() - 130.0}; };
      switch (rng.below(3)) {
        case 0: bench.insert({place()}); break;
        case 1: bench.remove({bench.ids()[rng.below(bench.ids().size())]}); break;
        default: bench.move(bench.ids()[rng.below(bench.ids().size())], place()); break;
      }
      TestBench fresh;
      show_scale_axis(fresh);
      std::vector<Vec2> reversed = bench.positions();
      std::ranges::reverse(reversed);
      fresh.replace(reversed);
      fresh.choose(settings);
      for (const char* layer : kScaleLayers) {
        INFO(layer);
        REQUIRE(bench.contents().sorted(find_layer(layer)) == fresh.contents().sorted(find_layer(layer)));
      }
    }
  }
}

TEST_CASE("fast and exact numbers give one scale axis as a graph, and inputs without an axis give nothing") {
  TestBench bench;
  show_scale_axis(bench);
  bench.replace(noisy_trefoil(60, 8.0, 5));
  for (const double s : {1.05, 1.37}) {
    std::vector<std::int64_t> counts[2];
    for (const Precision precision : {Precision::fast, Precision::exact}) {
      bench.choose(factor_in(s, precision));
      for (const char* key : {"balls", "visible", "hidden", "dual_singular", "dual_regular", "dual_interior", "nodes",
                              "edges", "components", "cycles", "leaves"})
        counts[precision == Precision::fast ? 0 : 1].push_back(bench.count("scale-union", key));
    }
    CHECK(counts[0] == counts[1]);
  }
  for (const std::vector<Vec2>& input : {std::vector<Vec2>{}, {{1, 2}}, {{1, 2}, {3, 4}}, {{0, 0}, {1, 1}, {2, 2}}}) {
    for (const double s : {1.0, 1.3}) {
      bench.replace(input);
      bench.choose(factor_in(s));
      CHECK(scale_pieces(bench, kAxis).empty());
      CHECK(disks(bench, "scale-axis-disks").empty());
    }
  }
  // All samples on one circle: one ball, and an axis that is its centre.
  bench.replace(lattice_circle().positions);
  bench.choose(factor_in(1.5));
  const auto points = bench.instances(kAxis, PrimitiveKind::point);
  REQUIRE(points.size() == stride_of(PrimitiveKind::point));
  CHECK(points[2] == Approx(65.0));
  REQUIRE(disks(bench, "scale-axis-circles", PrimitiveKind::circle).size() == 1);
  CHECK(disks(bench, "scale-axis-grown-disks").at(0).radius == Approx(97.5));
}

TEST_CASE("the grown union is computed only where one of its layers is shown") {
  TestBench bench;
  bench.show({"medial-axis"});
  bench.replace(circle({0, 0}, 1.0, 20));
  for (const NodeReport& node : bench.patch().nodes)
    if (node.structure.starts_with("scale-") || node.structure == "axis-sampling")
      CHECK(node.state == NodeState::inactive);
  bench.show({kAxis});
  bench.insert({{0.5, 1.5}});
  const auto state_of = [&](std::string_view structure) {
    for (const NodeReport& node : bench.patch().nodes)
      if (node.structure == structure) return node.state;
    return NodeState::failed;
  };
  CHECK(state_of("scale-union") == NodeState::up_to_date);
  CHECK(state_of("scale-ball-sampling") == NodeState::inactive);
}
