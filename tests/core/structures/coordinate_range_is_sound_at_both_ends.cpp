// SPDX-License-Identifier: GPL-3.0-or-later
// Samples and balls whose magnitudes mix both ends of the permitted range, 2^100 apart, at both ends of the absolute
// range and between them: flat triangles, collinear and cocircular points, duplicates, zeros.
//
// That every node is up to date and every number in a patch is finite is required by the workbench itself.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "core/base/rng.h"
#include "core/kernel/circumcircle.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/density/feature_size.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// Numbers whose binary exponents lie between top - 100 and top.
class Numbers {
 public:
  Numbers(std::uint64_t seed, int top) : rng_(seed), top_(top) {}

  double magnitude() {
    const double mantissa = rng_.below(2) == 0 ? 1.0 : 1.0 + rng_.uniform();
    const auto below = [this](std::uint64_t n) { return static_cast<int>(rng_.below(n)); };
    const int drop = std::array{0, 100, below(101), 50, below(3), 100 - below(3)}[rng_.below(6)];
    return std::ldexp(mantissa, top_ - drop);
  }
  double number() {
    if (rng_.below(5) == 0) return 0.0;
    return (rng_.below(2) == 0 ? -1.0 : 1.0) * magnitude();
  }
  std::vector<Vec2> points(std::size_t n) {
    std::vector<Vec2> out;
    while (out.size() < n) {
      if (!out.empty() && rng_.below(8) == 0) {
        out.push_back(out[rng_.below(out.size())]);
        continue;
      }
      const double x = number();
      out.push_back({x, number()});
    }
    return out;
  }
  std::vector<Disk> balls(std::size_t n) {
    std::vector<Disk> out;
    for (const Vec2 p : points(n)) out.push_back({p, rng_.below(8) == 0 ? 0.0 : magnitude()});
    return out;
  }
  std::size_t below(std::size_t n) { return rng_.below(n); }

 private:
  Rng rng_;
  int top_;
};

/// Triangles as flat as there are, points on a line, on a circle, each with both ends of the range.
std::vector<std::vector<Vec2>> special_cases(int top) {
  const double large = std::ldexp(1.0, top);
  const double small = std::ldexp(1.0, top - 100);
  const double larger = std::nextafter(2.0 * large, 0.0);
  std::vector<std::vector<Vec2>> out{
      {{0, 0}, {larger, 0}, {large, small}},
      {{0, 0}, {larger, 0}, {large, small}, {large, -small}},
      {{-large, 0}, {large, 0}, {0, small}, {0, -large}, {small, 0}},
      {{0, 0}, {small, 0}, {larger, larger}},
      // One unit in the last place off a line.
      {{large, large}, {1.5 * large, std::nextafter(1.5 * large, larger)}, {larger, larger}},
      {{small, small}, {1.5 * small, std::nextafter(1.5 * small, large)}, {large, large}, {-large, -large}},
      {{small, small}, {large, large}, {-small, -small}, {-large, -large}, {0, 0}},
      {{small, 0}, {0, small}, {-small, 0}, {0, -small}, {large, 0}, {0, large}, {-large, 0}, {0, -large}},
      {{larger, larger}, {-larger, larger}, {-larger, -larger}, {larger, -larger}, {0, 0}, {small, small}},
  };
  std::vector<Vec2> circle;
  for (const Vec2 p : lattice_circle().positions)
    circle.push_back({std::ldexp(p.x, top - 6), std::ldexp(p.y, top - 6)});
  out.push_back(circle);
  circle.push_back({small, 0});
  circle.push_back({-small, small});
  out.push_back(std::move(circle));
  return out;
}

ComputationSettings with(Precision precision) {
  ComputationSettings out;
  out.precision = precision;
  return out;
}

/// Where the largest magnitude may be.
constexpr std::array kTops{-400, -250, 0, 180, 350, 499};

void require_exact_decisions(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& crust = bench.get<OneStepCrust>();
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!delaunay.edge(edge).is_alive() || delaunay.dimension() < 2) continue;
    const EdgeCorners corners = crust.corners(edge);
    const ExactEdge exact = exact_edge(corners);
    if (!exact.is_delaunay() || exact.is_crust() != crust.is_crust(edge) ||
        exact.is_cocircular() != crust.is_cocircular(edge))
      FAIL("an edge is not decided as exact arithmetic does");
  }
}

