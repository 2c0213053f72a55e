// SPDX-License-Identifier: GPL-3.0-or-later
// Feature sizes against all edges of the axis in a plain loop, against formulas, and after edits.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <span>
#include <vector>

#include "core/base/geometry/box_tree.h"
#include "core/base/rng.h"
#include "core/structures/density/feature_size.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

void show_density(TestBench& bench) {
  bench.show({"feature-size", "sampling-epsilon", "all-medial-axis"});
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length2 = dot(d, d);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  return distance(p, a + t * d);
}

/// To everything that the layer of the whole axis draws.
double distance_to_drawn_axis(const TestBench& bench, Vec2 p) {
  double out = std::numeric_limits<double>::infinity();
  const auto segments = bench.instances("all-medial-axis", PrimitiveKind::segment);
  for (std::size_t at = 0; at < segments.size(); at += stride_of(PrimitiveKind::segment))
    out =
        std::min(out, distance_to_segment(p, {segments[at], segments[at + 1]}, {segments[at + 2], segments[at + 3]}));
  const auto rays = bench.instances("all-medial-axis", PrimitiveKind::ray);
  for (std::size_t at = 0; at < rays.size(); at += stride_of(PrimitiveKind::ray)) {
    const Vec2 from{rays[at], rays[at + 1]};
    const Vec2 along{rays[at + 2], rays[at + 3]};
    const double t = std::max(0.0, dot(p - from, along) / dot(along, along));
    out = std::min(out, distance(p, from + t * along));
  }
  return out;
}

void check_sizes(const TestBench& bench, double tolerance) {
  const auto& sizes = bench.get<FeatureSize>();
  const auto& delaunay = bench.get<Delaunay>();
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site)) continue;
    const double expected = distance_to_drawn_axis(bench, delaunay.site_position(site));
    REQUIRE(sizes.has_size(site) == std::isfinite(expected));
    if (sizes.has_size(site)) REQUIRE(sizes.size(site) == Approx(expected).epsilon(tolerance));
  }
}

/// The sites that do not count for the epsilon of all, by their definition: ends and junctions of the crust, and corners.
Table<SiteSlot, bool> exempt_sites(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  Table<SiteSlot, std::vector<SiteSlot>> beside(delaunay.site_rows());
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!delaunay.edge(edge).is_alive() || !bench.get<OneStepCrust>().is_crust(edge)) continue;
    const auto& [a, b] = delaunay.edge(edge).v;
    beside[a].push_back(b);
    beside[b].push_back(a);
  }
  Table<SiteSlot, double> turn(delaunay.site_rows(), 0.0);
  for (const SiteSlot site : turn.rows()) {
    if (beside[site].size() != 2) continue;
    const Vec2 p = delaunay.site_position(site);
    const Vec2 in = p - delaunay.site_position(beside[site][0]), out = delaunay.site_position(beside[site][1]) - p;
    turn[site] = std::abs(std::atan2(cross(in, out), dot(in, out)));
  }
  Table<SiteSlot, bool> exempt(delaunay.site_rows(), false);
  for (const SiteSlot site : turn.rows()) {
    const std::vector<SiteSlot>& ends = beside[site];
    exempt[site] = ends.size() != 2 || (turn[site] > 2.0 * std::asin(kDenseEpsilon) &&
                                        turn[site] > 4.0 * (turn[ends[0]] + turn[ends[1]]));
  }
  return exempt;
}

