// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/curves/sampling.h"
#include "tests/curves/curve_parts.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::circle_around;
using mes::test::kPi;
using mes::test::polygon;

namespace {

SampledCurves sampled(const PlaneCurve& curve, const SamplingRequest& request) {
  auto samples = sample({.curves = {curve}}, request);
  REQUIRE(samples.has_value());
  return *std::move(samples);
}

bool holds(const std::vector<Vec2>& points, Vec2 wanted) {
  return std::ranges::find(points, wanted) != points.end();
}

/// Length of a curve between two parameters by many chords, as an oracle.
double length_of_part(const Piece& piece, double begin, double end) {
  constexpr int kChords = 20000;
  double sum = 0.0;
  for (int i = 0; i < kChords; ++i)
    sum +=
        distance(piece.at(begin + (end - begin) * i / kChords), piece.at(begin + (end - begin) * (i + 1) / kChords));
  return sum;
}

}  // namespace

TEST_CASE("samples of a circle lie on it, evenly spaced") {
  const SampledCurves samples = sampled(circle_around({3, -2}, 5), {.rule = SamplingRule::count, .count = 100});
  REQUIRE(samples.positions.size() == 100);
  REQUIRE(samples.chains.size() == 1);
  CHECK(samples.chains[0] == SampledCurves::Chain{true, 0, 100});
  for (std::size_t i = 0; i < 100; ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / 100.0;
    CHECK(std::abs(distance(samples.positions[i], {3, -2}) - 5.0) < 5e-12);
    CHECK(distance(samples.positions[i], {3 + 5 * std::cos(angle), -2 + 5 * std::sin(angle)}) < 5e-12);
  }
}

TEST_CASE("samples of an ellipse and of a cubic are at equal lengths of arc") {
  PlaneCurve ellipse({4, 0});
  ellipse.arc_to({{0, 0}, {4, 0}, {0, 1}, 0.0, 2.0 * kPi}, {4, 0});
  ellipse.close();
  const SampledCurves around = sampled(ellipse, {.rule = SamplingRule::count, .count = 64});
  REQUIRE(around.positions.size() == 64);
  Piece whole;
  ellipse.for_each_piece([&](const Piece& piece) { whole = piece; });
  const double each = length_of_part(whole, 0.0, 1.0) / 64.0;
  for (std::size_t i = 0; i < 64; ++i) {
    const Vec2 p = around.positions[i];
    const Vec2 q = around.positions[(i + 1) % 64];
    double t = std::atan2(p.y, p.x / 4) / (2 * kPi);
    double s = std::atan2(q.y, q.x / 4) / (2 * kPi);
    if (t < -1e-9) t += 1;
    if (s < t) s += 1;
    CHECK(std::hypot(p.x / 4, p.y) == Approx(1.0).epsilon(1e-12));
    CHECK(length_of_part(whole, t, std::min(s, 1.0)) == Approx(each).epsilon(1e-6));
  }

  // (t, t^2): its length from 0 to t is t sqrt(1 + 4 t^2) / 2 + asinh(2 t) / 4.
  PlaneCurve parabola({0, 0});
  parabola.cubic_to({1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1});
  const auto length_to = [](double t) { return t * std::sqrt(1 + 4 * t * t) / 2 + std::asinh(2 * t) / 4; };
  const SampledCurves along = sampled(parabola, {.rule = SamplingRule::count, .count = 11});
  REQUIRE(along.positions.size() == 11);
  CHECK_FALSE(along.chains[0].is_closed);
  for (std::size_t i = 0; i <= 10; ++i) {
    const Vec2 p = along.positions[i];
    CHECK(p.y == Approx(p.x * p.x).margin(1e-12));
    CHECK(length_to(p.x) == Approx(length_to(1.0) * static_cast<double>(i) / 10.0).margin(1e-10));
  }
}

TEST_CASE("corners and ends are samples, and no two neighbours are farther apart than asked") {
  const std::vector<Vec2> corners{{0, 0}, {10, 0}, {10, 3}, {4, 3}, {0, 8}};
  for (const bool is_closed : {true, false}) {
    const SampledCurves samples =
        sampled(polygon(corners, is_closed), {.rule = SamplingRule::spacing, .spacing = 0.7});
    for (const Vec2 corner : corners) CHECK(holds(samples.positions, corner));
    REQUIRE(samples.chains.size() == 1);
    CHECK(samples.chains[0].is_closed == is_closed);
    for (std::size_t i = 1; i < samples.positions.size(); ++i)
      CHECK(distance(samples.positions[i - 1], samples.positions[i]) <= 0.7 * (1 + 1e-9));
    const double last = distance(samples.positions.back(), samples.positions.front());
    CHECK((last <= 0.7 * (1 + 1e-9)) == is_closed);
  }
  // A spacing that divides the sides gives just that many.
  CHECK(sampled(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {.rule = SamplingRule::spacing, .spacing = 0.1})
            .positions.size() == 40);
}

