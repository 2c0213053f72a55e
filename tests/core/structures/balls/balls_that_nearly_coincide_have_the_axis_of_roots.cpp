// SPDX-License-Identifier: GPL-3.0-or-later
// Balls that nearly coincide, by default, against algebraic numbers throughout: their circles cross where no rounded number
// can say in which order.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/balls/ball_union.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::string_view kCounts[] = {"visible",      "hidden",        "duplicates", "dual_singular",
                                        "dual_regular", "dual_interior", "dual_faces", "v_points",
                                        "components",   "cycles",        "chi",        "chi_dual"};

struct UnionBench : TestBench {
  UnionBench(const std::vector<Disk>& balls, Precision precision) {
    SampleData data;
    data.balls = balls;
    load(data);
    show({"b-ball-medial-axis", "b-union-boundary"});
    ComputationSettings settings;
    settings.precision = precision;
    choose(settings);
  }
};

void check(const std::vector<Disk>& balls) {
  const UnionBench now(balls, ComputationSettings().precision);
  const UnionBench roots(balls, Precision::exact_roots);
  REQUIRE(now.get<BUnion>().is_exact());
  for (const std::string_view key : kCounts) {
    INFO(key);
    CHECK(now.count("b-union", key) == roots.count("b-union", key));
  }
  CHECK(now.count("b-union", "chi") == now.count("b-union", "chi_dual"));
  for (const std::string_view key : {"length", "area", "perimeter"}) {
    INFO(key);
    CHECK(now.measure("b-union", key) == Approx(roots.measure("b-union", key)).epsilon(1e-9).margin(1e-9));
  }
}

}  // namespace

TEST_CASE("three balls that nearly have a common crossing have the axis of algebraic numbers") {
  const std::vector<Disk> balls{{{-0.4685863969593351, -0.1047404757719623}, 0.4801497461003896},
                                {{0.17058667974302025, -0.6053079656845981}, 0.6288859583636561},
                                {{0.7709095306327052, 0.4498958974216913}, 0.8925849107716346}};
  check(balls);
  const UnionBench now(balls, ComputationSettings().precision);
  CHECK(now.count("b-union", "cycles") == 0);
  CHECK(now.measure("b-union", "length") == Approx(1.95).epsilon(5e-3));
}

TEST_CASE("balls that nearly coincide have the axis of algebraic numbers") {
  Rng rng(61);
  for (int round = 0; round < 24; ++round) {
    const double apart = std::pow(10.0, -4.0 - static_cast<double>(rng.below(13)));
    std::vector<Disk> balls;
    for (std::size_t i = 0; i < 3 + rng.below(3); ++i)
      balls.push_back({{0.25 + apart * (rng.uniform() - 0.5), 0.5 + apart * (rng.uniform() - 0.5)},
                       1.0 + (round % 2 == 0 ? 0.5 * apart * (rng.uniform() - 0.5) : 0.0)});
    if (round % 3 == 0) balls.push_back({{1.5, 0.75}, 0.875});
    INFO("round " << round << ", " << apart << " apart");
    check(balls);
  }
}

TEST_CASE("balls whose circles nearly pass through one point have the axis of algebraic numbers") {
  Rng rng(62);
  for (int round = 0; round < 24; ++round) {
    const Vec2 point{rng.uniform(), rng.uniform()};
    std::vector<Disk> balls;
    for (std::size_t i = 0; i < 3 + rng.below(3); ++i) {
      const Vec2 center{2.0 * rng.uniform() - 1.0, 2.0 * rng.uniform() - 1.0};
      balls.push_back({center, distance(center, point)});
    }
    INFO("round " << round);
    check(balls);
  }
}

TEST_CASE("the scale axis has no spike where grown balls nearly coincide") {
  TestBench bench(std::vector<Vec2>{{-2.0, -0.5781990574077289},
                                    {-1.9975908332864736, -0.6232165373127738},
                                    {-1.994585829313344, -0.645564414630485},
                                    {-1.8374406862108463, -0.9109298991811283},
                                    {-1.719299824836558, -0.9756995084800815},
                                    {-1.5867627754613811, -0.999913057536757},
                                    {2.0, -0.15473092897255558},
                                    {2.0, -0.14345508302824417}});
  bench.show({"scale-axis"});
  double lengths[2];
  for (const Precision precision : {ComputationSettings().precision, Precision::exact}) {
    ComputationSettings settings;
    settings.precision = precision;
    settings[Parameter::scale_axis_factor] = 1.0961402189483533;
    bench.choose(settings);
    lengths[precision == Precision::exact ? 1 : 0] = bench.measure("scale-union", "length");
    CHECK(bench.count("scale-union", "chi") == bench.count("scale-union", "chi_dual"));
  }
  CHECK(lengths[0] == Approx(1.7377).epsilon(1e-4));
  CHECK(lengths[0] == lengths[1]);
}
