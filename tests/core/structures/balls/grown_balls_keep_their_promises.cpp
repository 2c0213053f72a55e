// SPDX-License-Identifier: GPL-3.0-or-later
// Additive growth of balls: births and deaths against those of the weighted Cech complex of the definition, reduced as a
// matrix in rationals; the complexes against the exact unions of balls; radii of zero against the alpha complex of samples.
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/alpha/alpha_filtration.h"
#include "core/structures/balls/grown_complex.h"
#include "core/structures/poles/polar_union.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/matrix_reduction.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::array<std::string_view, 6> kGrownLayers{"b-alpha-disks",    "b-alpha-triangles",  "b-alpha-edges",
                                                       "b-alpha-boundary", "b-alpha-components", "b-alpha-holes"};

void show_grown(TestBench& bench) {
  bench.show({kGrownLayers[0], kGrownLayers[1], kGrownLayers[2], kGrownLayers[3], kGrownLayers[4], kGrownLayers[5]});
}

ComputationSettings grown_by(double a) {
  ComputationSettings out;
  out[Parameter::alpha_radius] = a;
  return out;
}

/// Of balls alone, with the layers of their growth.
struct BallBench : TestBench {
  explicit BallBench(const std::vector<Disk>& balls) {
    SampleData data;
    data.balls = balls;
    load(data);
    show_grown(*this);
  }
};

struct ExactBall {
  mpq_class x, y, w;
};
struct ExactCenter {
  mpq_class x, y;
};

ExactBall exact(const Disk& disk) {
  return {mpq_class(disk.center.x), mpq_class(disk.center.y), mpq_class(disk.radius) * mpq_class(disk.radius)};
}
ExactBall exact_circumdisk(const std::array<Vec2, 3>& corner) {
  const mpq_class ax(corner[0].x), ay(corner[0].y);
  const mpq_class bx = mpq_class(corner[1].x) - ax, by = mpq_class(corner[1].y) - ay;
  const mpq_class cx = mpq_class(corner[2].x) - ax, cy = mpq_class(corner[2].y) - ay;
  const mpq_class d = 2 * (bx * cy - by * cx);
  const mpq_class bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const mpq_class ux = (cy * bb - by * cc) / d, uy = (bx * cc - cx * bb) / d;
  return {ax + ux, ay + uy, ux * ux + uy * uy};
}

mpq_class power(const ExactCenter& p, const ExactBall& ball) {
  const mpq_class x = p.x - ball.x, y = p.y - ball.y;
  return x * x + y * y - ball.w;
}

/// Where the largest power of some balls is least, and that power.
struct Lowest {
  ExactCenter at;
  mpq_class value;
};
Lowest lowest(const ExactBall& a) {
  return {{a.x, a.y}, -a.w};
}
Lowest lowest(const ExactBall& a, const ExactBall& b) {
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    if (const Lowest at = lowest(*one); power(at.at, *other) <= at.value) return at;
  const mpq_class x = b.x - a.x, y = b.y - a.y;
  const mpq_class dd = x * x + y * y;
  const mpq_class t = (dd + a.w - b.w) / (2 * dd);
  const ExactCenter foot{a.x + t * x, a.y + t * y};
  return {foot, power(foot, a)};
}
Lowest lowest(const ExactBall& a, const ExactBall& b, const ExactBall& c) {
  const std::array balls{&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i)
    if (const Lowest two = lowest(*balls[i], *balls[(i + 1) % 3]); power(two.at, *balls[(i + 2) % 3]) <= two.value)
      return two;
  const mpq_class bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const mpq_class p = bx * bx + by * by + a.w - b.w, q = cx * cx + cy * cy + a.w - c.w;
  const mpq_class d = 2 * (bx * cy - by * cx);
  const ExactCenter center{a.x + (p * cy - q * by) / d, a.y + (q * bx - p * cx) / d};
  return {center, power(center, a)};
}

/// Of the Cech complex of all balls; values are powers.
std::vector<ExactBar> cech_bars_of_balls(const std::vector<ExactBall>& balls) {
  return bars_by_reduction(balls.size(), [&balls](auto... corners) { return lowest(balls[corners]...).value; });
}

/// Signed root.
double growth_of(const mpq_class& power) {
  const double size = std::sqrt(std::abs(power.get_d()));
  return power < 0 ? -size : size;
}