/// The epsilon of the samples, followed under edits, is the largest of all edges that end at no exempt site; the note
/// says it, and where.
void check_sparsest_edge(const TestBench& bench) {
  const auto& sizes = bench.get<FeatureSize>();
  const auto& delaunay = bench.get<Delaunay>();
  const auto exempt = exempt_sites(bench);
  double most = -1.0;
  std::int64_t above = 0;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    if (!sizes.has_epsilon(edge)) continue;
    const auto& [a, b] = delaunay.edge(edge).v;
    if (exempt[a] || exempt[b]) continue;
    most = std::max(most, sizes.epsilon(edge));
    above += sizes.epsilon(edge) > kDenseEpsilon ? 1 : 0;
  }
  REQUIRE(bench.count("feature-size", "curve_edges_above_0.25") == above);
  const EdgeSlot sparsest = sizes.sparsest_edge();
  REQUIRE((sparsest == kNoSlot) == (most < 0.0));
  std::vector<Finding> findings;
  sizes.find(findings);
  REQUIRE(findings.size() == (most < 0.0 ? 0U : 1U));
  if (findings.empty()) return;
  REQUIRE(sizes.epsilon(sparsest) == most);
  REQUIRE(findings[0].level == FindingLevel::note);
  REQUIRE(findings[0].epsilon);
  REQUIRE(findings[0].epsilon->value == most);
  REQUIRE(findings[0].epsilon->is_estimate);
  std::size_t corners = 0;
  std::size_t ends = 0;
  std::size_t junctions = 0;
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site) || !exempt[site]) continue;
    std::size_t degree = 0;
    delaunay.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) {
      degree += bench.get<OneStepCrust>().is_crust(edge) ? 1U : 0U;
    });
    corners += degree == 2 ? 1U : 0U;
    ends += degree == 1 ? 1U : 0U;
    junctions += degree > 2 ? 1U : 0U;
  }
  REQUIRE(findings[0].epsilon->corners == corners);
  REQUIRE(findings[0].epsilon->ends == ends);
  REQUIRE(findings[0].epsilon->junctions == junctions);
  const EdgeRow& row = delaunay.edge(sparsest);
  const Vec2 middle = 0.5 * delaunay.site_position(row.v[0]) + 0.5 * delaunay.site_position(row.v[1]);
  REQUIRE(findings[0].places == std::vector{middle});
}

void check_against_fresh(const TestBench& bench) {
  check_sparsest_edge(bench);
  std::vector<Vec2> reversed = bench.positions();
  std::ranges::reverse(reversed);
  TestBench fresh;
  show_density(fresh);
  fresh.replace(reversed);
  // Also where several edges have the largest epsilon.
  std::vector<Finding> findings;
  std::vector<Finding> expected;
  bench.get<FeatureSize>().find(findings);
  fresh.get<FeatureSize>().find(expected);
  REQUIRE(findings.size() == expected.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    REQUIRE(findings[i].epsilon == expected[i].epsilon);
    REQUIRE(findings[i].places == expected[i].places);
  }
  for (const std::string_view layer : {"feature-size", "sampling-epsilon"}) {
    INFO(layer);
    REQUIRE(bench.mirror().digest(find_layer(layer)) == fresh.mirror().digest(find_layer(layer)));
  }
  REQUIRE(bench.count("feature-size", "samples") == fresh.count("feature-size", "samples"));
}

}  // namespace

