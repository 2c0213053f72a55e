// SPDX-License-Identifier: GPL-3.0-or-later
// Lambda and object angle: values against definitions in plain loops and formulas, what is kept against both, and the
// topology of what pruning leaves.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/balls/kept_union.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/lambda_axis.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::array<std::string_view, 15> kLayers{
    "lambda-medial-axis",   "lambda-medial-disks", "lambda-medial-circles", "removed-by-lambda",
    "angle-medial-axis",    "angle-medial-disks",  "angle-medial-circles",  "removed-by-angle",
    "cover-medial-axis",    "cover-medial-disks",  "cover-medial-circles",  "removed-by-cover",
    "lambda-kept-boundary", "angle-kept-boundary", "cover-kept-boundary"};

void show_filters(TestBench& bench) {
  bench.show({kLayers[0], kLayers[1], kLayers[2], kLayers[3], kLayers[4], kLayers[5], kLayers[6], kLayers[7],
              kLayers[8], kLayers[9], kLayers[10], kLayers[11], kLayers[12], kLayers[13], kLayers[14], "medial-axis",
              "axis-nodes"});
}

ComputationSettings limits_in_mode(double lambda, double angle, bool keep_topology,
                                   AngleMode mode = AngleMode::clip) {
  ComputationSettings out;
  out[Parameter::lambda_limit] = lambda;
  out[Parameter::angle_limit] = angle;
  out[Parameter::keep_topology] = keep_topology ? 1.0 : 0.0;
  out[Parameter::angle_mode] = static_cast<double>(mode);
  return out;
}

double length_of(const TestBench& bench, std::string_view layer) {
  const auto values = bench.instances(layer, PrimitiveKind::segment);
  double out = 0.0;
  for (std::size_t at = 0; at < values.size(); at += stride_of(PrimitiveKind::segment))
    out += distance({values[at], values[at + 1]}, {values[at + 2], values[at + 3]});
  return out;
}

/// A ring with noise on both circles: one cycle and many hairs.
std::vector<Vec2> noisy_ring(std::size_t count, double noise, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec2> out;
  for (const double radius : {60.0, 100.0}) {
    for (std::size_t i = 0; i < count; ++i) {
      const double t = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      const double r = radius + noise * (rng.uniform() - 0.5);
      out.push_back({r * std::cos(t), r * std::sin(t)});
    }
  }
  return out;
}

// Radius of the smallest circle that encloses the points: the smallest of all circles with two of them for a diameter
// and all circles through three that does.
double enclosing_radius(const std::vector<Vec2>& points) {
  const auto encloses = [&](Vec2 center, double radius) {
    return std::ranges::all_of(points, [&](Vec2 p) { return distance(p, center) <= radius * (1.0 + 1e-9); });
  };
  double out = std::numeric_limits<double>::infinity();
  for (const Vec2 a : points) {
    for (const Vec2 b : points) {
      if (a == b) continue;
      if (encloses(0.5 * (a + b), 0.5 * distance(a, b))) out = std::min(out, 0.5 * distance(a, b));
      for (const Vec2 c : points) {
        const Vec2 u = b - a;
        const Vec2 v = c - a;
        const double area = cross(u, v);
        if (std::abs(area) < 1e-12 * length(u) * length(v)) continue;
        const Vec2 to_center =
            (0.5 / area) * Vec2{v.y * dot(u, u) - u.y * dot(v, v), u.x * dot(v, v) - v.x * dot(u, u)};
        if (encloses(a + to_center, length(to_center))) out = std::min(out, length(to_center));
      }
    }
  }
  return out;
}

double largest_half_angle(Vec2 center, const std::vector<Vec2>& points) {
  double out = 0.0;
  for (const Vec2 a : points)
    for (const Vec2 b : points)
      out = std::max(out, 0.5 * std::abs(std::atan2(cross(a - center, b - center), dot(a - center, b - center))));
  return out * 180.0 / std::numbers::pi;
}

