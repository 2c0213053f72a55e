// SPDX-License-Identifier: GPL-3.0-or-later
// Births and deaths against those of the Cech complex of the definition, reduced as a matrix; ranks against rational
// numbers; the complex, its classes and its boundary against the union of balls.
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/alpha/alpha_complex.h"
#include "core/structures/alpha/persistence.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/matrix_reduction.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::array<std::string_view, 6> kAlphaLayers{"alpha-disks",    "alpha-triangles",  "alpha-edges",
                                                       "alpha-boundary", "alpha-components", "alpha-holes"};

void show_alpha(TestBench& bench) {
  bench.show({kAlphaLayers[0], kAlphaLayers[1], kAlphaLayers[2], kAlphaLayers[3], kAlphaLayers[4], kAlphaLayers[5]});
}

ComputationSettings at_radius(double radius) {
  ComputationSettings out;
  out[Parameter::alpha_radius] = radius;
  return out;
}

mpq_class squared(Vec2 a, Vec2 b) {
  const mpq_class x = mpq_class(a.x) - mpq_class(b.x);
  const mpq_class y = mpq_class(a.y) - mpq_class(b.y);
  return x * x + y * y;
}

/// Of the smallest circle that encloses three points: where their angles are acute, the circle through them.
mpq_class enclosing_square(Vec2 a, Vec2 b, Vec2 c) {
  std::array side{squared(a, b), squared(b, c), squared(c, a)};
  std::ranges::sort(side);
  if (side[0] + side[1] <= side[2]) return side[2] / 4;
  const mpq_class det = (mpq_class(b.x) - mpq_class(a.x)) * (mpq_class(c.y) - mpq_class(a.y)) -
                        (mpq_class(b.y) - mpq_class(a.y)) * (mpq_class(c.x) - mpq_class(a.x));
  return side[0] * side[1] * side[2] / (4 * det * det);
}

/// Of the Cech complex of all points; values are squares of radii.
std::vector<ExactBar> cech_bars_of_points(const std::vector<Vec2>& points) {
  const auto value = [&points](auto... corners) -> mpq_class {
    if constexpr (sizeof...(corners) == 1)
      return 0;
    else if constexpr (sizeof...(corners) == 2)
      return squared(points[corners]...) / 4;
    else
      return enclosing_square(points[corners]...);
  };
  return bars_by_reduction(points.size(), value);
}

struct RoundBar {
  int dimension = 0;
  double birth = 0.0;
  double death = 0.0;  ///< -1: never
  friend auto operator<=>(const RoundBar&, const RoundBar&) = default;
};

std::vector<RoundBar> round_bars_of(const TestBench& bench) {
  const auto& filtration = bench.get<AlphaFiltration>();
  std::vector<RoundBar> out;
  for (const AlphaFiltration::Class& one : filtration.classes())
    out.push_back({one.is_hole ? 1 : 0, filtration.radius(one.birth),
                   one.death == AlphaFiltration::kNever ? -1.0 : filtration.radius(one.death)});
  std::ranges::sort(out);
  return out;
}

std::vector<Vec2> random_points(std::size_t count, int grid, Rng& rng) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) {
    if (grid > 0)
      out.push_back({static_cast<double>(rng.below(static_cast<std::uint64_t>(grid))),
                     static_cast<double>(rng.below(static_cast<std::uint64_t>(grid)))});
    else
      out.push_back({rng.uniform(), rng.uniform()});
  }
  return out;
}

std::vector<Vec2> distinct_positions(std::vector<Vec2> points) {
  std::ranges::sort(points, lexicographically_less);
  points.erase(std::ranges::unique(points).begin(), points.end());
  return points;
}

bool is_collinear(Vec2 a, Vec2 b, Vec2 c) {
  return (mpq_class(b.x) - mpq_class(a.x)) * (mpq_class(c.y) - mpq_class(a.y)) ==
         (mpq_class(b.y) - mpq_class(a.y)) * (mpq_class(c.x) - mpq_class(a.x));
}

}  // namespace

