// SPDX-License-Identifier: GPL-3.0-or-later
// Cover dates against all pairs of balls, bit for bit.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/filters/cover_dates.h"
#include "core/structures/filters/internal/cover_search.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

std::vector<FaceSlot> nodes(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& balls = bench.get<InnerBalls>();
  std::vector<FaceSlot> out;
  for (const FaceSlot face : delaunay.face_slots())
    if (delaunay.is_finite_face(face) && balls.is_ball(face) && balls.ball(face) == face) out.push_back(face);
  return out;
}

void check_all_pairs(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& dates = bench.get<CoverDates>();
  const std::vector<FaceSlot> all = nodes(bench);
  std::size_t wrong = 0;
  for (const FaceSlot i : all) {
    REQUIRE(dates.has_date(i));
    double least = std::numeric_limits<double>::infinity();
    for (const FaceSlot j : all) {
      const double more = delaunay.circumradius(j) - delaunay.circumradius(i);
      if (more > 0.0)
        least = std::min(least, std::max(1.0, distance(delaunay.circumcenter(i), delaunay.circumcenter(j)) / more));
    }
    wrong += dates.date(i) == least ? 0U : 1U;
  }
  REQUIRE(wrong == 0);
  std::size_t dated = 0;
  for (const FaceSlot face : delaunay.face_slots()) dated += dates.has_date(face) ? 1U : 0U;
  REQUIRE(dated == all.size());
}

}  // namespace

TEST_CASE("cover dates are the least quotients of all pairs, bit for bit, after every edit") {
  std::vector<std::vector<Vec2>> inputs;
  for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 4})) inputs.push_back(shape.data.positions);
  for (const DegenerateInput& input : degenerate_inputs()) inputs.push_back(input.positions);
  // Along even slopes many balls are swallowed at nearly the same factor, about the centre of a circle many balls are
  // nearly equal, and noise across the curve gives hairs.
  inputs.push_back(ellipse(3.0, 1.0, 1500, {0.0, 0.25, 1}).data.positions);
  std::vector<Vec2>& turned = inputs.emplace_back(ellipse(3.0, 1.0, 500, {0.3, 0.0, 1}).data.positions);
  for (Vec2& p : turned) p = {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y};
  inputs.push_back(stadium(3.0, 1.0, 0.02, {0.0, 0.25, 1}).data.positions);
  Rng rng(9);
  std::vector<Vec2> circle;
  std::vector<Vec2> hairy;
  for (int i = 0; i < 600; ++i) {
    const double spacing = 2.0 * std::numbers::pi / 600.0;
    const double turn = spacing * (i + rng.uniform(-0.3, 0.3));
    const double away = 1.0 + spacing * rng.uniform(-0.3, 0.3);
    const Vec2 outward{std::cos(turn), std::sin(turn)};
    circle.push_back(outward);
    hairy.push_back(Vec2{3.0 * away * outward.x, away * outward.y});
  }
  inputs.push_back(circle);
  inputs.push_back(hairy);
  // Far from the origin, where the middle of a box is rounded to one of few places in it.
  std::vector<Vec2>& far = inputs.emplace_back(hairy);
  for (Vec2& p : far) p = {p.x + 0x1p36, p.y - 0x1p36};
  std::vector<Vec2> random;
  for (int i = 0; i < 600; ++i) random.push_back({rng.uniform(), rng.uniform()});
  inputs.push_back(random);
  // Squares of these leave the range of doubles, or nearly so.
  for (const double scale : {0x1p-460, 0x1p-448, 0x1p448, 0x1p460}) {
    std::vector<Vec2>& scaled = inputs.emplace_back(random);
    for (Vec2& p : scaled) p = scale * p;
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    INFO("input " << i);
    TestBench bench;
    bench.show({"cover-dates"});
    bench.replace(inputs[i]);
    check_all_pairs(bench);
    if (inputs[i].size() < 8) continue;
    for (int step = 0; step < 3; ++step) {
      const auto ids = bench.ids();
      bench.remove({ids[rng.below(ids.size())]});
      check_all_pairs(bench);
    }
  }
}

TEST_CASE(
    "along the axis of an ellipse a ball is swallowed by its larger neighbour first, at the slope of the radius") {
  // r(x) = sqrt(1 - x^2 / c2) grows towards the middle at the rate |x| / (c2 r): the date is at least the inverse of the
  // largest rate on the way, and at the end of the axis near 1.
  TestBench bench;
  bench.show({"cover-dates"});
  bench.replace(ellipse(3.0, 1.0, 400, {0.3, 0.0, 1}).data.positions);
  const auto& delaunay = bench.get<Delaunay>();
  const auto& dates = bench.get<CoverDates>();
  const double c2 = 8.0;
  std::size_t looked_at = 0;
  for (const FaceSlot face : nodes(bench)) {
    const double x = std::abs(delaunay.circumcenter(face).x);
    if (x < 0.5 || x > 2.6) continue;
    const double rate = x / (c2 * std::sqrt(1.0 - x * x / c2));
    CHECK(dates.date(face) == Approx(1.0 / rate).epsilon(0.05));
    ++looked_at;
  }
  CHECK(looked_at > 100);
  CHECK(bench.count("cover-dates", "never_covered") >= 1);
}