struct GrownBar {
  int dimension = 0;
  double birth = 0.0;
  bool dies = false;
  double death = 0.0;
  friend auto operator<=>(const GrownBar&, const GrownBar&) = default;
};

std::vector<GrownBar> grown_bars_of(const BallFiltration& filtration) {
  std::vector<GrownBar> out;
  for (const BallFiltration::Class& one : filtration.classes()) {
    const bool dies = one.death != BallFiltration::kNever;
    out.push_back(
        {one.is_hole ? 1 : 0, filtration.growth(one.birth), dies, dies ? filtration.growth(one.death) : 0.0});
  }
  std::ranges::sort(out);
  return out;
}

void check_bars(const BallFiltration& filtration, const std::vector<ExactBar>& expected) {
  std::vector<GrownBar> wanted;
  for (const auto& [dimension, birth, dies, death] : expected)
    wanted.push_back({dimension, growth_of(birth), dies, dies ? growth_of(death) : 0.0});
  std::ranges::sort(wanted);
  const std::vector<GrownBar> found = grown_bars_of(filtration);
  REQUIRE(found.size() == wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i].dimension == wanted[i].dimension);
    CHECK(found[i].birth == Approx(wanted[i].birth).epsilon(1e-10).margin(1e-14));
    CHECK(found[i].dies == wanted[i].dies);
    CHECK(found[i].death == Approx(wanted[i].death).epsilon(1e-10).margin(1e-14));
  }
}

/// On a grid where it is positive, with radii of few values; anywhere otherwise.
std::vector<Disk> random_balls(std::size_t count, int grid, Rng& rng) {
  std::vector<Disk> out;
  for (std::size_t i = 0; i < count; ++i) {
    if (grid > 0)
      out.push_back({{static_cast<double>(rng.below(static_cast<std::uint64_t>(grid))),
                      static_cast<double>(rng.below(static_cast<std::uint64_t>(grid)))},
                     0.5 * static_cast<double>(rng.below(5))});
    else
      out.push_back({{rng.uniform(), rng.uniform()}, rng.below(4) == 0 ? 0.0 : 0.4 * rng.uniform()});
  }
  return out;
}

std::vector<Arc> arcs_of(const TestBench& bench, std::string_view layer) {
  std::vector<Arc> out;
  const auto row = bench.instances(layer, PrimitiveKind::arc);
  for (std::size_t at = 0; at < row.size(); at += stride_of(PrimitiveKind::arc))
    out.push_back({{row[at], row[at + 1]}, row[at + 2], {row[at + 3], row[at + 4]}, {row[at + 5], row[at + 6]}});
  return out;
}

double perimeter_of(const TestBench& bench, std::string_view layer) {
  double out = 0.0;
  for (const Arc& arc : arcs_of(bench, layer)) out += arc.radius * sweep_of(arc);
  const auto circles = bench.instances(layer, PrimitiveKind::circle);
  for (std::size_t at = 0; at < circles.size(); at += stride_of(PrimitiveKind::circle))
    out += 2.0 * std::numbers::pi * circles[at + 2];
  return out;
}

}  // namespace

TEST_CASE("births and deaths of grown balls are those of the weighted Cech complex") {
  Rng rng(31);
  std::size_t holes = 0;
  std::size_t hidden = 0;
  for (int round = 0; round < 200; ++round) {
    const std::size_t count = round < 10 ? static_cast<std::size_t>(round) : 3 + rng.below(8);
    const std::vector<Disk> balls = random_balls(count, round % 3 == 0 ? 0 : 2 + round % 7, rng);
    const BallBench bench(balls);
    std::vector<ExactBall> as_they_are;
    for (const Disk& ball : balls) as_they_are.push_back(exact(ball));
    INFO("round " << round);
    check_bars(bench.get<BBallFiltration>(), cech_bars_of_balls(as_they_are));
    holes += static_cast<std::size_t>(bench.count("b-ball-filtration", "holes"));
    hidden += static_cast<std::size_t>(bench.count("b-ball-filtration", "hidden"));
  }
  CHECK(holes > 20);
  CHECK(hidden > 50);
}

