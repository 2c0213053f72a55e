// SPDX-License-Identifier: GPL-3.0-or-later
// The same input in another unit of length: what is drawn is the same in that unit, bit for bit.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/power_of_two.h"
#include "core/base/rng.h"
#include "core/kernel/roots_kernel.h"
#include "core/kernel/rounding.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

SampleData in_unit(SampleData data, int exponent) {
  const auto scaled = [exponent](Vec2 p) { return Vec2{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; };
  for (Vec2& p : data.positions) p = scaled(p);
  for (Disk& disk : data.balls) disk = {scaled(disk.center), std::ldexp(disk.radius, exponent)};
  return data;
}

// Coordinates scale. Scalars are lengths, or numbers without unit; directions of rays and lines are either.
std::string difference(const TestBench& unit, const TestBench& other, int exponent) {
  for (const LayerIndex layer : all_layers()) {
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      const auto a = unit.mirror().instances(layer, kind);
      const auto b = other.mirror().instances(layer, kind);
      const std::string where = std::string(layer_descriptors()[layer].id) + ", " + std::string(name_of(kind));
      if (a.size() != b.size()) return where + ": another number of instances";
      const bool has_direction = kind == PrimitiveKind::ray || kind == PrimitiveKind::line;
      for (std::size_t i = 0; i < a.size(); ++i) {
        const std::size_t column = i % stride_of(kind);
        const bool may_stay = column + 1 == stride_of(kind) || (has_direction && column >= 2);
        if (b[i] != std::ldexp(a[i], exponent) && !(may_stay && b[i] == a[i]))
          return where + ": " + std::to_string(a[i]) + " became " + std::to_string(std::ldexp(b[i], -exponent)) +
                 " in units of 2^" + std::to_string(exponent);
      }
    }
  }
  return {};
}

SampleData small_integers() {
  SampleData data;
  for (const auto& [x, y] : {std::pair{0, 0}, {4, -1}, {8, 0}, {9, 3}, {7, 6}, {3, 7}, {-1, 4}, {5, 3}})
    data.positions.push_back({static_cast<double>(x), static_cast<double>(y)});
  data.balls = {{{7.5, 0}, 2.5}, {{1.25, 6.25}, 3.75}, {{5, 3.75}, 3.75}, {{3, 1}, 2}};
  return data;
}

SampleData random_doubles() {
  Rng rng(3);
  SampleData data;
  for (int i = 0; i < 40; ++i) data.positions.push_back({rng.uniform(-1.0, 3.0), rng.uniform(-2.0, 2.0)});
  for (int i = 0; i < 20; ++i)
    data.balls.push_back({{rng.uniform(-1.0, 3.0), rng.uniform(-2.0, 2.0)}, rng.uniform(0.1, 0.9)});
  return data;
}

}  // namespace

TEST_CASE("a product with a power of two is what the C library makes of it, to the last bit") {
  Rng rng(5);
  for (int i = 0; i < 200'000; ++i) {
    const auto x = std::bit_cast<double>(rng.next());
    const int exponent = static_cast<int>(rng.below(4400)) - 2200;
    const double product = times_power_of_two(x, exponent);
    INFO(x << " times 2^" << exponent);
    if (std::isnan(x))
      REQUIRE(std::isnan(product));
    else
      REQUIRE(std::bit_cast<std::uint64_t>(product) == std::bit_cast<std::uint64_t>(std::ldexp(x, exponent)));
  }
}

TEST_CASE("every layer scales with its input by powers of two, bit for bit") {
  struct Run {
    const char* name;
    SampleData data;
    Precision precision;
    std::vector<int> exponents;
  };
  const std::vector<int> spread{-400, -213, -70, -52, -1, 3, 52, 70, 100, 251, 400};
  for (const Run& run : {Run{"whole numbers", small_integers(), Precision::fast, spread},
                         Run{"whole numbers", small_integers(), Precision::exact, spread},
                         Run{"whole numbers", small_integers(), Precision::exact_roots, {-400, 70, 100, 400}},
                         Run{"random numbers", random_doubles(), Precision::fast, spread},
                         Run{"random numbers", random_doubles(), Precision::exact, {-400, 70, 100, 400}}}) {
    ComputationSettings settings;
    settings.precision = run.precision;
    TestBench unit;
    unit.choose(settings);
    unit.load(run.data);
    for (const int exponent : run.exponents) {
      INFO(run.name << " in " << id_of(run.precision));
      TestBench other;
      other.choose(settings);
      other.load(in_unit(run.data, exponent));
      CHECK(difference(unit, other, exponent) == "");
    }
  }
}

TEST_CASE("exact numbers become the nearest double") {
  Rng rng(4);
  using Rational = ExactKernel::FT;
  using Root = RootsKernel::FT;
  for (int i = 0; i < 2000; ++i) {
    // Division and square root of doubles are rounded correctly by the processor.
    const double a = std::ldexp(rng.uniform(1.0, 2.0), static_cast<int>(rng.below(80)) - 40);
    const double b = std::ldexp(rng.uniform(1.0, 2.0), static_cast<int>(rng.below(80)) - 40);
    CHECK(rounded(Rational(Rational(a) / Rational(b))) == a / b);
    CHECK(rounded(Rational(Rational(-a) + Rational(b))) == b - a);
    if (i >= 200) continue;
    const double small = std::ldexp(rng.uniform(1.0, 4.0), -2 - static_cast<int>(rng.below(60)));
    CHECK(rounded(Root(CGAL::sqrt(Root(small)))) == std::sqrt(small));
    CHECK(rounded(Root(Root(a) / Root(b))) == a / b);
  }
  // Five digits are left of the interval that stands for it, and then none.
  const Root root = CGAL::sqrt(Root(1) + Root(0x1p-40)) - Root(1);
  CHECK(rounded(root) == Approx(0x1p-41).epsilon(1e-11));
  CHECK(rounded(root) != 0x1p-41);
  CHECK(rounded(Root(CGAL::sqrt(Root(2)) * CGAL::sqrt(Root(3)) - CGAL::sqrt(Root(6)))) == 0.0);
}