std::vector<Vec2> nearest(const std::vector<Vec2>& samples, Vec2 x) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 p : samples) least = std::min(least, distance(p, x));
  std::vector<Vec2> out;
  for (const Vec2 p : samples)
    if (distance(p, x) <= least * (1.0 + 1e-9)) out.push_back(p);
  return out;
}

/// Every axis edge and node against the definition, from the samples alone.
void check_values(const TestBench& bench) {
  const auto samples = bench.positions();
  const auto& delaunay = bench.get<Delaunay>();
  const auto& axis = bench.get<MedialAxis>();
  const auto& lambda = bench.get<LambdaAxis>();
  const auto& angle = bench.get<AngleAxis>();
  for (const FaceSlot node : delaunay.face_slots()) {
    if (!delaunay.face(node).is_alive() || !axis.is_node(node)) continue;
    const Vec2 center = delaunay.circumcenter(node);
    const std::vector<Vec2> around = nearest(samples, center);
    REQUIRE(around.size() >= 3);
    REQUIRE(lambda.value(node) == Approx(enclosing_radius(around)).epsilon(1e-7));
    REQUIRE(angle.value(node) == Approx(largest_half_angle(center, around)).margin(1e-5));
  }
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(edge);
    if (!row.is_alive() || !axis.is_axis_edge(edge) || axis.is_zero_length(edge)) continue;
    const Vec2 a = delaunay.circumcenter(row.f[0]);
    const Vec2 b = delaunay.circumcenter(row.f[1]);
    double largest = 0.0;
    for (int i = 0; i <= 64; ++i) {
      const Vec2 at = a + (static_cast<double>(i) / 64.0) * (b - a);
      const Vec2 p = delaunay.site_position(row.v[0]);
      const Vec2 q = delaunay.site_position(row.v[1]);
      largest = std::max(largest, largest_half_angle(at, {p, q}));
      if (i == 32 && distance(a, b) > 1e-6 * delaunay.circumradius(row.f[0]))
        REQUIRE(lambda.value(edge) == Approx(enclosing_radius(nearest(samples, at))).epsilon(1e-7));
    }
    if (angle.angle_mode() == AngleMode::mean) continue;
    // Between two of the places looked at it may be larger.
    REQUIRE(angle.value(edge) >= largest - 1e-5);
    const double spacing = distance(a, b) / 64.0 / lambda.value(edge) * 180.0 / std::numbers::pi;
    REQUIRE(angle.value(edge) <= largest + spacing + 1e-5);
  }
}

/// No value of any layer is anything but a finite number.
void check_finite(const TestBench& bench) {
  for (const std::string_view layer : kLayers)
    for (const PrimitiveKind kind : kAllPrimitiveKinds)
      for (const double x : bench.instances(layer, kind)) REQUIRE(std::isfinite(x));
}

/// The same settings on a fresh computation of the same samples give the same drawing.
void check_against_fresh(const TestBench& bench, const ComputationSettings& settings) {
  std::vector<Vec2> reversed = bench.positions();
  std::ranges::reverse(reversed);
  TestBench fresh;
  show_filters(fresh);
  fresh.choose(settings);
  fresh.replace(reversed);
  for (const std::string_view layer : kLayers) {
    INFO(layer);
    REQUIRE(bench.mirror().digest(find_layer(layer)) == fresh.mirror().digest(find_layer(layer)));
  }
  for (const std::string_view filter : {"lambda-axis", "angle-axis", "cover-axis"})
    for (const std::string_view key : {"nodes", "edges", "components", "cycles", "isolated", "leaves"})
      REQUIRE(bench.count(filter, key) == fresh.count(filter, key));
}

}  // namespace