TEST_CASE("a tree of boxes leaves nothing out that is near, boxes without end included") {
  Rng rng(1);
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 100U, 3000U}) {
    std::vector<Box2> boxes;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 low{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
      Box2 box{low, low + Vec2{0.05 * rng.uniform(), 0.05 * rng.uniform()}};
      if (rng.below(40) == 0) box.high.x = std::numeric_limits<double>::infinity();
      if (rng.below(40) == 0) box.low.y = -std::numeric_limits<double>::infinity();
      if (rng.below(60) == 0) box.high.x = 1e12;
      boxes.push_back(box);
    }
    // Built, or with half of the items coming later and others going.
    for (const bool comes_later : {false, true}) {
      BoxTree<std::uint32_t> tree;
      std::vector<std::uint32_t> place(count + 1, 0);
      const auto bounds_of = [&](std::uint32_t item) { return TreeBounds{boxes[item]}; };
      const auto moved = [&](std::uint32_t item, std::uint32_t at) { place[item] = at; };
      std::vector<std::uint32_t> items;
      std::vector<bool> is_there(count, true);
      for (std::uint32_t i = 0; i < (comes_later ? count / 2 : count); ++i) items.push_back(i);
      tree.build(std::span<const std::uint32_t>(items), bounds_of, moved);
      if (comes_later) {
        for (auto i = static_cast<std::uint32_t>(items.size()); i < count; ++i) {
          tree.insert(i, bounds_of, moved);
          const auto gone = static_cast<std::uint32_t>(rng.below(i));
          if (!is_there[gone] || rng.below(2) == 0) continue;
          tree.remove(place[gone], moved);
          is_there[gone] = false;
        }
        for (std::uint32_t i = 0; i < count; ++i)
          if (is_there[i]) REQUIRE(tree.at(place[i]) == i);
      }
      REQUIRE(tree.size() == static_cast<std::size_t>(std::ranges::count(is_there, true)));
      const auto squared_to = [&](std::uint32_t item, Vec2 p) {
        const double dx = std::max({boxes[item].low.x - p.x, 0.0, p.x - boxes[item].high.x});
        const double dy = std::max({boxes[item].low.y - p.y, 0.0, p.y - boxes[item].high.y});
        return dx * dx + dy * dy;
      };
      for (int round = 0; round < 200; ++round) {
        const Vec2 p{rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)};
        double expected = std::numeric_limits<double>::infinity();
        std::size_t holding = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
          if (!is_there[i]) continue;
          expected = std::min(expected, squared_to(i, p));
          holding += boxes[i].contains(p) ? 1U : 0U;
        }
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t visits = 0;
        tree.visit_near(p, nearest, [&](std::uint32_t item) {
          ++visits;
          nearest = std::min(nearest, squared_to(item, p));
        });
        REQUIRE(nearest == expected);
        if (count == 3000) REQUIRE(visits < 1500);
        std::size_t found = 0;
        tree.visit_where([&](const Box2& box, double) { return box.contains(p); },
                         [&](std::uint32_t item) { found += boxes[item].contains(p) ? 1U : 0U; });
        REQUIRE(found == holding);
      }
    }
  }
}

TEST_CASE("a tree whose building fails is empty, and can be built again") {
  const std::vector<Vec2> places(1000, Vec2{1.0, 2.0});
  for (const std::size_t last : {0U, 500U, 999U}) {
    BoxTree<Vec2> tree;
    // As if memory ran out, before or after items have found their places.
    CHECK_THROWS_AS(tree.build(
                        std::span(places),
                        [&](const Vec2& at) {
                          if (&at == &places[last]) throw std::bad_alloc();
                          return TreeBounds{{at, at}};
                        },
                        [](const Vec2&, std::uint32_t) {}),
                    std::bad_alloc);
    CHECK(tree.is_empty());
    std::size_t moved = 0;
    CHECK_THROWS_AS(tree.build(
                        std::span(places),
                        [](const Vec2& at) {
                          return TreeBounds{{at, at}};
                        },
                        [&](const Vec2&, std::uint32_t) {
                          if (moved++ == last) throw std::bad_alloc();
                        }),
                    std::bad_alloc);
    CHECK(tree.is_empty());
    tree.build(
        std::span(places),
        [](const Vec2& at) {
          return TreeBounds{{at, at}};
        },
        [](const Vec2&, std::uint32_t) {});
    CHECK(tree.size() == places.size());
  }
}

TEST_CASE("sizes are the same at both ends of the range of coordinates") {
  Rng rng(5);
  std::vector<Vec2> samples;
  for (int i = 0; i < 80; ++i) samples.push_back({rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)});
  const auto sizes_of = [](const std::vector<Vec2>& at) {
    TestBench bench;
    show_density(bench);
    bench.replace(at);
    bench.move(bench.ids()[3], 0.5 * at[3]);
    std::vector<double> out;
    const auto& delaunay = bench.get<Delaunay>();
    for (const SiteSlot site : delaunay.site_slots())
      if (delaunay.is_site(site)) out.push_back(bench.get<FeatureSize>().size(site));
    std::ranges::sort(out);
    return out;
  };
  const std::vector<double> expected = sizes_of(samples);
  for (const int exponent : {-450, 450}) {
    std::vector<Vec2> scaled;
    for (const Vec2 p : samples) scaled.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)});
    const std::vector<double> found = sizes_of(scaled);
    for (std::size_t i = 0; i < found.size(); ++i) REQUIRE(found[i] == std::ldexp(expected[i], exponent));
  }
}

