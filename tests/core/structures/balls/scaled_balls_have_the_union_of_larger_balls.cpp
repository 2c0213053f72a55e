// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters a-scale, p-scale and b-scale: balls that are scaled before their union is taken.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "core/base/rng.h"
#include "core/structures/balls/ball_union.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

struct Family {
  char letter;
  const Parameter& scale;
};
constexpr std::array kFamilies{Family{'a', Parameter::a_scale}, Family{'p', Parameter::p_scale},
                               Family{'b', Parameter::b_scale}};

ComputationSettings settings_at_scale(Precision precision, double scale) {
  ComputationSettings out;
  out.precision = precision;
  for (const Family& family : kFamilies) out[family.scale] = scale;
  return out;
}

/// All that is shown of unions.
std::vector<LayerIndex> layers_of_unions() {
  std::vector<LayerIndex> out;
  for (LayerIndex i = 0; i < layer_descriptors().size(); ++i) {
    const LayerGroup group = layer_descriptors()[i].group;
    if (group == LayerGroup::union_a || group == LayerGroup::union_p || group == LayerGroup::union_b)
      out.push_back(i);
  }
  return out;
}

void check_same_picture(const LayerContents& a, const LayerContents& b) {
  for (const LayerIndex layer : layers_of_unions()) {
    INFO(layer_descriptors()[layer].id);
    CHECK(a.sorted(layer) == b.sorted(layer));
  }
}

/// What a union is as complex and graph, whatever numbers it was found with.
std::vector<std::int64_t> shape_of(const TestBench& bench, std::string_view union_of) {
  std::vector<std::int64_t> out;
  for (const char* key : {"balls", "visible", "hidden", "duplicates", "dual_singular", "dual_regular",
                          "dual_interior", "dual_faces", "isolated", "v_points", "nodes", "edges", "components",
                          "cycles", "chi", "chi_dual", "lost_crossings", "contradictions", "negative_radicands"})
    out.push_back(bench.count(union_of, key));
  return out;
}

std::vector<Vec2> ellipse(std::size_t n) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.3) / static_cast<double>(n);
    out.push_back({20.0 * std::cos(t), 11.0 * std::sin(t)});
  }
  return out;
}

std::vector<Disk> scaled(std::vector<Disk> disks, double factor) {
  for (Disk& disk : disks) disk.radius *= factor;
  return disks;
}

// Small integers: circles that touch, hold each other, meet in one point, and are there twice.
std::vector<Disk> integer_disks(std::uint64_t seed, std::size_t count) {
  Rng rng(seed);
  std::vector<Disk> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back({{static_cast<double>(rng.below(9)), static_cast<double>(rng.below(9))},
                   static_cast<double>(1 + rng.below(3))});
  return out;
}

}  // namespace

TEST_CASE("the area of one ball grows with the square of the scale") {
  TestBench bench;
  bench.insert_balls({{{1.0, 2.0}, 3.0}});
  for (const Precision precision : {Precision::fast, Precision::exact, Precision::exact_roots}) {
    for (const double scale : {0.01, 0.5, 1.0, 1.03, 2.0, 100.0}) {
      bench.choose(settings_at_scale(precision, scale));
      CHECK(bench.measure("b-union", "area") == Approx(9.0 * std::numbers::pi * scale * scale).epsilon(1e-14));
    }
  }
}

TEST_CASE("scaled balls of one's own give the picture of balls with those radii") {
  // The product is not rounded, so it must be a double to begin with.
  for (const double scale : {2.0, 1.5, 0.5}) {
    for (const Precision precision : {Precision::fast, Precision::exact}) {
      INFO(scale << " in " << id_of(precision));
      const std::vector<Disk> disks = integer_disks(7, 12);
      TestBench small, large;
      small.choose(settings_at_scale(precision, scale));
      large.choose(settings_at_scale(precision, 1.0));
      small.insert_balls(disks);
      large.insert_balls(scaled(disks, scale));
      check_same_picture(small.contents(), large.contents());
    }
  }
}

TEST_CASE("rationals with roots where they are needed agree with roots throughout on scaled balls") {
  for (const double scale : {2.0, 1.5}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      INFO("scale " << scale << ", seed " << seed);
      TestBench bench;
      bench.show({"b-union-boundary", "b-ball-medial-axis"});
      bench.insert_balls(integer_disks(seed, 7));
      bench.choose(settings_at_scale(Precision::exact, scale));
      const auto by_rationals = shape_of(bench, "b-union");
      bench.choose(settings_at_scale(Precision::exact_roots, scale));
      CHECK(shape_of(bench, "b-union") == by_rationals);
      CHECK(bench.count("b-union", "chi") == bench.count("b-union", "chi_dual"));
    }
  }
}