TEST_CASE("values are those of the definitions, in plain loops over the samples") {
  for (const AngleMode mode : {AngleMode::clip, AngleMode::mean}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      TestBench bench;
      show_filters(bench);
      bench.choose(limits_in_mode(0.0, 0.0, false, mode));
      bench.replace(noisy_trefoil(90, 8.0, seed));
      REQUIRE(bench.count("medial-axis", "edges") > 20);
      check_values(bench);
    }
    for (const DegenerateInput& input : degenerate_inputs()) {
      if (input.positions.size() > 60 || input.positions.empty()) continue;
      INFO(input.name);
      TestBench bench;
      show_filters(bench);
      bench.choose(limits_in_mode(0.0, 0.0, false, mode));
      bench.replace(input.positions);
      check_finite(bench);
    }
  }
}

TEST_CASE("a node with an acute triangle has its circumradius for lambda, an obtuse one half its longest side") {
  TestBench bench;
  show_filters(bench);
  const double height = std::sqrt(3.0);
  bench.replace({{-1.0, 0.0}, {1.0, 0.0}, {0.0, height}});
  const auto disks = [&bench] { return bench.instances("lambda-medial-disks", PrimitiveKind::disk); };
  REQUIRE(disks().size() == stride_of(PrimitiveKind::disk));
  CHECK(disks()[3] == Approx(2.0 / height).epsilon(1e-14));
  // More than half the side, which is what the limit is compared with in the obtuse triangle.
  bench.choose(limits_in_mode(1.1, 0.0, false));
  CHECK(disks().size() == stride_of(PrimitiveKind::disk));
  bench.choose(limits_in_mode(1.2, 0.0, false));
  CHECK(disks().empty());
}

TEST_CASE("samples on one circle are one node: its circle, and a right angle where two are opposite") {
  TestBench bench;
  show_filters(bench);
  bench.replace(
      {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}});
  const auto lambda = bench.instances("lambda-medial-disks", PrimitiveKind::disk);
  const auto angle = bench.instances("angle-medial-disks", PrimitiveKind::disk);
  REQUIRE(lambda.size() == 4);
  REQUIRE(angle.size() == 4);
  CHECK(lambda[3] == Approx(5.0).epsilon(1e-14));
  CHECK(angle[3] == Approx(90.0).epsilon(1e-12));
  bench.choose(limits_in_mode(5.5, 0.0, true));
  CHECK(bench.instances("lambda-medial-disks", PrimitiveKind::disk).size() == 4);
  CHECK(bench.count("lambda-axis", "isolated") == 1);
}

TEST_CASE("the lambda axis of an ellipse is as long as the formula says") {
  const double a = 2.0;
  const double c2 = a * a - 1.0;
  TestBench bench;
  show_filters(bench);
  bench.replace(ellipse(a, 1.0, 800, {0.3, 0.0, 1}).data.positions);
  for (const double limit : {0.3, 0.5, 0.8, 0.95}) {
    bench.choose(limits_in_mode(limit, 0.0, false));
    const double expected = 2.0 * c2 / a * std::sqrt(1.0 - limit * limit);
    CHECK(bench.measure("lambda-axis", "length") == Approx(expected).margin(0.02));
    CHECK(length_of(bench, "lambda-medial-axis") == Approx(bench.measure("lambda-axis", "length")).epsilon(1e-12));
    CHECK(bench.count("lambda-axis", "components") == 1);
  }
}

TEST_CASE("a rounded rectangle has an object angle of 45 degrees on its branches and 90 on its core") {
  TestBench bench;
  show_filters(bench);
  bench.replace(rounded_rectangle(3.0, 2.0, 0.5, 0.03, {0.3, 0.0, 1}).data.positions);
  const double core = 2.0;
  const double branches = 4.0 * std::sqrt(2.0) * 1.5;
  for (const bool keep : {false, true}) {
    for (const AngleMode mode : {AngleMode::clip, AngleMode::largest, AngleMode::mean}) {
      INFO("mode " << static_cast<int>(mode) << " topology " << keep);
      // Where samples stop facing each other a corner's branch begins; the ends of the core are a little uncertain.
      bench.choose(limits_in_mode(0.0, 60.0, keep, mode));
      CHECK(bench.measure("angle-axis", "length") == Approx(core).margin(0.2));
      CHECK(bench.count("angle-axis", "components") == 1);
      bench.choose(limits_in_mode(0.0, 30.0, keep, mode));
      CHECK(bench.measure("angle-axis", "length") == Approx(core + branches).margin(0.3));
      CHECK(length_of(bench, "angle-medial-axis") == Approx(bench.measure("angle-axis", "length")).epsilon(1e-9));
    }
  }
}

