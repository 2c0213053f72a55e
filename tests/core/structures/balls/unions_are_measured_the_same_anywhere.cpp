// SPDX-License-Identifier: GPL-3.0-or-later
// Area, perimeter and axis length of unions of balls: against circles cut by intervals one by one, and for the same
// balls far from the origin and in other units.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/geometry/arc.h"
#include "core/base/rng.h"
#include "core/structures/balls/ball_union.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

struct Measured {
  double area = 0.0;
  double perimeter = 0.0;
};

// Of balls with small whole numbers, by what each circle has outside of all other balls. Coverings are decided in
// whole numbers; covers that meet in one point are distinguished from a gap by 1e-9, less than which circles of such numbers
// never leave.
Measured measured_by_intervals(const std::vector<Disk>& disks) {
  Measured out;
  for (std::size_t i = 0; i < disks.size(); ++i) {
    const Vec2 c = disks[i].center;
    const double r = disks[i].radius;
    bool is_hidden = false;
    std::vector<std::pair<double, double>> covers;
    for (std::size_t j = 0; j < disks.size() && !is_hidden; ++j) {
      if (i == j) continue;
      const Vec2 d = disks[j].center - c;
      const double other = disks[j].radius;
      const double square = dot(d, d);
      if (other >= r && square <= (other - r) * (other - r)) {
        is_hidden = !(disks[i] == disks[j]) || j < i;
      } else if (square < (r + other) * (r + other) && !(r >= other && square <= (r - other) * (r - other))) {
        const double half = std::acos((square + r * r - other * other) / (2.0 * r * std::sqrt(square)));
        const double middle = std::atan2(d.y, d.x);
        const double from = std::remainder(middle - half, 2.0 * kHalfTurn) + kHalfTurn;  // in [0, 2 pi]
        covers.emplace_back(from, from + 2.0 * half);
      }
    }
    if (is_hidden) continue;
    const auto add = [&](double from, double to) {
      // Angles are turned by pi above.
      out.perimeter += r * (to - from);
      out.area +=
          0.5 * r * (r * (to - from) - c.x * (std::sin(to) - std::sin(from)) + c.y * (std::cos(to) - std::cos(from)));
    };
    if (covers.empty()) {
      add(0.0, 2.0 * kHalfTurn);
      continue;
    }
    std::ranges::sort(covers);
    // Twice around: what the first round reaches beyond the start counts in the second.
    double reached = covers.front().second;
    for (std::size_t k = 1; k <= 2 * covers.size(); ++k) {
      const double round = 2.0 * kHalfTurn * static_cast<double>(k / covers.size());
      const auto& [from, to] = covers[k % covers.size()];
      if (k > covers.size() && from + round > reached + 1e-9) add(reached, from + round);
      reached = std::max(reached, to + round);
    }
  }
  return out;
}

Measured measured(const TestBench& bench) {
  return {bench.measure("b-union", "area"), bench.measure("b-union", "perimeter")};
}

double length_of_arcs(const TestBench& bench, std::string_view layer) {
  double length = 0.0;
  const auto arcs = bench.instances(layer, PrimitiveKind::arc);
  for (std::size_t at = 0; at < arcs.size(); at += stride_of(PrimitiveKind::arc)) {
    const double* const v = arcs.data() + at;
    length += v[2] * sweep_of(Arc{{v[0], v[1]}, v[2], {v[3], v[4]}, {v[5], v[6]}});
  }
  return length;
}

ComputationSettings in(Precision precision) {
  ComputationSettings out;
  out.precision = precision;
  return out;
}

void show_boundary(TestBench& bench, Precision precision) {
  bench.show({"b-union-boundary"});
  bench.choose(in(precision));
}

// Many circles that touch, lie on or in each other, or meet in one point.
std::vector<Disk> coincidences(Rng& rng) {
  std::vector<Disk> disks(2 + rng.below(6));
  for (Disk& disk : disks)
    disk = {{static_cast<double>(rng.below(7)), static_cast<double>(rng.below(7))},
            static_cast<double>(1 + rng.below(5))};
  return disks;
}

}  // namespace