TEST_CASE("balls on a line are joined one after the other") {
  Rng rng(32);
  for (int round = 0; round < 40; ++round) {
    std::vector<Disk> balls;
    std::vector<ExactBall> as_they_are;
    const std::size_t count = 2 + rng.below(7);
    for (std::size_t i = 0; i < count; ++i) {
      const auto t = static_cast<double>(rng.below(12));
      balls.push_back({{t, round % 2 == 0 ? 0.0 : 2.0 * t}, 0.5 * static_cast<double>(rng.below(6))});
      as_they_are.push_back(exact(balls.back()));
    }
    const BallBench bench(balls);
    INFO("round " << round);
    check_bars(bench.get<BBallFiltration>(), cech_bars_of_balls(as_they_are));
  }
}

TEST_CASE("inner and polar balls grow as the circumdisks that they are") {
  Rng rng(33);
  for (int round = 0; round < 12; ++round) {
    std::vector<Vec2> points;
    for (int i = 0; i < 11; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + (round % 3 == 0 ? 0.0 : 0.3 * rng.uniform())) / 11.0;
      points.push_back({2.0 * std::cos(angle), std::sin(angle)});
    }
    // Cocircular samples: one ball of many faces.
    if (round == 1) points = {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-5, 0}, {-4, -3}, {0, -5}, {9, 1}, {9, -1}};
    TestBench bench(points);
    bench.show({"a-alpha-edges", "p-alpha-edges"});
    ComputationSettings settings;
    settings[Parameter::a_scale] = round % 2 == 0 ? 1.0 : 1.25;
    bench.choose(settings);
    INFO("round " << round);
    const auto check = [&](const BallFiltration& filtration, double scale) {
      std::vector<ExactBall> balls;
      for (const FamilySlot row : slots_below<FamilySlot>(filtration.family().rows())) {
        if (!filtration.family().is_ball(row)) continue;
        balls.push_back(exact_circumdisk(filtration.family().corners(row)));
        balls.back().w *= mpq_class(scale) * mpq_class(scale);
      }
      REQUIRE_FALSE(balls.empty());
      check_bars(filtration, cech_bars_of_balls(balls));
    };
    check(bench.get<ABallFiltration>(), settings[Parameter::a_scale]);
    check(bench.get<PBallFiltration>(), 1.0);
  }
}

TEST_CASE("balls of radius zero have the alpha complexes of samples") {
  Rng rng(34);
  for (const int grid : {0, 5, 30}) {
    SampleData data;
    for (const Disk& ball : random_balls(80, grid, rng)) data.balls.push_back({ball.center, 0.0});
    for (const Disk& ball : data.balls) data.positions.push_back(ball.center);
    TestBench bench;
    bench.load(data);
    bench.show({"alpha-edges", "alpha-triangles", "alpha-boundary", "b-alpha-edges", "b-alpha-triangles",
                "b-alpha-boundary"});
    const auto& samples = bench.get<AlphaFiltration>();
    const auto& balls = bench.get<BBallFiltration>();
    REQUIRE(samples.rank_count() == balls.rank_count());
    std::vector<GrownBar> bars;
    for (const AlphaFiltration::Class& one : samples.classes()) {
      const bool dies = one.death != AlphaFiltration::kNever;
      bars.push_back({one.is_hole ? 1 : 0, static_cast<double>(one.birth), dies, dies ? one.death : 0.0});
    }
    std::vector<GrownBar> grown;
    for (const BallFiltration::Class& one : balls.classes()) {
      const bool dies = one.death != BallFiltration::kNever;
      grown.push_back({one.is_hole ? 1 : 0, static_cast<double>(one.birth), dies, dies ? one.death : 0.0});
    }
    std::ranges::sort(bars);
    std::ranges::sort(grown);
    CHECK(grown == bars);
    for (std::uint32_t rank = 0; rank < balls.rank_count(); rank += 1 + rank / 8) {
      CHECK(balls.growth(rank) == Approx(samples.radius(rank)).epsilon(1e-11));
      bench.choose(grown_by(samples.radius(rank)));
      CHECK(bench.count("b-grown-complex", "edges") == bench.count("alpha-complex", "edges"));
      CHECK(bench.count("b-grown-complex", "triangles") == bench.count("alpha-complex", "triangles"));
      CHECK(bench.count("b-grown-complex", "components") == bench.count("alpha-complex", "components"));
      CHECK(bench.count("b-grown-complex", "holes") == bench.count("alpha-complex", "holes"));
      CHECK(perimeter_of(bench, "b-alpha-boundary") ==
            Approx(perimeter_of(bench, "alpha-boundary")).epsilon(1e-9).margin(1e-9));
    }
  }
}