TEST_CASE("kept and removed parts are the medial axis together") {
  for (const bool keep : {false, true}) {
    for (const double limit : {0.0, 3.0, 20.0, 1e6}) {
      for (const double degrees : {0.0, 20.0, 50.0, 90.0}) {
        TestBench bench;
        show_filters(bench);
        bench.choose(limits_in_mode(limit, degrees, keep));
        bench.replace(noisy_trefoil(160, 10.0, 5));
        const double whole = length_of(bench, "medial-axis");
        CHECK(length_of(bench, "lambda-medial-axis") + length_of(bench, "removed-by-lambda") ==
              Approx(whole).epsilon(1e-10));
        CHECK(length_of(bench, "angle-medial-axis") + length_of(bench, "removed-by-angle") ==
              Approx(whole).epsilon(1e-10));
        if (limit == 0.0) CHECK(bench.instances("removed-by-lambda", PrimitiveKind::segment).empty());
      }
    }
  }
}

TEST_CASE("an edge exactly at the limit is kept, and one a unit in the last place below is not") {
  // The axis of a strip of lattice points: all of its edges belong to samples that are two apart.
  TestBench bench;
  show_filters(bench);
  std::vector<Vec2> strip;
  for (int i = 0; i <= 20; ++i) {
    strip.push_back({0.5 * i, 0.0});
    strip.push_back({0.5 * i, 2.0});
  }
  for (const double y : {0.5, 1.0, 1.5}) {
    strip.push_back({0.0, y});
    strip.push_back({10.0, y});
  }
  bench.replace(strip);
  bench.choose(limits_in_mode(1.0, 0.0, false));
  const std::int64_t at_limit = bench.count("lambda-axis", "edges");
  CHECK(at_limit > 10);
  bench.choose(limits_in_mode(std::nextafter(1.0, 2.0), 0.0, false));
  CHECK(bench.count("lambda-axis", "edges") < at_limit);
  bench.choose(limits_in_mode(std::nextafter(1.0, 0.0), 0.0, false));
  CHECK(bench.count("lambda-axis", "edges") == at_limit);
}

TEST_CASE("pruning keeps components and cycles for every limit") {
  std::vector<std::vector<Vec2>> inputs{noisy_trefoil(150, 12.0, 1), noisy_ring(90, 6.0, 2), noisy_ring(60, 14.0, 3)};
  for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 4})) inputs.push_back(shape.data.positions);
  for (const DegenerateInput& input : degenerate_inputs())
    if (input.positions.size() > 3) inputs.push_back(input.positions);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    INFO("input " << i);
    TestBench bench;
    show_filters(bench);
    bench.replace(inputs[i]);
    const std::int64_t components = bench.count("medial-axis", "components");
    const std::int64_t cycles = bench.count("medial-axis", "cycles");
    double before = std::numeric_limits<double>::infinity();
    const double largest = components == 0 ? 1.0 : bench.measure("lambda-axis", "largest");
    for (const double share : {0.0, 0.02, 0.05, 0.1, 0.3, 0.7, 1.0, 1.5}) {
      for (const AngleMode mode : {AngleMode::clip, AngleMode::largest, AngleMode::mean}) {
        bench.choose(limits_in_mode(share * largest, std::min(90.0, 90.0 * share), true, mode));
        for (const std::string_view filter : {"lambda-axis", "angle-axis"}) {
          INFO(filter << " at " << share << " mode " << static_cast<int>(mode));
          CHECK(bench.count(filter, "components") == components);
          CHECK(bench.count(filter, "cycles") == cycles);
        }
      }
      const double length = bench.measure("lambda-axis", "length");
      CHECK(length <= before * (1.0 + 1e-12) + 1e-12);
      before = length;
    }
  }
}