TEST_CASE("a tangent that turns less than a corner is no sample of its own") {
  // A regular polygon of 60 sides turns by 6 degrees at each vertex; its edges have length 2 sin(3 degrees).
  std::vector<Vec2> points;
  for (int i = 0; i < 60; ++i) points.push_back({std::cos(i * kPi / 30), std::sin(i * kPi / 30)});
  const SampledCurves samples = sampled(polygon(points), {.rule = SamplingRule::count, .count = 50});
  CHECK(samples.positions.size() == 50);
  const SampledCurves sharp =
      sampled(polygon(points), {.rule = SamplingRule::count, .count = 70, .corner_angle = 0.1});
  CHECK(sharp.positions.size() == 60);
}

TEST_CASE("what closes a curve by the digits left out makes no corner") {
  // A circle of two halves that ends a little beside its start.
  PlaneCurve curve({1, 0});
  curve.arc_to({{0, 0}, {1, 0}, {0, 1}, 0.0, kPi}, {-1, 0});
  curve.arc_to({{0, 0}, {1, 0}, {0, 1}, kPi, kPi}, {1, -1e-5});
  curve.close();
  const SampledCurves samples = sampled(curve, {.rule = SamplingRule::count, .count = 20});
  REQUIRE(samples.positions.size() == 20);
  for (std::size_t i = 0; i < 20; ++i)
    CHECK(distance(samples.positions[i], samples.positions[(i + 1) % 20]) ==
          Approx(2 * std::sin(kPi / 20)).epsilon(1e-4));
}

TEST_CASE("a cusp within a piece is passed at even steps") {
  PlaneCurve cusp({0, 0});
  cusp.cubic_to({1, 1}, {0, 1}, {1, 0});
  const SampledCurves samples = sampled(cusp, {.rule = SamplingRule::count, .count = 41});
  REQUIRE(samples.positions.size() == 41);
  // Symmetric about x = 1/2: the sample in the middle is the cusp (1/2, 3/4).
  CHECK(distance(samples.positions[20], {0.5, 0.75}) < 1e-5);
  for (std::size_t i = 0; i < 41; ++i)
    CHECK(distance(samples.positions[i], {1 - samples.positions[40 - i].x, samples.positions[40 - i].y}) < 1e-6);
}

TEST_CASE("a number of samples is spread by length over all curves") {
  const CurveSet curves{.curves = {circle_around({0, 0}, 3), circle_around({10, 0}, 1)}, .points = {}};
  const auto samples = sample(curves, {.rule = SamplingRule::count, .count = 400});
  REQUIRE(samples.has_value());
  CHECK(samples->positions.size() == 400);
  REQUIRE(samples->chains.size() == 2);
  CHECK(samples->chains[0].count == 300);
  CHECK(samples->chains[1].count == 100);
  const auto few = sample(curves, {.rule = SamplingRule::count, .count = 4, .least_each = 8});
  REQUIRE(few.has_value());
  CHECK(few->chains[0].count == 8);
  CHECK(few->chains[1].count == 8);
}

TEST_CASE("where nothing is near, adaptive samples are as even as others") {
  const SampledCurves samples = sampled(circle_around({0, 0}, 1), {.rule = SamplingRule::adaptive, .count = 100});
  REQUIRE(samples.positions.size() == 100);
  for (std::size_t i = 0; i < 100; ++i)
    CHECK(distance(samples.positions[i], samples.positions[(i + 1) % 100]) ==
          Approx(2 * std::sin(kPi / 100)).epsilon(1e-9));
}

TEST_CASE("samples are as dense as curves are near to each other, within bounds") {
  const double inner = 10.0;
  for (const double gap : {0.5, 0.3, 0.01}) {
    const CurveSet curves{.curves = {circle_around({0, 0}, inner), circle_around({0, 0}, inner + gap)}, .points = {}};
    const auto samples = sample(curves, {.rule = SamplingRule::adaptive, .count = 400, .share = 0.4});
    REQUIRE(samples.has_value());
    const double widest = 2 * kPi * (2 * inner + gap) / 400;
    const double wanted = std::max(0.4 * gap, widest / 8);
    REQUIRE(samples->chains.size() == 2);
    for (const SampledCurves::Chain& chain : samples->chains)
      for (std::size_t i = 1; i < chain.count; ++i)
        CHECK(distance(samples->positions[chain.first + i - 1], samples->positions[chain.first + i]) ==
              Approx(wanted).epsilon(0.03));
  }
}