TEST_CASE("the grown complex has the topology of the exact union of the grown balls, and its boundary") {
  // sqrt(r^2 + 12^2) is a whole number for these, so that the grown balls are doubles.
  constexpr double kGrowth = 12.0;
  constexpr std::array<std::pair<double, double>, 5> kRadii{
      {{0.0, 12.0}, {5.0, 13.0}, {9.0, 15.0}, {16.0, 20.0}, {35.0, 37.0}}};
  Rng rng(35);
  std::int64_t holes = 0;
  for (int round = 0; round < 60; ++round) {
    const std::uint64_t kinds = round % 3 == 0 ? 5 : 3;
    const double size = 40.0 + 60.0 * static_cast<double>(round % 4);  // from nearly all in one to far apart
    const auto coordinate = [&] {
      return round % 2 == 0 ? size * rng.uniform()
                            : 5.0 * static_cast<double>(rng.below(static_cast<std::uint64_t>(size / 5.0)));
    };
    SampleData grown;
    std::vector<Disk> plain;
    const std::size_t count = 2 + rng.below(60);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 center{coordinate(), coordinate()};
      const auto& [before, after] = kRadii[rng.below(kinds)];
      plain.push_back({center, before});
      grown.balls.push_back({center, after});
    }
    BallBench bench(plain);
    bench.choose(grown_by(kGrowth));
    TestBench exact_union;
    exact_union.load(grown);
    exact_union.show({"b-union-boundary", "b-ball-medial-axis"});
    ComputationSettings settings;
    settings.precision = Precision::exact;
    exact_union.choose(settings);
    INFO("round " << round << ", " << plain.size() << " balls");
    CHECK(bench.count("b-grown-complex", "components") == exact_union.count("b-union", "components"));
    CHECK(bench.count("b-grown-complex", "holes") == exact_union.count("b-union", "cycles"));
    CHECK(bench.count("b-grown-complex", "balls") - bench.count("b-grown-complex", "edges") +
              bench.count("b-grown-complex", "triangles") ==
          bench.count("b-grown-complex", "components") - bench.count("b-grown-complex", "holes"));
    CHECK(perimeter_of(bench, "b-alpha-boundary") ==
          Approx(exact_union.measure("b-union", "perimeter")).epsilon(1e-9).margin(1e-6));
    holes += bench.count("b-grown-complex", "holes");
    std::vector<std::pair<double, double>> begins;
    std::vector<std::pair<double, double>> ends;
    for (const Arc& arc : arcs_of(bench, "b-alpha-boundary")) {
      if (arc.from == arc.to) continue;
      begins.emplace_back(arc.from.x, arc.from.y);
      ends.emplace_back(arc.to.x, arc.to.y);
    }
    std::ranges::sort(begins);
    std::ranges::sort(ends);
    CHECK(begins == ends);
  }
  CHECK(holes > 20);
}

TEST_CASE("grown by nothing, balls have the dual complex of their union") {
  Rng rng(36);
  for (int round = 0; round < 30; ++round) {
    SampleData data;
    data.balls = random_balls(2 + rng.below(40), round % 2 == 0 ? 0 : 9, rng);
    // The union leaves out balls of radius zero.
    for (Disk& ball : data.balls) ball.radius = std::max(ball.radius, round % 2 == 0 ? 0.01 : 0.25);
    for (int i = 0; i < 40; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 40.0;
      data.positions.push_back({(2.0 + 0.1 * rng.uniform()) * std::cos(angle), std::sin(angle)});
    }
    TestBench bench;
    bench.load(data);
    bench.show({"b-alpha-edges", "b-union-boundary", "b-ball-medial-axis", "a-alpha-edges", "a-ball-medial-axis",
                "p-alpha-edges", "p-ball-medial-axis"});
    ComputationSettings settings;
    settings.precision = Precision::exact;
    bench.choose(settings);
    INFO("round " << round);
    for (const std::string family : {"a", "b", "p"}) {
      INFO(family);
      CHECK(bench.count(family + "-grown-complex", "components") == bench.count(family + "-union", "components"));
      CHECK(bench.count(family + "-grown-complex", "holes") == bench.count(family + "-union", "cycles"));
    }
  }
}