TEST_CASE("births and deaths are those of the Cech complex") {
  Rng rng(11);
  for (int round = 0; round < 120; ++round) {
    const std::size_t count = round < 10 ? static_cast<std::size_t>(round) : 3 + rng.below(8);
    const std::vector<Vec2> points = random_points(count, round % 3 == 0 ? 0 : 2 + round % 5, rng);
    TestBench bench(points);
    show_alpha(bench);
    const std::vector<ExactBar> expected = cech_bars_of_points(distinct_positions(points));
    const std::vector<RoundBar> found = round_bars_of(bench);
    INFO("round " << round);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto& [dimension, birth, dies, death] = expected[i];
      CHECK(found[i].dimension == dimension);
      CHECK(found[i].birth == Approx(std::sqrt(birth.get_d())).epsilon(1e-9));
      if (!dies)
        CHECK(found[i].death == -1.0);
      else
        CHECK(found[i].death == Approx(std::sqrt(death.get_d())).epsilon(1e-9));
    }
  }
}

TEST_CASE("ranks are those of rational numbers") {
  Rng rng(12);
  for (const int grid : {0, 6, 25, 1000}) {
    for (const double step : {1.0, 0.1}) {
      std::vector<Vec2> points = random_points(150, grid, rng);
      for (Vec2& p : points) p = step * p;
      TestBench bench(points);
      show_alpha(bench);
      const auto& delaunay = bench.get<Delaunay>();
      const auto& filtration = bench.get<AlphaFiltration>();
      std::vector<std::pair<std::uint32_t, mpq_class>> ranks{{0, 0}};
      const auto square_of = [&](FaceSlot face) {
        const SiteSlot* const v = delaunay.face(face).v;
        const Vec2 a = delaunay.site_position(v[0]);
        const Vec2 b = delaunay.site_position(v[1]);
        const Vec2 c = delaunay.site_position(v[2]);
        const mpq_class det = (mpq_class(b.x) - mpq_class(a.x)) * (mpq_class(c.y) - mpq_class(a.y)) -
                              (mpq_class(b.y) - mpq_class(a.y)) * (mpq_class(c.x) - mpq_class(a.x));
        return mpq_class(squared(a, b) * squared(b, c) * squared(c, a) / (4 * det * det));
      };
      for (const FaceSlot face : delaunay.face_slots())
        if (delaunay.is_finite_face(face)) ranks.emplace_back(filtration.rank(face), square_of(face));
      for (const EdgeSlot edge : delaunay.edge_slots()) {
        const EdgeRow& row = delaunay.edge(edge);
        if (!row.is_alive()) continue;
        const Vec2 a = delaunay.site_position(row.v[0]);
        const Vec2 b = delaunay.site_position(row.v[1]);
        // The smallest empty circle through both ends, from all samples.
        mpq_class square = squared(a, b) / 4;
        const bool is_empty = std::ranges::none_of(
            points, [&](Vec2 p) { return p != a && p != b && squared(a, p) + squared(p, b) < squared(a, b); });
        if (!is_empty) {
          square = -1;
          for (const FaceSlot face : row.f)
            if (face != kNoSlot && delaunay.is_finite_face(face))
              square = square < 0 ? square_of(face) : std::min(square, square_of(face));
        }
        ranks.emplace_back(filtration.rank(edge), square);
      }
      std::ranges::sort(ranks);
      for (std::size_t i = 1; i < ranks.size(); ++i) {
        REQUIRE((ranks[i - 1].first == ranks[i].first) == (ranks[i - 1].second == ranks[i].second));
        REQUIRE((ranks[i - 1].second <= ranks[i].second));
        REQUIRE(filtration.radius(ranks[i].first) == Approx(std::sqrt(ranks[i].second.get_d())).epsilon(1e-9));
        REQUIRE(filtration.radius(ranks[i - 1].first) <= filtration.radius(ranks[i].first));
        // At its own radius, as it is written, everything has come.
        REQUIRE(filtration.last_rank(filtration.radius(ranks[i].first)) >= ranks[i].first);
      }
      CHECK(ranks.back().first + std::size_t{1} == filtration.rank_count());
    }
  }
}