TEST_CASE("a covered circle that reaches the boundary of the union in one point adds nothing to it") {
  // The third ball lies in the other two, and its lowest point is one of their crossings.
  const std::vector<Disk> disks{{{3, 0}, 5}, {{-3, 0}, 5}, {{0, -2}, 2}};
  const Measured expected = measured_by_intervals(disks);
  CHECK(expected.area == Approx(134.715).margin(1e-3));
  for (const double scale : {1.0, 0.5}) {
    for (const Precision precision : {Precision::naive, Precision::fast, Precision::exact, Precision::exact_roots}) {
      INFO(id_of(precision) << ", scale " << scale);
      TestBench bench;
      bench.show({"b-union-boundary"});
      ComputationSettings settings = in(precision);
      settings[Parameter::b_scale] = scale;
      bench.choose(settings);
      std::vector<Disk> given = disks;
      for (Disk& disk : given) disk.radius /= scale;
      bench.insert_balls(given);
      CHECK(bench.measure("b-union", "area") == Approx(expected.area).epsilon(1e-13));
      CHECK(bench.measure("b-union", "perimeter") == Approx(expected.perimeter).epsilon(1e-13));
      CHECK(length_of_arcs(bench, "b-union-boundary") == Approx(expected.perimeter).epsilon(1e-13));
      CHECK(bench.instances("b-union-boundary", PrimitiveKind::arc).size() == 2 * stride_of(PrimitiveKind::arc));
    }
  }
}

TEST_CASE("a ball touched from outside in one point keeps its whole circle") {
  for (const Precision precision : {Precision::naive, Precision::fast, Precision::exact, Precision::exact_roots}) {
    INFO(id_of(precision));
    TestBench bench;
    show_boundary(bench, precision);
    bench.insert_balls({{{0, 0}, 5}, {{6, 8}, 5}, {{20, 0}, 1}});
    CHECK(bench.measure("b-union", "perimeter") == Approx(22.0 * kHalfTurn).epsilon(1e-14));
    CHECK(bench.measure("b-union", "area") == Approx(51.0 * kHalfTurn).epsilon(1e-14));
    CHECK(length_of_arcs(bench, "b-union-boundary") == Approx(22.0 * kHalfTurn).epsilon(1e-13));
  }
}

TEST_CASE("ends of an arc that are rounded to one double leave it the circle or nothing, whichever it nearly is") {
  // The small ball covers so little of the large circle that both crossings have the same coordinates as doubles.
  const double tiny = 0x1p-60;
  for (const Precision precision : {Precision::fast, Precision::exact, Precision::exact_roots}) {
    INFO(id_of(precision));
    TestBench bench;
    show_boundary(bench, precision);
    bench.insert_balls({{{0, 0}, 5}, {{3, 4}, tiny}});
    CHECK(bench.measure("b-union", "area") == Approx(25.0 * kHalfTurn).epsilon(1e-14));
    CHECK(bench.measure("b-union", "perimeter") == Approx(10.0 * kHalfTurn).epsilon(1e-14));
    CHECK(length_of_arcs(bench, "b-union-boundary") == Approx(10.0 * kHalfTurn).epsilon(1e-14));
  }
  // The circle in the middle is covered but for two arcs of some 1e-15; were the last radius 13, but for two points.
  for (const Precision precision : {Precision::fast, Precision::exact, Precision::exact_roots}) {
    INFO(id_of(precision));
    std::vector<Disk> disks{{{1000, 0}, 5}, {{1012, 0}, 13}, {{988, 0}, 13}};
    const Measured closed = measured_by_intervals(disks);
    for (const double radius : {13.0, 13.0 - 0x1p-49}) {
      disks.back().radius = radius;
      TestBench bench;
      show_boundary(bench, precision);
      bench.insert_balls(disks);
      CHECK(bench.measure("b-union", "area") == Approx(closed.area).epsilon(1e-12));
      CHECK(bench.measure("b-union", "perimeter") == Approx(closed.perimeter).epsilon(1e-12));
      CHECK(length_of_arcs(bench, "b-union-boundary") == Approx(closed.perimeter).epsilon(1e-12));
    }
  }
}

TEST_CASE("unions full of coincidences have the area and perimeter of their circles taken one by one") {
  struct Runs {
    Precision precision;
    int count;
  };
  for (const auto& [precision, count] :
       {Runs{Precision::fast, 1500}, Runs{Precision::exact, 150}, Runs{Precision::exact_roots, 30}}) {
    Rng rng(5);
    TestBench bench;
    show_boundary(bench, precision);
    for (int trial = 0; trial < count; ++trial) {
      const std::vector<Disk> disks = coincidences(rng);
      INFO(id_of(precision) << ", trial " << trial);
      SampleData data;
      data.balls = disks;
      bench.load(data);
      const Measured expected = measured_by_intervals(disks);
      const Measured found = measured(bench);
      REQUIRE(found.area == Approx(expected.area).epsilon(1e-11));
      REQUIRE(found.perimeter == Approx(expected.perimeter).epsilon(1e-11));
      REQUIRE(length_of_arcs(bench, "b-union-boundary") == Approx(expected.perimeter).epsilon(1e-7));
    }
  }
}