TEST_CASE("a strip that narrows is sampled ever more densely, a right angle is not") {
  // Two legs that end one apart after 20; their distance grows evenly from 0.1.
  const SampledCurves strip = sampled(polygon({{20, 0.5}, {0, 0.05}, {0, -0.05}, {20, -0.5}}, false),
                                      {.rule = SamplingRule::adaptive, .count = 50, .share = 0.5});
  const double widest = 40.1 / 50;
  for (std::size_t i = 1; i < strip.positions.size(); ++i) {
    const Vec2 p = strip.positions[i - 1];
    const Vec2 q = strip.positions[i];
    if (std::min(p.x, q.x) < 0.5) continue;
    const double apart = 2 * (0.05 + 0.0225 * std::min(p.x, q.x));
    INFO(p.x << ' ' << q.x);
    CHECK(distance(p, q) <= 1.15 * std::min(widest, std::max(0.5 * apart, widest / 8)));
  }
  const SampledCurves square =
      sampled(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {.rule = SamplingRule::adaptive, .count = 40});
  CHECK(square.positions.size() == 40);
}

TEST_CASE("vertices are taken as they are, once each") {
  // An eight whose middle is a vertex twice, a repeated vertex, and a closing point.
  const SampledCurves samples = sampled(polygon({{0, 0}, {1, 1}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 0}}),
                                        {.rule = SamplingRule::vertices});
  CHECK(samples.positions == std::vector<Vec2>{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {0, 2}});
  REQUIRE(samples.chains.size() == 1);
  CHECK(samples.chains[0] == SampledCurves::Chain{true, 0, 5});
}

TEST_CASE("vertices of a circle of one or two arcs enclose an area") {
  for (const int arcs : {1, 2}) {
    PlaneCurve circle({5, 0});
    for (int i = 0; i < arcs; ++i) {
      const double turn = 2.0 * kPi / arcs;
      const EllipticArc arc{{0, 0}, {5, 0}, {0, 5}, turn * i, turn};
      circle.arc_to(arc, i + 1 == arcs ? Vec2{5, 0} : Vec2{-5, 0});
    }
    circle.close();
    const SampledCurves samples = sampled(circle, {.rule = SamplingRule::vertices});
    REQUIRE(samples.positions.size() == (arcs == 1 ? 3U : 4U));
    CHECK(samples.chains[0] == SampledCurves::Chain{true, 0, samples.positions.size()});
    double area = 0.0;
    for (std::size_t i = 0; i < samples.positions.size(); ++i) {
      CHECK(distance(samples.positions[i], {0, 0}) == Approx(5.0));
      area += 0.5 * cross(samples.positions[i], samples.positions[(i + 1) % samples.positions.size()]);
    }
    CHECK(area == Approx(arcs == 1 ? 25.0 * 0.75 * std::sqrt(3.0) : 50.0));
  }
}

TEST_CASE("points and curves without length are samples without a chain") {
  PlaneCurve dot({7, 7});
  dot.close();
  for (const SamplingRule rule : {SamplingRule::vertices, SamplingRule::count}) {
    const auto samples =
        sample({.curves = {dot, polygon({{0, 0}, {1, 0}}, false)}, .points = {{5, 5}}}, {.rule = rule, .count = 2});
    REQUIRE(samples.has_value());
    CHECK(samples->positions == std::vector<Vec2>{{7, 7}, {0, 0}, {1, 0}, {5, 5}});
    CHECK(samples->chains == std::vector<SampledCurves::Chain>{{false, 1, 2}});
  }
}

TEST_CASE("samples of one curve differ, whatever is asked for") {
  // Three times around one circle.
  PlaneCurve curve({1, 0});
  for (int i = 0; i < 3; ++i) curve.arc_to({{0, 0}, {1, 0}, {0, 1}, 0.0, 2.0 * kPi}, {1, 0});
  curve.close();
  const SampledCurves samples = sampled(curve, {.rule = SamplingRule::count, .count = 30});
  std::set<std::pair<double, double>> seen;
  for (const Vec2 p : samples.positions) CHECK(seen.emplace(p.x, p.y).second);
}