TEST_CASE("after every edit, and every change of a limit, all is as in a fresh computation") {
  for (const bool lattice : {false, true}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      Rng rng(seed);
      const auto place = [&] {
        if (lattice) return Vec2{static_cast<double>(rng.below(7)), static_cast<double>(rng.below(7))};
        const double t = 2.0 * std::numbers::pi * rng.uniform();
        const double r = 4.0 * (1.0 + 0.3 * std::cos(3.0 * t)) + 0.3 * rng.uniform();
        return Vec2{r * std::cos(t), r * std::sin(t)};
      };
      TestBench bench;
      show_filters(bench);
      ComputationSettings settings;
      std::vector<Vec2> start;
      for (int i = 0; i < (lattice ? 25 : 80); ++i) start.push_back(place());
      bench.replace(start);
      for (int step = 0; step < 120; ++step) {
        INFO("seed " << seed << " step " << step);
        const auto ids = bench.ids();
        const auto some = [&] { return ids[rng.below(ids.size())]; };
        switch (rng.below(7)) {
          case 0: bench.insert({place()}); break;
          case 1:
            if (ids.size() > 3) bench.remove({some()});
            break;
          case 2:
          case 3: bench.move(some(), place()); break;
          case 4:
            if (bench.steps_done() > 1) bench.undo();
            break;
          case 5:
            settings[Parameter::lambda_limit] = lattice ? 0.5 * static_cast<double>(rng.below(4)) : rng.uniform();
            settings[Parameter::angle_limit] =
                lattice ? 45.0 * static_cast<double>(rng.below(3)) : 90.0 * rng.uniform();
            settings[Parameter::scale_axis_factor] = 1.0 + 0.5 * static_cast<double>(rng.below(4));
            bench.choose(settings);
            break;
          default:
            settings[Parameter::keep_topology] = static_cast<double>(rng.below(2));
            settings[Parameter::angle_mode] = static_cast<double>(rng.below(3));
            bench.choose(settings);
        }
        check_finite(bench);
        check_against_fresh(bench, settings);
      }
    }
  }
}

TEST_CASE("the cover axis keeps what no other ball swallows, by all pairs of balls") {
  for (const double factor : {1.0, 1.05, 1.3, 2.0, 3.0}) {
    for (const bool keeps_topology : {false, true}) {
      INFO("factor " << factor << ", topology " << keeps_topology);
      ComputationSettings settings;
      settings[Parameter::scale_axis_factor] = factor;
      settings[Parameter::keep_topology] = keeps_topology ? 1.0 : 0.0;
      TestBench bench;
      show_filters(bench);
      bench.choose(settings);
      bench.replace(noisy_ring(60, 6.0, 4));
      check_finite(bench);
      const auto& delaunay = bench.get<Delaunay>();
      const auto& axis = bench.get<MedialAxis>();
      const auto& cover = bench.get<CoverAxis>();
      std::vector<Disk> disks;
      std::vector<FaceSlot> nodes;
      for (const FaceSlot node : delaunay.face_slots()) {
        if (!delaunay.face(node).is_alive() || !axis.is_node(node)) continue;
        nodes.push_back(node);
        disks.push_back({delaunay.circumcenter(node), delaunay.circumradius(node)});
      }
      const auto is_swallowed = [&](const Disk& small) {
        return std::ranges::any_of(disks, [&](const Disk& large) {
          return distance(small.center, large.center) + factor * small.radius < factor * large.radius * (1.0 - 1e-12);
        });
      };
      std::size_t swallowed = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!is_swallowed(disks[i])) {
          REQUIRE((keeps_topology || cover.is_kept(nodes[i])));
          continue;
        }
        ++swallowed;
        REQUIRE((keeps_topology || !cover.is_kept(nodes[i])));
        REQUIRE(cover.value(nodes[i]) < 1.0 - 1.0 / factor);
      }
      if (factor == 1.0) REQUIRE(swallowed == 0);
      if (factor >= 1.3) REQUIRE(swallowed > 10);
      if (keeps_topology) {
        REQUIRE(bench.count("cover-axis", "components") == bench.count("medial-axis", "components"));
        REQUIRE(bench.count("cover-axis", "cycles") == bench.count("medial-axis", "cycles"));
      }
    }
  }
}