// Above this exponent the area of a circumdisk may be no double.
constexpr int kLargestWithArea = 180;

/// A least or a largest number of nothing is infinite.
bool is_about_nothing(const TestBench& bench, std::string_view structure, std::string_view key) {
  if (structure == "lambda-axis" && key == "weak_feature_size") return bench.count(structure, "critical_values") == 0;
  if (structure == "lambda-axis" || structure == "angle-axis")
    return key == "largest" && bench.count("medial-axis", "nodes") == 0;
  // Edges at corners and ends of the curve do not count.
  if (structure == "feature-size" && key == "epsilon") return bench.get<FeatureSize>().sparsest_edge() == kNoSlot;
  if (structure == "feature-size") return bench.count(structure, "samples") == 0;
  return key.starts_with("radius_m") && bench.count(structure, structure == "medial-axis" ? "nodes" : "balls") == 0;
}

// Nothing else is, and nothing is NaN.
void require_finite_statistics(const TestBench& bench, int top) {
  for (const NodeReport& node : bench.patch().nodes) {
    for (const Stat& stat : node.stats) {
      const double* value = std::get_if<double>(&stat.value);
      if (value == nullptr || std::isfinite(*value)) continue;
      if (stat.key == "area" && top > kLargestWithArea && node.structure != "b-union") continue;
      INFO(node.structure << " " << stat.key << " " << *value);
      CHECK(is_about_nothing(bench, node.structure, stat.key));
    }
  }
}

void require_nothing_missing(const TestBench& bench, const std::vector<Disk>& balls) {
  const auto& delaunay = bench.get<Delaunay>();
  std::size_t faces = 0;
  std::size_t inner = 0;
  std::size_t edges = 0;
  for (const FaceSlot face : delaunay.face_slots()) {
    if (!delaunay.face(face).is_alive() || !delaunay.is_finite_face(face)) continue;
    ++faces;
    inner += bench.get<InnerBalls>().is_ball(face) ? 1U : 0U;
    const double radius = delaunay.circumradius(face);
    if (!(is_finite(delaunay.circumcenter(face)) && std::isnormal(radius))) FAIL("a circumcircle is none");
  }
  for (const EdgeSlot edge : delaunay.edge_slots()) edges += delaunay.edge(edge).is_alive() ? 1U : 0U;
  const auto count = [&](std::string_view layer, PrimitiveKind kind) {
    return bench.contents().count(find_layer(layer), kind);
  };
  CHECK(count("voronoi-circles", PrimitiveKind::circle) == faces);
  CHECK(count("interior-voronoi-disks", PrimitiveKind::disk) == inner);
  CHECK(count("exterior-voronoi-disks", PrimitiveKind::disk) == faces - inner);
  CHECK(count("delaunay", PrimitiveKind::segment) == edges);
  CHECK(count("voronoi", PrimitiveKind::segment) + count("voronoi", PrimitiveKind::ray) +
            count("voronoi", PrimitiveKind::line) ==
        edges);
  const auto zeros = std::ranges::count(balls, 0.0, &Disk::radius);
  CHECK(count("b-inner-disks", PrimitiveKind::disk) == balls.size() - static_cast<std::size_t>(zeros));
  CHECK(count("b-inner-centers", PrimitiveKind::point) == balls.size());
  CHECK(bench.count("b-union", "ignored") == zeros);
  CHECK(bench.count("a-union", "ignored") == 0);
  CHECK(bench.count("p-union", "ignored") == 0);
}

void check(const SampleData& data, int top, Precision precision) {
  TestBench bench;
  bench.choose(with(precision));
  bench.load(data);
  require_exact_decisions(bench);
  require_finite_statistics(bench, top);
  require_nothing_missing(bench, data.balls);
}

std::string text_of(const SampleData& data) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Vec2 p : data.positions) out << "(" << p.x << ", " << p.y << ") ";
  for (const Disk& b : data.balls) out << "(" << b.center.x << ", " << b.center.y << "; " << b.radius << ") ";
  return out.str();
}

}  // namespace

TEST_CASE("the sharpest cases of both ends are computed whole and right") {
  for (const Precision precision : {Precision::fast, Precision::exact}) {
    for (const int top : kTops) {
      for (const std::vector<Vec2>& points : special_cases(top)) {
        const SampleData data{.positions = points};
        INFO("2^" << top << ", precision " << static_cast<int>(precision) << ": " << text_of(data));
        check(data, top, precision);
      }
    }
  }
}