TEST_CASE("radii are rounded up to the next double") {
  Rng rng(13);
  int equal = 0;
  for (int round = 0; round < 4000; ++round) {
    const bool has_third = round % 2 != 0;
    const auto points = random_points(3, round % 4 < 2 ? 9 : 0, rng);
    if (points[0] == points[1] || (has_third && is_collinear(points[0], points[1], points[2]))) continue;
    SpannedCircle circle{points[0], points[1], points[2], has_third};
    mpq_class square = squared(points[0], points[1]) / 4;
    if (has_third) {
      const mpq_class det =
          (mpq_class(points[1].x) - mpq_class(points[0].x)) * (mpq_class(points[2].y) - mpq_class(points[0].y)) -
          (mpq_class(points[1].y) - mpq_class(points[0].y)) * (mpq_class(points[2].x) - mpq_class(points[0].x));
      square = squared(points[0], points[1]) * squared(points[1], points[2]) * squared(points[2], points[0]) /
               (4 * det * det);
    }
    const double above = radius_above(circle);
    const auto reaches = [&](double r) { return mpq_class(mpq_class(r) * mpq_class(r)) >= square; };
    REQUIRE(reaches(above));
    REQUIRE_FALSE(reaches(std::nextafter(above, 0.0)));
    equal += mpq_class(mpq_class(above) * mpq_class(above)) == square ? 1 : 0;
    if (!has_third)
      REQUIRE(sees_wide(points[2], points[0], points[1]) ==
              (squared(points[0], points[2]) + squared(points[2], points[1]) <= squared(points[0], points[1])));
  }
  CHECK(equal > 100);
}

TEST_CASE("a circle is one hole until it fills, and a lattice has a hole in each cell") {
  TestBench circle(lattice_circle().positions);
  show_alpha(circle);
  std::vector<RoundBar> holes = round_bars_of(circle);
  std::erase_if(holes, [](const RoundBar& bar) { return bar.dimension == 0; });
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].death == 65.0);
  CHECK(circle.count("alpha-filtration", "joined") == 35);

  TestBench lattice(integer_lattice(6).positions);
  show_alpha(lattice);
  for (const RoundBar& bar : round_bars_of(lattice)) {
    CHECK(bar.birth == (bar.dimension == 0 ? 0.0 : 0.5));
    if (bar.death >= 0.0) CHECK(bar.death == (bar.dimension == 0 ? 0.5 : std::sqrt(0.5)));
  }
  CHECK(lattice.count("alpha-filtration", "radii") == 2);
  CHECK(lattice.count("alpha-filtration", "joined") == 35);
  CHECK(lattice.count("alpha-filtration", "holes") == 25);
  CHECK(lattice.count("alpha-filtration", "stay") == 1);
}

TEST_CASE("of a noisy ring one hole lives long") {
  Rng rng(14);
  std::vector<Vec2> points;
  while (points.size() < 600) {
    const Vec2 p{2.0 * rng.uniform() - 1.0, 2.0 * rng.uniform() - 1.0};
    if (length(p) >= 0.6 && length(p) <= 1.0) points.push_back(p);
  }
  TestBench bench(points);
  show_alpha(bench);
  std::vector<double> lives;
  for (const RoundBar& bar : round_bars_of(bench))
    if (bar.dimension == 1) lives.push_back(bar.death - bar.birth);
  std::ranges::sort(lives, std::greater());
  REQUIRE(lives.size() > 10);
  CHECK(lives[0] > 0.4);
  CHECK(lives[1] < 0.1);
}