TEST_CASE(
    "what is kept holds a share of the shape that falls from one, and is that of a disk where one ball is kept") {
  TestBench bench;
  bench.show({"lambda-kept-boundary", "angle-kept-boundary", "cover-kept-boundary", "a-union-boundary"});
  bench.replace(noisy_trefoil(150, 4.0, 2));
  for (const std::string_view balls : {"lambda-union", "angle-union", "cover-union"}) {
    CHECK(bench.measure(balls, "share_of_shape") == Approx(1.0).epsilon(1e-12));
    CHECK(bench.measure(balls, "area") == Approx(bench.measure("a-union", "area")).epsilon(1e-12));
  }
  double before = 1.0;
  for (const double limit : {5.0, 20.0, 40.0, 60.0}) {
    bench.choose(limits_in_mode(limit, limit, false));
    const double share = bench.measure("lambda-union", "share_of_shape");
    CHECK(share <= before * (1.0 + 1e-12));
    CHECK(share > 0.0);
    before = share;
  }
  CHECK(before < 0.9);
  // Below the angle at the ends of the kept parts, cuts are balls too: as much as points along the edges hold.
  bench.choose(limits_in_mode(0.0, 60.0, false));
  const auto& delaunay = bench.get<Delaunay>();
  const auto& angle = bench.get<AngleAxis>();
  std::vector<Disk> along;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!delaunay.edge(edge).is_alive() || !angle.is_kept(edge)) continue;
    for (int i = 0; i <= 8; ++i) {
      const Vec2 a = angle.kept_end(edge, 0);
      const Vec2 at = a + (i / 8.0) * (angle.kept_end(edge, 1) - a);
      along.push_back({at, distance(at, delaunay.site_position(delaunay.edge(edge).v[0]))});
    }
  }
  for (const FaceSlot node : delaunay.face_slots())
    if (delaunay.is_finite_face(node) && angle.is_kept(node))
      along.push_back({delaunay.circumcenter(node), delaunay.circumradius(node)});
  Rng rng(9);
  std::size_t inside = 0;
  constexpr std::size_t kThrown = 200000;
  for (std::size_t i = 0; i < kThrown; ++i) {
    const Vec2 p{rng.uniform(-140.0, 140.0), rng.uniform(-140.0, 140.0)};
    inside += std::ranges::any_of(along, [&](const Disk& disk) { return distance(disk.center, p) <= disk.radius; });
  }
  const double area = 280.0 * 280.0 * static_cast<double>(inside) / static_cast<double>(kThrown);
  CHECK(bench.measure("angle-union", "area") == Approx(area).epsilon(0.01));
}