TEST_CASE("a size is the distance to the nearest point of the whole axis as it is drawn") {
  Rng rng(2);
  for (int round = 0; round < 6; ++round) {
    std::vector<Vec2> samples;
    for (int i = 0; i < 150; ++i) {
      const double t = 2.0 * std::numbers::pi * rng.uniform();
      const double r = 10.0 * (1.0 + 0.3 * std::cos(4.0 * t)) + (round % 2 == 0 ? 0.0 : rng.uniform());
      samples.push_back(round == 5 ? Vec2{20.0 * rng.uniform(), 20.0 * rng.uniform()}
                                   : Vec2{r * std::cos(t), r * std::sin(t)});
    }
    TestBench bench;
    show_density(bench);
    bench.replace(samples);
    check_sizes(bench, 1e-9);
  }
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    TestBench bench;
    show_density(bench);
    bench.replace(input.positions);
    for (const std::string_view layer : {"feature-size", "sampling-epsilon"})
      for (const PrimitiveKind kind : kAllPrimitiveKinds)
        for (const double x : bench.instances(layer, kind)) REQUIRE(std::isfinite(x));
  }
}

TEST_CASE("the sizes of an ellipse, an annulus and a stadium follow their formulas") {
  const double a = 2.0;
  const double end = (a * a - 1.0) / a;
  TestBench bench;
  show_density(bench);
  bench.replace(ellipse(a, 1.0, 600, {0.3, 0.0, 1}).data.positions);
  const auto points = [&bench] { return bench.instances("feature-size", PrimitiveKind::point); };
  REQUIRE(points().size() == 600 * stride_of(PrimitiveKind::point));
  for (std::size_t at = 0; at < points().size(); at += 3) {
    const double x = std::abs(points()[at]);
    const double y = std::abs(points()[at + 1]);
    const double expected = x <= end ? y : std::hypot(x - end, y);
    REQUIRE(points()[at + 2] == Approx(expected).margin(2e-3));
  }
  CHECK(bench.measure("feature-size", "size_min") == Approx(0.5).margin(2e-3));

  // Outside, a convex curve has no axis; inside of the hole the nearest axis is its centre or the ring.
  bench.replace(annulus(1.0, 2.0, 0.05, {0.3, 0.0, 1}).data.positions);
  for (std::size_t at = 0; at < points().size(); at += 3) {
    REQUIRE(points()[at + 2] == Approx(0.5).margin(5e-3));
  }
  bench.replace(stadium(2.0, 1.0, 0.1, {0.3, 0.0, 1}).data.positions);
  for (std::size_t at = 0; at < points().size(); at += 3) REQUIRE(points()[at + 2] == Approx(1.0).margin(0.02));
}

TEST_CASE("samples of an epsilon have about that epsilon, and a missing one is seen at its place") {
  for (const double epsilon : {0.1, 0.2}) {
    TestBench bench;
    show_density(bench);
    const TestShape shape = ellipse_graded(2.0, 1.0, epsilon, {0.3, 0.0, 1});
    bench.replace(shape.data.positions);
    const double found = bench.measure("feature-size", "epsilon");
    CHECK(found > 0.6 * epsilon);
    CHECK(found < 1.3 * epsilon);
    const std::vector<SampleId> ids = bench.ids();
    const Vec2 gone = bench.positions()[ids.size() / 3];
    bench.remove({ids[ids.size() / 3]});
    CHECK(bench.measure("feature-size", "epsilon") > 1.5 * found);
    const auto edges = bench.instances("sampling-epsilon", PrimitiveKind::segment);
    std::size_t worst = 0;
    for (std::size_t at = 0; at < edges.size(); at += 5)
      if (edges[at + 4] > edges[worst + 4]) worst = at;
    const Vec2 p{edges[worst], edges[worst + 1]};
    const Vec2 q{edges[worst + 2], edges[worst + 3]};
    CHECK(distance(gone, 0.5 * (p + q)) < 0.6 * distance(p, q));
  }
}