TEST_CASE("a union has the same measures however far from the origin it lies") {
  Rng rng(8);
  std::vector<Disk> near(40);
  for (Disk& disk : near)
    disk = {{static_cast<double>(rng.below(4096)) / 256.0, static_cast<double>(rng.below(4096)) / 256.0},
            static_cast<double>(128 + rng.below(384)) / 256.0};
  for (const Precision precision : {Precision::fast, Precision::exact}) {
    TestBench home;
    show_boundary(home, precision);
    home.insert_balls(near);
    for (const Vec2 way : {Vec2{0x1p44, 0x1p44}, {-0x1p44, 3.0}, {0x1p30, -0x1p43}, {1e9, 1e9}}) {
      INFO(id_of(precision) << ", by " << way.x << " " << way.y);
      std::vector<Disk> far = near;
      for (Disk& disk : far) disk.center = disk.center + way;
      REQUIRE(far.front().center - way == near.front().center);
      TestBench bench;
      show_boundary(bench, precision);
      bench.insert_balls(far);
      for (const char* key : {"area", "perimeter", "length"})
        CHECK(bench.measure("b-union", key) == Approx(home.measure("b-union", key)).epsilon(1e-12));
      for (const char* key : {"v_points", "nodes", "edges", "dual_edges", "dual_faces", "contradictions"})
        CHECK(bench.count("b-union", key) == home.count("b-union", key));
    }
  }
  // Three balls of which the area is known.
  TestBench bench;
  show_boundary(bench, Precision::fast);
  bench.insert_balls({{{1e9, 1e9}, 2}, {{1e9 + 3, 1e9}, 1.5}, {{1e9 + 1, 1e9 + 2.5}, 1.75}});
  CHECK(bench.measure("b-union", "area") == Approx(26.743).margin(1e-3));
}

TEST_CASE("what is measured of samples is the same however far from the origin they lie") {
  std::vector<Vec2> near;
  for (const Vec2 p : ellipse(6, 3, 90, {.offset = 0.3, .jitter = 0.1}).data.positions)
    near.push_back({std::round(p.x * 256.0) / 256.0, std::round(p.y * 256.0) / 256.0});
  for (const bool use_shortcut : {true, false}) {
    ComputationSettings settings = in(Precision::exact);
    settings[Parameter::union_shortcut] = use_shortcut ? 1.0 : 0.0;
    const auto show = [&settings](TestBench& bench) {
      bench.show({"medial-axis", "curve-normals", "a-union-boundary", "a-ball-medial-axis", "power-crust"});
      bench.choose(settings);
    };
    TestBench home;
    show(home);
    home.insert(near);
    REQUIRE((home.get<AUnion>().rung() == UnionRung::shortcut) == use_shortcut);
    for (const Vec2 way : {Vec2{0x1p44, 0x1p44}, {-0x1p44, 0x1p20}}) {
      INFO("shortcut " << use_shortcut << ", by " << way.x << " " << way.y);
      std::vector<Vec2> far = near;
      for (Vec2& p : far) p = p + way;
      TestBench bench;
      show(bench);
      bench.insert(far);
      for (const char* key : {"area", "perimeter", "length"})
        CHECK(bench.measure("a-union", key) == Approx(home.measure("a-union", key)).epsilon(1e-12));
      for (const char* structure : {"medial-axis", "curve"})
        CHECK(bench.measure(structure, "length") == Approx(home.measure(structure, "length")).epsilon(1e-12));
      // The large balls that stand for half planes are placed in the document, and rounded there.
      CHECK(bench.measure("power-crust", "length") == Approx(home.measure("power-crust", "length")).epsilon(1e-9));
      CHECK(bench.measure("curve", "area") == Approx(home.measure("curve", "area")).epsilon(1e-12));
      CHECK(bench.count("a-union", "edges") == home.count("a-union", "edges"));
    }
  }
}

TEST_CASE("the two ways to the union of certified balls measure the same") {
  for (const TestShape& shape : oracle_shapes(0.25, {.offset = 0.3, .jitter = 0.1})) {
    INFO(shape.name);
    TestBench bench;
    bench.show({"a-union-boundary"});
    bench.load(shape.data);
    ComputationSettings settings = in(Precision::exact);
    bench.choose(settings);
    REQUIRE(bench.get<AUnion>().rung() == UnionRung::shortcut);
    const double area = bench.measure("a-union", "area");
    const double perimeter = bench.measure("a-union", "perimeter");
    const double length = bench.measure("a-union", "length");
    settings[Parameter::union_shortcut] = 0.0;
    bench.choose(settings);
    REQUIRE(bench.get<AUnion>().rung() == UnionRung::rational);
    CHECK(bench.measure("a-union", "area") == Approx(area).epsilon(1e-12));
    CHECK(bench.measure("a-union", "perimeter") == Approx(perimeter).epsilon(1e-12));
    CHECK(bench.measure("a-union", "length") == Approx(length).epsilon(1e-12));
  }
}