TEST_CASE(
    "the ball of an open place has no more of the shape than its triangle, and thin triangles no area that is none") {
  // A square whose right side is nearly open: the ball behind the gap reaches far beyond the shape.
  std::vector<Vec2> samples;
  for (int i = 0; i < 40; ++i) {
    const double t = -1.0 + 0.05 * i;
    samples.push_back({t, -1.0});
    samples.push_back({-1.0, -t});
    samples.push_back({-t, 1.0});
  }
  samples.push_back({1.0, 1.0});
  samples.push_back({1.0, -1.0});
  TestBench bench;
  bench.show({"lambda-kept-boundary"});
  bench.replace(samples);
  const auto& delaunay = bench.get<Delaunay>();
  const auto& lambda = bench.get<LambdaAxis>();
  const auto& balls = bench.get<InnerBalls>();
  for (const double limit : {0.0, 0.1, 0.5, 0.9}) {
    bench.choose(limits_in_mode(limit, 0.0, false));
    // Points thrown at the triangles inside: how many lie in a kept ball.
    std::vector<FaceSlot> kept;
    for (const FaceSlot face : delaunay.face_slots())
      if (delaunay.is_finite_face(face) && lambda.is_kept(face)) kept.push_back(face);
    Rng rng(3);
    double whole = 0.0;
    double held = 0.0;
    for (const FaceSlot face : delaunay.face_slots()) {
      if (!delaunay.is_finite_face(face) || !balls.is_ball(face)) continue;
      const FaceRow& row = delaunay.face(face);
      const Vec2 a = delaunay.site_position(row.v[0]);
      const Vec2 u = delaunay.site_position(row.v[1]) - a;
      const Vec2 v = delaunay.site_position(row.v[2]) - a;
      const double area = 0.5 * cross(u, v);
      constexpr int kThrown = 400;
      int inside = 0;
      for (int i = 0; i < kThrown; ++i) {
        double s = rng.uniform();
        double t = rng.uniform();
        if (s + t > 1.0) {
          s = 1.0 - s;
          t = 1.0 - t;
        }
        const Vec2 p = a + s * u + t * v;
        inside += std::ranges::any_of(kept, [&](FaceSlot one) {
          return distance(delaunay.circumcenter(one), p) <= delaunay.circumradius(one);
        });
      }
      whole += area;
      held += area * inside / kThrown;
    }
    INFO("limit " << limit);
    CHECK(bench.measure("lambda-union", "shape_area") == Approx(whole).epsilon(1e-9));
    CHECK(bench.measure("lambda-union", "share_of_shape") == Approx(held / whole).margin(0.02));
    if (limit == 0.0) CHECK(bench.measure("lambda-union", "share_of_shape") == Approx(1.0).epsilon(1e-9));
  }
  // Triangles without height: circles that no double holds.
  bench.choose(limits_in_mode(0.0, 0.0, false));
  for (const int exponent : {0, 430, -400}) {
    for (const double height : {1e-12, 1e-20, 1e-28}) {
      std::vector<Vec2> thin{{0, 0}, {1, height}, {2, 0}, {3, height}, {1.5, -height}, {1.5, 2 * height}};
      for (Vec2& p : thin) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      bench.replace(thin);
      for (const Stat& stat : bench.get<LambdaUnion>().statistics()) {
        INFO(stat.key << " exponent " << exponent << " height " << height);
        if (const double* const value = std::get_if<double>(&stat.value)) CHECK_FALSE(std::isnan(*value));
      }
    }
  }
}

TEST_CASE("where nothing is kept the statistics say why") {
  const auto why = [](const std::vector<Vec2>& samples, const ComputationSettings& settings) {
    TestBench bench;
    show_filters(bench);
    bench.choose(settings);
    bench.replace(samples);
    check_finite(bench);
    return bench.get<LambdaAxis>().reason();
  };
  const ComputationSettings none;
  CHECK_THAT(why({}, none), Catch::Contains("fewer than three samples"));
  CHECK_THAT(why({{1, 2}}, none), Catch::Contains("fewer than three samples"));
  CHECK_THAT(why({{0, 0}, {1, 0}}, none), Catch::Contains("fewer than three samples"));
  CHECK_THAT(why({{0, 0}, {1, 0}, {2, 0}}, none), Catch::Contains("on a line"));
  // The axis of a circle is its centre, which is kept until the limit is above its radius.
  CHECK(why({{0, 0}, {1, 0}, {0.5, 0.9}}, none).empty());
  CHECK(why(lattice_circle().positions, none).empty());
  CHECK_THAT(why({{0, 0}, {1, 0}, {0.5, 0.9}}, limits_in_mode(10.0, 0.0, false)),
             Catch::Contains("above every value"));
  CHECK_THAT(why(noisy_trefoil(60, 1.0, 1), limits_in_mode(1e5, 0.0, false)), Catch::Contains("above every value"));
  CHECK(why(noisy_trefoil(60, 1.0, 1), none).empty());
}