TEST_CASE("what comes at a growth has come there, and no sooner") {
  // Two balls of radius 1 whose centres are 4 apart touch at sqrt(3), and points 2 apart at 1.
  BallBench touching({{{0, 0}, 1}, {{4, 0}, 1}});
  const auto& filtration = touching.get<BBallFiltration>();
  REQUIRE(filtration.rank_count() == 2);
  CHECK(filtration.growth(0) == -1.0);
  CHECK(filtration.growth(1) == Approx(std::sqrt(3.0)).epsilon(1e-12));
  CHECK(filtration.ranks_within(filtration.growth(1)) == 2);
  CHECK(filtration.ranks_within(1.7320508075688774) == 2);
  CHECK(filtration.ranks_within(1.7320508075688772) == 1);
  const BallBench points({{{0, 0}, 0}, {{2, 0}, 0}});
  CHECK(points.get<BBallFiltration>().growth(1) == 1.0);
  CHECK(points.get<BBallFiltration>().ranks_within(1.0) == 2);
  CHECK(points.get<BBallFiltration>().ranks_within(std::nextafter(1.0, 0.0)) == 1);
  CHECK(points.get<BBallFiltration>().ranks_within(0.0) == 1);
  CHECK(points.get<BBallFiltration>().ranks_within(1e150) == 2);
  CHECK(points.get<BBallFiltration>().ranks_within(1e-150) == 1);

  Rng rng(37);
  const BallBench many(random_balls(120, 0, rng));
  const auto& grown = many.get<BBallFiltration>();
  for (std::uint32_t rank = 0; rank < grown.rank_count(); ++rank) {
    if (rank > 0) REQUIRE(grown.growth(rank - 1) <= grown.growth(rank));
    if (grown.growth(rank) >= 0.0) REQUIRE(grown.ranks_within(grown.growth(rank)) > rank);
    if (grown.growth(rank) > 0.0) REQUIRE(grown.ranks_within(grown.growth(rank) * (1.0 - 1e-11)) <= rank);
  }
}

TEST_CASE("places, order and size of balls change no class") {
  Rng rng(38);
  for (const int grid : {0, 8, 40}) {
    std::vector<Disk> balls = random_balls(120, grid, rng);
    if (grid == 0)
      for (Disk& ball : balls)
        ball = {{std::round(0x1p20 * ball.center.x), std::round(0x1p20 * ball.center.y)},
                std::round(0x1p18 * ball.radius)};
    const std::vector<GrownBar> bars = grown_bars_of(BallBench(balls).get<BBallFiltration>());
    std::ranges::reverse(balls);
    CHECK(grown_bars_of(BallBench(balls).get<BBallFiltration>()) == bars);
    for (const double scale : {0x1p-300, 0x1p-3, 0x1p10, 0x1p300}) {
      std::vector<Disk> other = balls;
      for (Disk& ball : other) ball = {scale * ball.center, scale * ball.radius};
      std::vector<GrownBar> expected = bars;
      for (GrownBar& bar : expected) {
        bar.birth *= scale;
        bar.death *= scale;
      }
      CHECK(grown_bars_of(BallBench(other).get<BBallFiltration>()) == expected);
    }
    for (Disk& ball : balls) ball.center = ball.center + Vec2{12345.0, -777.0};
    const std::vector<GrownBar> moved = grown_bars_of(BallBench(balls).get<BBallFiltration>());
    REQUIRE(moved.size() == bars.size());
    for (std::size_t i = 0; i < bars.size(); ++i) {
      CHECK(moved[i].birth == Approx(bars[i].birth).epsilon(1e-11));
      CHECK(moved[i].death == Approx(bars[i].death).epsilon(1e-11));
    }
  }
}