namespace {

/// Of balls that need not be those of any axis: they may be nested, or touch, or be the same.
void check_search(const std::vector<Disk>& balls, const std::vector<CoverSearch::Hints>& hints) {
  const CoverSearch search(balls, hints);
  std::vector<double> found(balls.size(), -1.0);
  JobControl job;
  for (std::size_t part = 0; part < search.part_count(); ++part) search.search(part, found, job);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (const Disk& other : balls)
      if (const double more = other.radius - balls[i].radius; more > 0.0)
        least = std::min(least, std::max(1.0, distance(balls[i].center, other.center) / more));
    wrong += found[i] == least ? 0U : 1U;
  }
  REQUIRE(wrong == 0);
}

}  // namespace

TEST_CASE("a search for covers finds the least quotient of all pairs, whatever the balls are") {
  Rng rng(21);
  const auto noise = [&] { return rng.uniform(-1.0, 1.0); };
  std::vector<Disk> balls;
  std::size_t count = 3000;
  SECTION("a few, so that leaves are not full") {
    count = rng.below(70);
    for (std::size_t i = 0; i < count; ++i) balls.push_back({{noise(), noise()}, rng.uniform()});
  }
  SECTION("in no order, many of them nested") {
    for (std::size_t i = 0; i < count; ++i) balls.push_back({{noise(), noise()}, rng.uniform()});
  }
  SECTION("hardly different in radius") {
    for (std::size_t i = 0; i < count; ++i) balls.push_back({{noise(), noise()}, 1.0 + 1e-3 * rng.uniform()});
  }
  SECTION("of magnitudes that have nothing in common, in clusters of clusters") {
    for (std::size_t i = 0; i < count; ++i) {
      const double scale = std::ldexp(1.0, -static_cast<int>(rng.below(60)));
      balls.push_back(
          {{static_cast<double>(rng.below(3)) + scale * noise(), scale * noise()}, scale * rng.uniform()});
    }
  }
  SECTION("of all magnitudes of doubles about the origin") {
    for (std::size_t i = 0; i < count; ++i) {
      const double scale = std::ldexp(1.0, static_cast<int>(rng.below(1600)) - 800);
      balls.push_back({{scale * noise(), scale * noise()}, scale * rng.uniform()});
    }
  }
  SECTION("far from the origin, where centres have few digits left") {
    for (std::size_t i = 0; i < count; ++i) {
      const double t = noise();
      balls.push_back({{0x1p40 + t, -0x1p41 + t * t + 1e-3 * noise()}, 1.0 + 0.5 * std::cos(3.0 * t)});
    }
  }
  SECTION("far from the origin on a grid of the last digit") {
    for (std::size_t i = 0; i < count; ++i)
      balls.push_back({{0x1p52 + static_cast<double>(rng.below(40)), 0x1p53 - static_cast<double>(rng.below(80))},
                       static_cast<double>(rng.below(60))});
  }
  SECTION("touching in one point from within, so that all quotients are nearly 1") {
    for (std::size_t i = 0; i < count; ++i) {
      const double radius = std::ldexp(1.0 + rng.uniform(), -static_cast<int>(rng.below(20)));
      balls.push_back({{1.0 - 0.6 * radius, 0.8 * radius}, radius});
    }
  }
  SECTION("touching circles through two points, the same ones several times") {
    for (std::size_t i = 0; i < count; ++i) {
      const double height = i % 3 == 0 ? 0.5 : std::ldexp(noise(), static_cast<int>(rng.below(12)));
      balls.push_back({{height, -2.0 * height}, std::sqrt(1.0 + 5.0 * height * height)});
    }
  }
  SECTION("on a line, with radii that rise evenly, so that all quotients are the same but for rounding") {
    for (std::size_t i = 0; i < count; ++i) {
      const double t = rng.uniform();
      balls.push_back({{3.0 * t, 4.0 * t}, 1.0 + t});
    }
  }
  SECTION("under a hillside with hairs") {
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 10.0 * noise();
      const double height = std::ldexp(1.0 + rng.uniform(), -static_cast<int>(rng.below(12)));
      balls.push_back({{x, height + 0.01 * x * x}, height * (1.0 - 1e-4 * rng.uniform())});
    }
  }
  SECTION("all the same") {
    balls.assign(100, {{1.0, 2.0}, 3.0});
  }
  check_search(balls, {});
  std::vector<CoverSearch::Hints> hints(balls.size());
  for (auto& own : hints)
    own = {static_cast<std::uint32_t>(rng.below(balls.size())), CoverSearch::kNone,
           static_cast<std::uint32_t>(rng.below(balls.size()))};
  check_search(balls, hints);
}

TEST_CASE("statistics say the limit that is set, also where it removes as much as the one before") {
  TestBench bench;
  bench.show({"cover-medial-axis"});
  bench.replace(ellipse(2.0, 1.0, 200, {0.3, 0.0, 1}).data.positions);
  for (const double factor : {1.0, 1.2, 0.8, 1.0}) {
    ComputationSettings settings;
    settings[Parameter::scale_axis_factor] = factor;
    bench.choose(settings);
    CHECK(bench.measure("cover-axis", "limit") == factor);
  }
}