TEST_CASE("after every edit sizes are those of a fresh computation") {
  for (const bool lattice : {false, true}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      Rng rng(seed);
      const auto place = [&] {
        if (lattice) return Vec2{static_cast<double>(rng.below(7)), static_cast<double>(rng.below(7))};
        const double t = 2.0 * std::numbers::pi * rng.uniform();
        const double r = 4.0 * (1.0 + 0.3 * std::cos(3.0 * t)) + (seed == 1 ? 0.0 : 0.3 * rng.uniform());
        return Vec2{r * std::cos(t), r * std::sin(t)};
      };
      TestBench bench;
      show_density(bench);
      std::vector<Vec2> start;
      for (int i = 0; i < (lattice ? 20 : 120); ++i) start.push_back(place());
      bench.replace(start);
      for (int step = 0; step < 250; ++step) {
        INFO("lattice " << lattice << " seed " << seed << " step " << step);
        const auto ids = bench.ids();
        const auto some = [&] { return ids[rng.below(ids.size())]; };
        switch (rng.below(6)) {
          case 0: bench.insert({place()}); break;
          case 1:
            if (ids.size() > 3) bench.remove({some()});
            break;
          case 2:
          case 3: bench.move(some(), place()); break;
          case 4: bench.insert({place(), place(), place()}); break;
          default:
            if (bench.steps_done() > 1) bench.undo();
        }
        check_against_fresh(bench);
      }
    }
  }
}

namespace {

/// The least rounded distance to any edge of the axis, in a plain loop; not a trace of how it is searched.
void check_least_of_all(const std::vector<Vec2>& samples) {
  TestBench bench;
  show_density(bench);
  bench.replace(samples);
  const auto& delaunay = bench.get<Delaunay>();
  const auto& crust = bench.get<OneStepCrust>();
  std::vector<AxisLine> lines;
  for (const EdgeSlot edge : delaunay.edge_slots())
    if (delaunay.edge(edge).is_alive() && !crust.is_crust(edge)) lines.push_back(axis_line(delaunay, edge, 1.0));
  REQUIRE_FALSE(lines.empty());
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site)) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const AxisLine& line : lines) least = std::min(least, line.squared_distance(delaunay.site_position(site)));
    REQUIRE(bench.get<FeatureSize>().size(site) == std::sqrt(least));
  }
}

Vec2 on_circle(double turn, double radius = 1.0) {
  return {radius * std::cos(2.0 * std::numbers::pi * turn), radius * std::sin(2.0 * std::numbers::pi * turn)};
}

}  // namespace