TEST_CASE("a circle through three points is finite and right, however flat the triangle") {
  for (const int top : kTops) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
      Numbers numbers(seed, top);
      const std::vector<Vec2> p = numbers.points(3);
      const std::vector<ExactPoint> exact = as_integers(p);
      const ExactPoint u = exact[1] - exact[0];
      const ExactPoint v = exact[2] - exact[0];
      const mpz_class doubled_area = cross(u, v);
      const Circle circle = circumcircle(p[0], p[1], p[2]);
      INFO(text_of({.positions = p}));
      if (doubled_area == 0) {
        CHECK_FALSE(std::isfinite(circle.radius));
        continue;
      }
      REQUIRE((is_finite(circle.center) && std::isnormal(circle.radius)));
      // The squared radius is |u|^2 |v|^2 |v - u|^2 / 4 D^2, in units of the common exponent.
      const mpz_class sides = dot(u, u) * dot(v, v) * dot(v - u, v - u);
      const double unit = std::ldexp(circle.radius, -common_exponent(p));
      const mpq_class ratio = mpq_class(unit) * mpq_class(unit) * 4 * doubled_area * doubled_area / sides;
      CHECK(std::abs(ratio.get_d() - 1.0) < 0x1p-19);
    }
  }
}

TEST_CASE("a circle of points times a power of two is the circle times that, to the last bit") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const std::vector<Vec2> p = Numbers(seed, 0).points(3);
    const Circle circle = circumcircle(p[0], p[1], p[2]);
    if (!std::isfinite(circle.radius)) continue;
    for (const int k : {-400, -70, -1, 3, 64, 400}) {
      const auto times = [k](Vec2 a) { return Vec2{std::ldexp(a.x, k), std::ldexp(a.y, k)}; };
      const Circle image = circumcircle(times(p[0]), times(p[1]), times(p[2]));
      CHECK(image.center == times(circle.center));
      CHECK(image.radius == std::ldexp(circle.radius, k));
    }
  }
}

namespace {

/// Where instances lie, without scalars; directions of rays and lines have no length of their own. In order.
std::vector<std::vector<double>> places(const TestBench& bench, LayerIndex layer, int k) {
  std::vector<std::vector<double>> out = bench.contents().sorted(layer);
  for (std::vector<double>& instance : out) {
    instance.pop_back();
    const auto kind = static_cast<PrimitiveKind>(static_cast<int>(instance[0]));
    if (kind == PrimitiveKind::ray || kind == PrimitiveKind::line) instance.resize(3);
    for (std::size_t i = 1; i < instance.size(); ++i) instance[i] = std::ldexp(instance[i], -k);
  }
  std::ranges::sort(out);
  return out;
}

}  // namespace

TEST_CASE("samples times a power of two have the same picture times that, to the last bit") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Vec2> points = Numbers(seed, 0).points(8);
    const TestBench bench(points);
    for (const int k : {-400, 400}) {
      std::vector<Vec2> image;
      for (const Vec2 p : points) image.push_back({std::ldexp(p.x, k), std::ldexp(p.y, k)});
      const TestBench other(image);
      for (const LayerIndex layer : all_layers()) {
        const LayerDescriptor& descriptor = layer_descriptors()[layer];
        if (descriptor.group == LayerGroup::union_a || descriptor.group == LayerGroup::union_p) continue;
        INFO(descriptor.id << ", 2^" << k << ": " << text_of({.positions = points}));
        CHECK(places(bench, layer, 0) == places(other, layer, k));
      }
    }
  }
}

TEST_CASE("random mixtures of both ends are computed whole and right") {
  for (const Precision precision : {Precision::fast, Precision::exact}) {
    for (const int top : kTops) {
      for (std::uint64_t seed = 1; seed <= (precision == Precision::fast ? 20U : 4U); ++seed) {
        Numbers numbers(seed, top);
        const std::size_t balls = precision == Precision::fast ? numbers.below(7) : numbers.below(4);
        const SampleData data{.positions = numbers.points(3 + numbers.below(7)), .balls = numbers.balls(balls)};
        INFO("2^" << top << ", seed " << seed << ", precision " << static_cast<int>(precision) << ": "
                  << text_of(data));
        check(data, top, precision);
      }
    }
  }
}