TEST_CASE("the complex has the topology of the union of the disks, and its boundary") {
  Rng rng(15);
  for (int round = 0; round < 40; ++round) {
    const int grid = round % 2 == 0 ? 0 : 3 + round % 4;
    const std::vector<Vec2> points = distinct_positions(random_points(2 + rng.below(40), grid, rng));
    const double radius = grid != 0 ? 0.25 * static_cast<double>(1 + rng.below(6)) : 0.3 * rng.uniform() + 0.01;
    SampleData data{.positions = points};
    for (const Vec2 p : points) data.balls.push_back({p, radius});
    TestBench bench;
    bench.load(data);
    bench.show({"alpha-disks", "alpha-triangles", "alpha-edges", "alpha-boundary", "alpha-components", "alpha-holes",
                "b-union-boundary", "b-ball-medial-axis"});
    ComputationSettings settings = at_radius(radius);
    settings.precision = Precision::exact;
    bench.choose(settings);
    INFO("round " << round << ", radius " << radius << ", " << points.size() << " samples");
    const std::int64_t components = bench.count("alpha-complex", "components");
    const std::int64_t holes = bench.count("alpha-complex", "holes");
    CHECK(components == bench.count("b-union", "components"));
    CHECK(holes == bench.count("b-union", "cycles"));
    CHECK(static_cast<std::int64_t>(points.size()) - bench.count("alpha-complex", "edges") +
              bench.count("alpha-complex", "triangles") ==
          components - holes);
    CHECK(static_cast<std::int64_t>(bench.instances("alpha-components", PrimitiveKind::point).size() /
                                    stride_of(PrimitiveKind::point)) == components);
    CHECK(static_cast<std::int64_t>(bench.instances("alpha-holes", PrimitiveKind::circle).size() /
                                    stride_of(PrimitiveKind::circle)) == holes);
    double perimeter = 0.0;
    std::vector<std::pair<double, double>> begins;
    std::vector<std::pair<double, double>> ends;
    const auto arcs = bench.instances("alpha-boundary", PrimitiveKind::arc);
    for (std::size_t at = 0; at < arcs.size(); at += stride_of(PrimitiveKind::arc)) {
      const Arc arc{
          {arcs[at], arcs[at + 1]}, arcs[at + 2], {arcs[at + 3], arcs[at + 4]}, {arcs[at + 5], arcs[at + 6]}};
      perimeter += sweep_of(arc) * arc.radius;
      begins.emplace_back(arc.from.x, arc.from.y);
      ends.emplace_back(arc.to.x, arc.to.y);
    }
    std::ranges::sort(begins);
    std::ranges::sort(ends);
    CHECK(begins == ends);
    const auto circles = bench.instances("alpha-boundary", PrimitiveKind::circle);
    for (std::size_t at = 0; at < circles.size(); at += stride_of(PrimitiveKind::circle))
      perimeter += 2.0 * std::numbers::pi * circles[at + 2];
    CHECK(perimeter == Approx(bench.measure("b-union", "perimeter")).epsilon(1e-9).margin(1e-6 * radius));
  }
}

TEST_CASE("places, order and size change no rank and no class") {
  Rng rng(16);
  for (const int grid : {0, 8, 40}) {
    std::vector<Vec2> points = random_points(120, grid == 0 ? 1 << 20 : grid, rng);
    TestBench original(points);
    show_alpha(original);
    const std::vector<RoundBar> bars = round_bars_of(original);
    std::ranges::reverse(points);
    TestBench reversed(points);
    show_alpha(reversed);
    CHECK(round_bars_of(reversed) == bars);
    const auto arcs_at = [](TestBench& bench, double radius) {
      bench.choose(at_radius(radius));
      const auto arcs = bench.instances("alpha-boundary", PrimitiveKind::arc);
      std::vector<double> out;
      for (std::size_t i = 0; i < arcs.size(); ++i)
        if (i % stride_of(PrimitiveKind::arc) + 1 != stride_of(PrimitiveKind::arc)) out.push_back(arcs[i]);
      std::ranges::sort(out);
      return out;
    };
    const double radius = grid == 0 ? 0x1.3p16 : 1.2;
    const std::vector<double> arcs = arcs_at(reversed, radius);
    CHECK(arcs.size() > 100);
    for (const double scale : {0x1p-300, 0x1p-3, 0x1p10, 0x1p300}) {
      std::vector<Vec2> large = points;
      for (Vec2& p : large) p = scale * p;
      TestBench scaled(large);
      show_alpha(scaled);
      std::vector<RoundBar> expected = bars;
      for (RoundBar& bar : expected) {
        bar.birth *= scale;
        if (bar.death >= 0.0) bar.death *= scale;
      }
      CHECK(round_bars_of(scaled) == expected);
      std::vector<double> scaled_arcs = arcs;
      for (double& x : scaled_arcs) x *= scale;
      CHECK(arcs_at(scaled, scale * radius) == scaled_arcs);
    }
    for (Vec2& p : points) p = p + Vec2{12345.0, -777.0};
    TestBench moved(points);
    show_alpha(moved);
    CHECK(round_bars_of(moved) == bars);
  }
}