TEST_CASE("scaled Voronoi balls are analysed alike in doubles and in exact numbers") {
  for (const double scale : {2.0, 1.5}) {
    INFO("scale " << scale);
    // Of few bits: v-points on one circle are cocircular, and to decide that costs by the bits.
    TestBench bench(std::vector<Vec2>{{0, 0}, {4, -1}, {8, 0}, {9, 3}, {7, 6}, {3, 7}, {-1, 4}});
    bench.show({"a-ball-medial-axis", "p-ball-medial-axis"});
    for (const std::string family : {"a-union", "p-union"}) {
      bench.choose(settings_at_scale(Precision::fast, scale));
      const auto by_doubles = shape_of(bench, family);
      const double area = bench.measure(family, "area");
      bench.choose(settings_at_scale(Precision::exact, scale));
      CHECK(shape_of(bench, family) == by_doubles);
      CHECK(bench.measure(family, "area") == Approx(area).epsilon(1e-12));
      CHECK(bench.count(family, "chi") == bench.count(family, "chi_dual"));
    }
    CHECK(bench.get<AUnion>().rung() == UnionRung::mixed);
  }
}

TEST_CASE("an edit with scaled balls ends in the picture of a rebuild") {
  for (const double scale : {1.2, 0.8}) {
    INFO("scale " << scale);
    Rng rng(5);
    TestBench bench(ellipse(40));
    bench.insert_balls(integer_disks(3, 8));
    bench.choose(settings_at_scale(Precision::fast, scale));
    for (int step = 0; step < 25; ++step) {
      INFO("step " << step);
      const auto ids = bench.ids();
      const auto balls = bench.ball_ids();
      const Vec2 offset{rng.uniform() - 0.5, rng.uniform() - 0.5};
      switch (step % 5) {
        case 0: bench.insert({ellipse(40)[rng.below(40)] + offset}); break;
        case 1: bench.remove({ids[rng.below(ids.size())]}); break;
        case 2: bench.change_ball(balls[rng.below(balls.size())], {offset, 1.0 + rng.uniform()}); break;
        case 3: bench.insert_balls({{9.0 * offset, rng.uniform()}}); break;
        default: bench.move(ids[rng.below(ids.size())], ellipse(40)[rng.below(40)] + offset); break;
      }
      TestBench fresh;
      fresh.choose(settings_at_scale(Precision::fast, scale));
      SampleData reversed{.positions = bench.positions(), .balls = bench.balls()};
      std::ranges::reverse(reversed.positions);
      std::ranges::reverse(reversed.balls);
      fresh.load(reversed);
      check_same_picture(bench.contents(), fresh.contents());
    }
  }
}

TEST_CASE("back at scale 1 everything is as it was, shortcut and all") {
  TestBench bench(ellipse(60));
  bench.insert_balls(integer_disks(2, 10));
  const LayerContents before = bench.contents();
  REQUIRE(bench.get<AUnion>().rung() == UnionRung::shortcut);
  for (const double scale : {1.03, 1.0 / 1.03, 3.0}) {
    bench.choose(settings_at_scale(Precision::fast, scale));
    CHECK(bench.get<AUnion>().rung() == UnionRung::mixed);
    bench.choose(settings_at_scale(Precision::fast, 1.0));
    CHECK(bench.get<AUnion>().rung() == UnionRung::shortcut);
    check_same_picture(bench.contents(), before);
  }
}

TEST_CASE("a family is scaled by its own parameter and by no other") {
  TestBench bench(ellipse(30));
  bench.insert_balls(integer_disks(4, 5));
  std::array<double, 3> before{};
  const auto area = [&](const Family& family) {
    return bench.measure(std::string{family.letter} + "-union", "area");
  };
  std::ranges::transform(kFamilies, before.begin(), area);
  for (const Family& scaled_one : kFamilies) {
    ComputationSettings settings;
    settings[scaled_one.scale] = 1.5;
    bench.choose(settings);
    for (std::size_t i = 0; i < kFamilies.size(); ++i) {
      INFO(scaled_one.letter << " scaled, " << kFamilies[i].letter);
      if (kFamilies[i].letter == scaled_one.letter)
        CHECK(area(kFamilies[i]) > 1.1 * before[i]);
      else
        CHECK(area(kFamilies[i]) == before[i]);
    }
  }
}

TEST_CASE("no scale carries balls beyond doubles; those of radius zero take no part") {
  for (const Precision precision : {Precision::fast, Precision::exact}) {
    TestBench bench;
    bench.insert_balls({{{0.0, 0.0}, 0x1p499}, {{-0x1p499, 0.0}, 0x1p399}, {{0x1p420, 0.0}, 0.0}});
    bench.choose(settings_at_scale(precision, 100.0));
    CHECK(bench.count("b-union", "balls") == 2);
    CHECK(bench.count("b-union", "ignored") == 1);
    bench.choose(settings_at_scale(precision, 0.01));
    CHECK(bench.count("b-union", "balls") == 2);
    CHECK(bench.count("b-union", "ignored") == 1);
  }
}