TEST_CASE("a sampling without bounds is refused") {
  const CurveSet curves{.curves = {circle_around({0, 0}, 1)}, .points = {}};
  const auto many = sample(curves, {.rule = SamplingRule::spacing, .spacing = 1e-9});
  REQUIRE_FALSE(many.has_value());
  CHECK(many.error().code == ErrorCode::bad_input);
  CHECK_THAT(many.error().text, Catch::Contains("10000000"));
  CHECK(sample(curves, {.rule = SamplingRule::spacing, .spacing = 0.0}).error().code == ErrorCode::usage);
  CHECK(sample(curves, {.rule = SamplingRule::count, .count = 100, .most = 99}).error().code == ErrorCode::bad_input);
  const CurveSet endless{.curves = {polygon({{0, 0}, {HUGE_VAL, 0}})}, .points = {}};
  for (const SamplingRule rule : {SamplingRule::vertices, SamplingRule::count})
    CHECK(sample(endless, {.rule = rule, .count = 5}).error().code == ErrorCode::bad_input);
}

TEST_CASE("curves of any size are sampled, and too small a curve is a point beside them") {
  const auto loop = [](double size) {
    PlaneCurve out({0, 0});
    out.cubic_to({size, 0}, {size, size}, {0, size});
    out.close();
    return out;
  };
  const FeatureSizes sizes = [](std::span<const Vec2> places) { return std::vector<double>(places.size(), 1e300); };
  for (const SamplingRule rule : {SamplingRule::vertices, SamplingRule::spacing, SamplingRule::count,
                                  SamplingRule::adaptive, SamplingRule::curvature, SamplingRule::feature_size}) {
    const SamplingRequest request{.rule = rule, .spacing = 1e139, .count = 100};
    const auto count = [&](const std::vector<PlaneCurve>& curves) {
      const auto samples = sample({.curves = curves}, request, sizes);
      REQUIRE(samples);
      for (const Vec2 p : samples->positions) CHECK(is_finite(p));
      return samples->positions.size();
    };
    const std::size_t of_large = count({loop(1e140)});
    CHECK(of_large >= 2);
    CHECK(count({loop(1e-318), loop(1e-310)}) >= 2);
    // A number that is asked for counts the points, too, though they lie where the large curve begins.
    const std::size_t of_mixed = count({loop(1e-318), loop(1e140), loop(1e-200)});
    CHECK(of_mixed + 2 >= of_large);
    CHECK(of_mixed <= of_large + (rule == SamplingRule::vertices ? 4 : 2));
    const auto beyond = sample({.curves = {loop(1e308), loop(1e-318)}}, request, sizes);
    if (rule == SamplingRule::vertices || rule == SamplingRule::spacing) continue;
    REQUIRE_FALSE(beyond);
    CHECK(beyond.error().text == "the curves reach beyond the range of numbers");
  }
}

TEST_CASE("what has been sampled already keeps its vertices when it is opened, and only these") {
  std::vector<Vec2> points;
  for (int i = 0; i < 400; ++i) points.push_back({std::cos(i * kPi / 200), std::sin(i * kPi / 200)});
  const auto opened = [](const PlaneCurve& curve) { return sampled(curve, default_sampling({.curves = {curve}})); };
  CHECK(opened(polygon(points)).positions == points);
  // A square of four vertices is not sampled yet.
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const SampledCurves around = opened(polygon(square));
  CHECK(around.positions.size() >= kUsualSamples);
  CHECK(around.positions.size() <= kUsualSamples + 40);  // nearer to each other at corners
  for (const Vec2 corner : square) CHECK(holds(around.positions, corner));
  const SamplingRequest round = default_sampling({.curves = {circle_around({0, 0}, 1)}});
  CHECK(round.rule == SamplingRule::adaptive);
  CHECK(round.count == kUsualSamples);
  CHECK(default_sampling({.points = points}).rule == SamplingRule::vertices);
}

TEST_CASE("of vertices at one place the first counts, whichever sign a zero has") {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {1, 1}, {1, 0}, {-0.0, 0.0}, {2, -0.0}, {2, 0}, {0, 1}};
  const SampledCurves samples = sampled(polygon(points), {.rule = SamplingRule::vertices});
  CHECK(samples.positions == std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {2, 0}, {0, 1}});
  REQUIRE(samples.chains.size() == 1);
  CHECK(samples.chains[0] == SampledCurves::Chain{true, 0, 5});
}

TEST_CASE("vertices that come again are found among many") {
  // A curve that runs along a lattice twice.
  std::vector<Vec2> points;
  constexpr int kSide = 300;
  for (int twice = 0; twice < 2; ++twice)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  const SampledCurves samples = sampled(polygon(points), {.rule = SamplingRule::vertices});
  points.resize(kSide * kSide);
  CHECK(samples.positions == points);
}