TEST_CASE("radii of nearly flat triangles are rounded up as others are") {
  // A turned square with ten digits: samples of a side are nearly on a line, some on one side of it, some on the other.
  std::vector<Vec2> points;
  const auto rounded = [](double x) { return std::round(x * 1e10) / 1e10; };
  const auto add = [&](double x, double y) {
    points.push_back(
        {rounded(std::cos(0.5) * x - std::sin(0.5) * y), rounded(std::sin(0.5) * x + std::cos(0.5) * y)});
  };
  constexpr int kSide = 40;
  for (int i = 0; i < kSide; ++i) {
    const double t = static_cast<double>(i) / kSide;
    add(t, 0.0);
    add(1.0, t);
    add(1.0 - t, 1.0);
    add(0.0, 1.0 - t);
  }
  TestBench bench(points);
  show_alpha(bench);
  const auto& delaunay = bench.get<Delaunay>();
  const auto& filtration = bench.get<AlphaFiltration>();
  std::size_t flat = 0;
  for (const FaceSlot face : delaunay.face_slots()) {
    if (!delaunay.is_finite_face(face)) continue;
    const SiteSlot* const v = delaunay.face(face).v;
    const std::array<Vec2, 3> p{delaunay.site_position(v[0]), delaunay.site_position(v[1]),
                                delaunay.site_position(v[2])};
    const mpq_class det = (mpq_class(p[1].x) - mpq_class(p[0].x)) * (mpq_class(p[2].y) - mpq_class(p[0].y)) -
                          (mpq_class(p[1].y) - mpq_class(p[0].y)) * (mpq_class(p[2].x) - mpq_class(p[0].x));
    const mpq_class square = squared(p[0], p[1]) * squared(p[1], p[2]) * squared(p[2], p[0]) / (4 * det * det);
    const double radius = filtration.radius(filtration.rank(face));
    REQUIRE((mpq_class(mpq_class(radius) * mpq_class(radius)) >= square));
    const double below = std::nextafter(radius, 0.0);
    REQUIRE((mpq_class(mpq_class(below) * mpq_class(below)) < square));
    if (radius > 1e4) ++flat;
  }
  CHECK(flat > 10);
}

TEST_CASE("at the radius of an event it has happened, and no arc of the boundary goes through a disk") {
  Rng rng(29);
  std::vector<Vec2> points(150);
  for (Vec2& p : points) p = {rng.uniform(), rng.uniform()};
  TestBench bench(points);
  bench.show({"alpha-boundary", "alpha-holes", "alpha-components"});
  std::size_t arcs_seen = 0;
  const auto classes = bench.get<AlphaFiltration>().classes();
  for (const AlphaFiltration::Class& one : classes) {
    if (one.death == AlphaFiltration::kNever) continue;
    const auto& filtration = bench.get<AlphaFiltration>();
    const double radius = filtration.radius(one.death);
    REQUIRE(filtration.last_rank(radius) >= one.death);
    REQUIRE(filtration.last_rank(std::nextafter(radius, 0.0)) < one.death);
    bench.choose(at_radius(radius));
    const auto arcs = bench.instances("alpha-boundary", PrimitiveKind::arc);
    for (std::size_t at = 0; at < arcs.size(); at += stride_of(PrimitiveKind::arc)) {
      const Arc arc{
          {arcs[at], arcs[at + 1]}, arcs[at + 2], {arcs[at + 3], arcs[at + 4]}, {arcs[at + 5], arcs[at + 6]}};
      const double turn = 0.5 * sweep_of(arc);
      const Vec2 start = arc.from - arc.center;
      const Vec2 middle = arc.center + Vec2{std::cos(turn) * start.x - std::sin(turn) * start.y,
                                            std::sin(turn) * start.x + std::cos(turn) * start.y};
      for (const Vec2 p : points) REQUIRE(distance(middle, p) > radius * (1.0 - 1e-6));
      ++arcs_seen;
    }
  }
  CHECK(arcs_seen > 1000);
}