TEST_CASE("edits of balls and changes of their growth leave what a fresh computation has") {
  for (const int grid : {0, 7}) {
    Rng rng(39);
    BallBench bench(random_balls(40, grid, rng));
    ComputationSettings settings;
    for (int step = 0; step < 100; ++step) {
      const std::uint64_t kind = rng.below(7);
      const auto ids = bench.ball_ids();
      if (kind < 3 || ids.size() < 3) {
        settings[Parameter::alpha_radius] =
            grid == 0 ? 0.2 * rng.uniform() : 0.25 * static_cast<double>(rng.below(8));
        bench.choose(settings);
      } else if (kind == 3) {
        bench.insert_balls(random_balls(1 + rng.below(3), grid, rng));
      } else if (kind == 4) {
        bench.remove_balls({ids[rng.below(ids.size())]});
      } else if (kind == 5) {
        bench.change_ball(ids[rng.below(ids.size())], random_balls(1, grid, rng)[0]);
      } else {
        settings[Parameter::b_scale] = 0.5 + 0.25 * static_cast<double>(rng.below(4));
        bench.choose(settings);
      }
      INFO("step " << step);
      std::vector<Disk> reversed = bench.balls();
      std::ranges::reverse(reversed);
      BallBench fresh(reversed);
      fresh.choose(settings);
      REQUIRE(grown_bars_of(bench.get<BBallFiltration>()) == grown_bars_of(fresh.get<BBallFiltration>()));
      for (const std::string_view layer : kGrownLayers) {
        INFO(layer);
        REQUIRE(bench.mirror().digest(find_layer(layer)) == fresh.mirror().digest(find_layer(layer)));
      }
    }
  }
}

TEST_CASE("few and degenerate balls have the classes that they can have") {
  const auto counts = [](const std::vector<Disk>& balls, double a) {
    BallBench bench(balls);
    bench.choose(grown_by(a));
    return std::array{bench.count("b-grown-complex", "components"), bench.count("b-grown-complex", "holes")};
  };
  using Counts = std::array<std::int64_t, 2>;
  CHECK(counts({}, 1.0) == Counts{0, 0});
  CHECK(counts({{{3, 4}, 2}}, 0.0) == Counts{1, 0});
  CHECK(counts({{{3, 4}, 0}}, 0.0) == Counts{1, 0});
  // One in another, about its centre or not; twice the same; touching from inside.
  CHECK(counts({{{0, 0}, 5}, {{0, 0}, 1}}, 0.5) == Counts{1, 0});
  CHECK(counts({{{0, 0}, 5}, {{1, 0}, 1}}, 0.5) == Counts{1, 0});
  CHECK(counts({{{0, 0}, 5}, {{0, 0}, 5}}, 0.5) == Counts{1, 0});
  CHECK(counts({{{0, 0}, 5}, {{4, 0}, 1}}, 0.0) == Counts{1, 0});
  // A small ball that comes out of a large one only when both have shrunk.
  CHECK(counts({{{0, 0}, 5}, {{4, 0}, 2}}, 0.0) == Counts{1, 0});
  CHECK(counts({{{0, 0}, 1}, {{4, 0}, 2}}, 0.0) == Counts{2, 0});
  // Cocircular centres: a ring until it fills.
  std::vector<Disk> ring;
  for (const auto& [x, y] : {std::pair{5, 0},
                             {4, 3},
                             {3, 4},
                             {0, 5},
                             {-3, 4},
                             {-4, 3},
                             {-5, 0},
                             {-4, -3},
                             {-3, -4},
                             {0, -5},
                             {3, -4},
                             {4, -3}})
    ring.push_back({{static_cast<double>(x), static_cast<double>(y)}, 1.0});
  CHECK(counts(ring, 1.0) == Counts{8, 0});
  CHECK(counts(ring, 2.0) == Counts{1, 1});
  CHECK(counts(ring, std::nextafter(std::sqrt(24.0), 10.0)) == Counts{1, 0});
  CHECK(counts(ring, 4.89) == Counts{1, 1});
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    std::vector<Disk> balls;
    for (const Vec2 p : input.positions) balls.push_back({p, 0.0});
    BallBench bench(balls);
    CHECK(bench.count("b-ball-filtration", "stay") == (input.distinct == 0 ? 0 : 1));
    CHECK(bench.count("b-ball-filtration", "joined") ==
          std::max<std::int64_t>(0, static_cast<std::int64_t>(input.distinct) - 1));
  }
}