TEST_CASE("sizes are the least of all rounded distances, to the last bit") {
  Rng rng(11);
  std::vector<Vec2> samples;
  SECTION("a smooth curve, whose samples are near to thousands") {
    for (int i = 0; i < 1500; ++i) samples.push_back(on_circle(i / 1500.0, 1.0 + 0.3 * std::cos(i * 0.02)));
  }
  SECTION("a cloud, where the crust branches everywhere") {
    for (int i = 0; i < 1500; ++i) samples.push_back({rng.uniform(), rng.uniform()});
  }
  SECTION("clusters of clusters") {
    for (int i = 0; i < 1200; ++i) {
      const double scale = std::ldexp(1.0, -static_cast<int>(rng.below(30)));
      samples.push_back({std::floor(4.0 * rng.uniform()) + scale * rng.uniform(),
                         std::floor(4.0 * rng.uniform()) + scale * rng.uniform()});
    }
  }
  SECTION("arcs of one circle, whose centre is the end of many edges") {
    for (int i = 0; i < 400; ++i)
      if (i % 100 < 37) samples.push_back(on_circle(i / 400.0));
  }
  SECTION("a whole circle, whose edges all end near its centre, nearer to each other than the samples") {
    for (int i = 0; i < 2500; ++i) samples.push_back(on_circle(i / 2500.0));
  }
  SECTION("a lattice, and one with noise in the last digits") {
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 30; ++j)
        samples.push_back({i + (j < 15 ? 0.0 : 1e-15 * rng.uniform(-1.0, 1.0)), static_cast<double>(j)});
  }
  SECTION("a curve on which some samples are nearly doubled") {
    for (int i = 0; i < 700; ++i) {
      samples.push_back(on_circle(i / 700.0, 1.0 + 0.2 * std::cos(i * 0.05) + 1e-3 * rng.uniform()));
      const double away = std::ldexp(1.0, -20 - static_cast<int>(rng.below(33)));
      if (i % 5 == 0) samples.push_back({samples.back().x + away, samples.back().y + away * rng.uniform()});
    }
  }
  SECTION("rows that are nearly straight, whose triangles are nearly flat") {
    for (int i = 0; i < 300; ++i)
      for (const double y : {0.0, 1.0, 3.0})
        samples.push_back({0.05 * i + 0.01 * rng.uniform(), y + std::ldexp(rng.uniform(-1.0, 1.0), -20 - i % 32)});
  }
  SECTION("a sample that is next to all others, at distances in no order") {
    samples.push_back({});
    for (int i = 0; i < 1500; ++i) {
      const Vec2 at = on_circle(rng.uniform());
      samples.push_back({at.x, 0.9 * at.y});
    }
  }
  SECTION("distances below the normal floats") {
    for (int i = 0; i < 120; ++i) {
      const double x = 1.0 + std::ldexp(static_cast<double>(rng.below(40)), -50);
      const double y = 1.0 + std::ldexp(static_cast<double>(rng.below(40)), -50);
      samples.push_back({std::ldexp(x, -100), std::ldexp(y, -100)});
    }
    samples.push_back({1.0, 0.5});
    samples.push_back({0.5, 1.0});
  }
  SECTION("a comb of closed loops and single samples") {
    for (int k = 0; k < 20; ++k)
      for (int i = 0; i < 3 + 3 * k; ++i) {
        const Vec2 at = on_circle(i / (3.0 + 3.0 * k), 0.3);
        samples.push_back({k + at.x, at.y});
      }
    for (int i = 0; i < 40; ++i) samples.push_back({20.0 * rng.uniform(), 3.0 * rng.uniform(-1.0, 1.0)});
  }
  SECTION("a sample far from thousands along which it walks, and many with short walks") {
    for (int i = 0; i < 5000; ++i) samples.push_back({1e-4 * i, 1e-4 * rng.uniform()});
    samples.push_back({1.1, 0.0});
  }
  check_least_of_all(samples);
}

// An arc of more than half a circle is reached from its samples; edges of others on the circle end at its centre, too,
// and no walk along the curve comes to them.
TEST_CASE("edges that meet in one point count all, whether the curve joins their samples or not") {
  std::vector<Vec2> circle;
  constexpr int kRadius = 1105;
  for (int x = -kRadius; x <= kRadius; ++x)
    for (int y = -kRadius; y <= kRadius; ++y)
      if (x * x + y * y == kRadius * kRadius) circle.push_back({static_cast<double>(x), static_cast<double>(y)});
  REQUIRE(circle.size() == 108);
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    const double first = rng.uniform(-0.5, 0.5);
    const double share = rng.uniform(0.48, 0.72);
    const double keep = rng.uniform(0.05, 0.5);
    std::vector<Vec2> samples;
    for (const Vec2 p : circle) {
      const double turn = std::remainder(std::atan2(p.y, p.x) / (2.0 * std::numbers::pi) - first, 1.0);
      if (std::abs(turn) < 0.5 * share || rng.uniform() < keep) samples.push_back(p);
    }
    const double farthest = rng.uniform(1.02, 2.0);
    for (std::uint64_t i = rng.below(60); i > 0; --i)
      samples.push_back(on_circle(first + 0.5 + 0.5 * (1.0 - share) * rng.uniform(-1.0, 1.0),
                                  kRadius * rng.uniform(1.003, farthest)));
    check_least_of_all(samples);
  }
}

TEST_CASE("without an axis there is no size, and the statistics say why") {
  for (const std::vector<Vec2>& samples :
       {std::vector<Vec2>{}, {{1, 1}}, {{0, 0}, {1, 0}}, {{0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {1, 0}, {0.5, 0.9}}}) {
    TestBench bench;
    show_density(bench);
    bench.replace(samples);
    CHECK(bench.instances("feature-size", PrimitiveKind::point).empty());
    CHECK(bench.instances("sampling-epsilon", PrimitiveKind::segment).empty());
    CHECK(bench.count("feature-size", "samples") == 0);
    const StatList stats = bench.get<FeatureSize>().statistics();
    CHECK(stats.back().key == "nothing_because");
  }
}