TEST_CASE("the hub of a wheel is joined to all its spokes, and each arc is found once") {
  // Each edge at the hub looks for the next one.
  std::vector<Vec2> wheel{{0.0, 0.0}};
  constexpr int kSpokes = 12;
  for (int i = 0; i < kSpokes; ++i)
    wheel.push_back({std::cos(2.0 * std::numbers::pi * i / kSpokes), std::sin(2.0 * std::numbers::pi * i / kSpokes)});
  // Between the radius at which the hub is joined and that at which the triangles are filled.
  constexpr double kRadius = 0.505;
  SampleData data{.positions = wheel};
  for (const Vec2 p : wheel) data.balls.push_back({p, kRadius});
  TestBench bench;
  bench.load(data);
  bench.show({"alpha-boundary", "alpha-edges", "b-union-boundary"});
  bench.choose(at_radius(kRadius));
  CHECK(bench.count("alpha-complex", "holes") == kSpokes);
  double perimeter = 0.0;
  const auto arcs = bench.instances("alpha-boundary", PrimitiveKind::arc);
  for (std::size_t at = 0; at < arcs.size(); at += stride_of(PrimitiveKind::arc))
    perimeter +=
        arcs[at + 2] *
        sweep_of(
            {{arcs[at], arcs[at + 1]}, arcs[at + 2], {arcs[at + 3], arcs[at + 4]}, {arcs[at + 5], arcs[at + 6]}});
  CHECK(perimeter == Approx(bench.measure("b-union", "perimeter")).epsilon(1e-9));
}

TEST_CASE("edits and changes of the radius leave what a fresh computation has") {
  for (const int grid : {0, 7}) {
    Rng rng(17);
    TestBench bench(random_points(60, grid, rng));
    show_alpha(bench);
    ComputationSettings settings;
    for (int step = 0; step < 120; ++step) {
      const std::uint64_t kind = rng.below(6);
      const auto ids = bench.ids();
      const double size = grid == 0 ? 1.0 : 0.5 * grid;
      if (kind < 3 || ids.size() < 3)
        bench.choose(settings =
                         at_radius(grid == 0 ? 0.2 * rng.uniform() : 0.25 * static_cast<double>(rng.below(8))));
      else if (kind == 3)
        bench.insert(random_points(1 + rng.below(3), grid, rng));
      else if (kind == 4)
        bench.remove({ids[rng.below(ids.size())]});
      else
        bench.move(ids[rng.below(ids.size())], {size * rng.uniform(), size * rng.uniform()});
      INFO("step " << step);
      std::vector<Vec2> reversed = bench.positions();
      std::ranges::reverse(reversed);
      TestBench fresh(reversed);
      show_alpha(fresh);
      fresh.choose(settings);
      REQUIRE(round_bars_of(bench) == round_bars_of(fresh));
      for (const std::string_view layer : kAlphaLayers) {
        INFO(layer);
        REQUIRE(bench.mirror().digest(find_layer(layer)) == fresh.mirror().digest(find_layer(layer)));
      }
    }
  }
}

TEST_CASE("few and degenerate samples have the classes that they can have") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    TestBench bench(input.positions);
    show_alpha(bench);
    CHECK(bench.count("alpha-filtration", "stay") == (input.distinct == 0 ? 0 : 1));
    CHECK(bench.count("alpha-filtration", "joined") ==
          std::max<std::int64_t>(0, static_cast<std::int64_t>(input.distinct) - 1));
    const double extent = bench.get<AlphaFiltration>().rank_count() == 0
                              ? 1.0
                              : bench.get<AlphaFiltration>().radius(
                                    static_cast<std::uint32_t>(bench.get<AlphaFiltration>().rank_count() - 1));
    // At the last radius everything is one component without a hole.
    const double limit = Parameter::alpha_radius.high;
    if (2.0 * extent > limit) continue;
    bench.choose(at_radius(2.0 * extent));
    CHECK(bench.count("alpha-complex", "components") == (input.distinct == 0 ? 0 : 1));
    CHECK(bench.count("alpha-complex", "holes") == 0);
  }
}
