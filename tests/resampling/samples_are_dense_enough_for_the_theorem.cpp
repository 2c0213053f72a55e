// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of samples by local feature size is true where formulas say what the axis is.
#include <fmt/core.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/geometry/box2.h"
#include "core/resampling/resampling.h"
#include "tests/curves/curve_parts.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::ellipse_around;
using mes::test::kPi;
using mes::test::polygon;

namespace {

std::shared_ptr<const CurveSet> shape(PlaneCurve curve) {
  CurveSet out;
  out.curves.push_back(std::move(curve));
  return std::make_shared<const CurveSet>(std::move(out));
}

SamplingRequest by_feature_size(double epsilon) {
  return {.rule = SamplingRule::feature_size, .count = 400, .epsilon = epsilon};
}

TakenSamples taken(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request) {
  JobControl job;
  auto out = take_samples(curves, request, job);
  REQUIRE(out);
  return *std::move(out);
}

}  // namespace

TEST_CASE("an ellipse is sampled by its feature size until the theorem is proved") {
  constexpr double kA = 3.0;
  constexpr double kB = 1.0;
  const auto curves = shape(ellipse_around({0, 0}, kA, kB));
  const double reach = (kA * kA - kB * kB) / kA;
  for (const double epsilon : {0.25, 0.1}) {
    const TakenSamples samples = taken(curves, by_feature_size(epsilon));
    CHECK(samples.is_proved());
    CHECK(samples.corners.empty());
    CHECK(samples.standing.epsilon > 0.5 * epsilon);
    CHECK(samples.standing.epsilon <= epsilon);
    const std::vector<Vec2>& p = samples.data.positions;
    for (std::size_t i = 0; i < p.size(); ++i) {
      CHECK(std::abs(std::hypot(p[i].x / kA, p[i].y / kB) - 1.0) < 1e-12);
      const auto size = [&](Vec2 q) { return distance(q, {std::clamp(q.x, -reach, reach), 0.0}); };
      const Vec2 next = p[(i + 1) % p.size()];
      CHECK(0.5 * distance(p[i], next) <= epsilon * std::min(size(p[i]), size(next)));
    }
    REQUIRE(samples.data.source);
    CHECK(samples.data.source->curves == curves);
    CHECK(samples.data.source->count == p.size());
    CHECK(remark_of(samples, by_feature_size(epsilon)).ends_with("the theorem is proved for these samples"));
  }
}

TEST_CASE("where curves are near to each other there are more samples, and where they are far, fewer") {
  CurveSet pair;
  pair.curves = {ellipse_around({0, 0}, 1, 1), ellipse_around({2.02, 0}, 1, 1)};
  const TakenSamples samples = taken(std::make_shared<const CurveSet>(pair), by_feature_size(0.25));
  CHECK(samples.is_proved());
  double narrowest = 1e9;
  double widest = 0.0;
  for (const SampleData::Contour& contour : samples.data.contours)
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const Vec2 a = samples.data.positions[contour.points[i]];
      const Vec2 b = samples.data.positions[contour.points[(i + 1) % contour.points.size()]];
      narrowest = std::min(narrowest, distance(a, b));
      widest = std::max(widest, distance(a, b));
    }
  CHECK(narrowest < 0.01);
  CHECK(widest > 0.1);
}

TEST_CASE("at a corner intervals become as short as they may, and no longer where it is rounded") {
  // A wedge of 11.4 degrees.
  const auto wedge = shape(polygon({{0, 0}, {10, -1}, {10, 1}}));
  const TakenSamples sharp = taken(wedge, by_feature_size(0.25));
  CHECK(sharp.standing.exempt == 3);
  CHECK(sharp.standing.epsilon <= 0.25);
  CHECK_THAT(remark_of(sharp, by_feature_size(0.25)), Catch::Contains("(3 corners exempt)"));
  double narrowest = 1e9;
  for (std::size_t i = 1; i < sharp.data.positions.size(); ++i)
    narrowest = std::min(narrowest, distance(sharp.data.positions[i - 1], sharp.data.positions[i]));
  CHECK(narrowest < 1e-3);
  SamplingRequest round = by_feature_size(0.25);
  round.corner_radius = 0.2;
  const TakenSamples smooth = taken(wedge, round);
  CHECK(smooth.is_proved());
  CHECK(smooth.standing.exempt == 0);
  CHECK(smooth.data.positions.size() < sharp.data.positions.size());
}

TEST_CASE("what is said of samples that are proved names edges of the crust that are not of the curves") {
  const SamplingRequest request = by_feature_size(0.25);
  TakenSamples samples = taken(shape(ellipse_around({0, 0}, 3, 1)), request);
  REQUIRE(samples.is_proved());
  CHECK(samples.extra_edges.empty());
  samples.extra_edges = {{0.5, 2.0}};
  CHECK_THAT(remark_of(samples, request), Catch::EndsWith("but the crust has 1 edge off the curves (at 0.5 2)"));
  samples.extra_edges.push_back({7.0, 8.0});
  CHECK_THAT(remark_of(samples, request), Catch::EndsWith("has 2 edges off the curves (the first at 0.5 2)"));
  // Where two circles cross, some edges lead from one to the other.
  CurveSet cross;
  cross.curves = {ellipse_around({0, 0}, 2, 2), ellipse_around({2.5, 0.1}, 2, 2)};
  const TakenSamples crossing = taken(std::make_shared<const CurveSet>(cross), request);
  for (const Vec2 at : crossing.extra_edges) CHECK(std::abs(at.x - 1.25) < 0.3);
  CHECK_FALSE(crossing.extra_edges.empty());
}

TEST_CASE("where the theorem is not proved, the corner that is in the way is named with its angle") {
  // So few samples are allowed near the corners that the crust skips them.
  const auto zigzag = shape(polygon({{0, 0}, {10, 1}, {0, 0.02}, {10, 3}, {-10, 3}}));
  const TakenSamples samples = taken(zigzag, {.rule = SamplingRule::feature_size, .count = 8, .epsilon = 1.0});
  REQUIRE_FALSE(samples.is_proved());
  REQUIRE_FALSE(samples.corners.empty());
  for (const CurveCorner& corner : samples.corners) CHECK(corner.angle < 1.0);
  CHECK_THAT(remark_of(samples, by_feature_size(0.25)), Catch::Contains("not proved for these samples at"));
}

TEST_CASE("curves too near to each other to be sampled so densely are refused with a place between them") {
  // As near as samples may be, they are 15 apart.
  constexpr double kLong = 20000.0;
  constexpr double kThin = 0.01;
  PlaneCurve loop({0, 0});
  loop.cubic_to({kLong, kThin}, {kLong, 2 * kThin}, {0, 3 * kThin});
  loop.close();
  JobControl job;
  const SamplingRequest request{.rule = SamplingRule::feature_size, .count = 8, .epsilon = 0.25};
  for (const auto& curves : {shape(loop), shape(ellipse_around({0, 0}, kLong, kThin))}) {
    const auto refused = take_samples(curves, request, job);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::bad_input);
    CHECK_THAT(refused.error().text, Catch::Contains("too near to each other") && Catch::Contains("apart"));
  }
}

TEST_CASE(
    "where the crust joins the sides of something thin, nothing is proved of it until samples are dense enough") {
  // By their own axis samples were 330 apart with an epsilon of 1, and the sides 20 at most.
  const auto flat = shape(ellipse_around({0, 0}, 2e3, 10.0));
  const SamplingRequest request = by_feature_size(1.0);
  const TakenSamples samples = taken(flat, request);
  REQUIRE(samples.is_proved());
  const std::vector<Vec2>& p = samples.data.positions;
  std::size_t wide = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (distance(p[i], p[(i + 1) % p.size()]) > 40.0) ++wide;
  CHECK(wide < p.size() / 10);
}

TEST_CASE("where the theorem is not proved beside no corner, the place is said") {
  // A stroke that begins within a circle and leaves it.
  PlaneCurve stroke({1, 0});
  stroke.line_to({6, 0});
  CurveSet curves;
  curves.curves = {ellipse_around({0, 0}, 2, 2), stroke};
  const SamplingRequest request = by_feature_size(0.25);
  const TakenSamples samples = taken(std::make_shared<const CurveSet>(curves), request);
  REQUIRE_FALSE(samples.is_proved());
  CHECK(samples.corners.empty());
  REQUIRE_FALSE(samples.other_places.empty());
  const Vec2 place = samples.other_places.front();
  CHECK_THAT(remark_of(samples, request),
             Catch::Contains(fmt::format("other {} ({:.6g} {:.6g}",
                                         samples.other_places.size() == 1 ? "place" : "places", place.x, place.y)));
  // Its ends are such places too.
  for (const Vec2 one : samples.other_places) CHECK(std::min(distance(one, {2, 0}), distance(one, {6, 0})) < 1.5);
}

TEST_CASE("of many failures each place is said once") {
  // Strokes that begin within circles and leave them.
  constexpr int kSide = 3;
  constexpr double kStep = 12.0;
  CurveSet curves;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vec2 center{kStep * (i % kSide), kStep * (i / kSide)};
    PlaneCurve stroke(center + Vec2{1, 0});
    stroke.line_to(center + Vec2{6, 0});
    curves.curves.push_back(ellipse_around(center, 2, 2));
    curves.curves.push_back(stroke);
  }
  const TakenSamples samples = taken(std::make_shared<const CurveSet>(curves), by_feature_size(0.25));
  REQUIRE_FALSE(samples.is_proved());
  Box2 extent;
  for (const Vec2 p : samples.data.positions) extent.add(p);
  const double beside = 0.1 * 0.02 * length(Vec2{extent.width(), extent.height()});
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vec2 exit{kStep * (i % kSide) + 2.0, kStep * (i / kSide)};
    CHECK(std::ranges::any_of(samples.other_places, [exit](Vec2 p) { return distance(p, exit) < 1.5; }));
  }
  for (std::size_t i = 0; i < samples.other_places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      CHECK(distance(samples.other_places[k], samples.other_places[i]) >= beside * (1.0 - 1e-12));
}

TEST_CASE("the same curves elsewhere and in another unit are sampled the same") {
  const TakenSamples here = taken(shape(ellipse_around({0, 0}, 3, 1)), by_feature_size(0.2));
  constexpr double kUnit = 0x1p40;
  const TakenSamples large = taken(shape(ellipse_around({0, 0}, 3 * kUnit, kUnit)), by_feature_size(0.2));
  REQUIRE(large.data.positions.size() == here.data.positions.size());
  for (std::size_t i = 0; i < here.data.positions.size(); ++i)
    CHECK(large.data.positions[i] == kUnit * here.data.positions[i]);
  const TakenSamples far = taken(shape(ellipse_around({1e6, -1e6}, 3, 1)), by_feature_size(0.2));
  CHECK(far.data.positions.size() == here.data.positions.size());
  CHECK(far.is_proved());
}

TEST_CASE("what has no axis is sampled all the same") {
  const auto point = std::make_shared<const CurveSet>(CurveSet{.points = {{1, 2}}});
  CHECK(taken(point, by_feature_size(0.25)).data.positions == std::vector<Vec2>{{1, 2}});
  PlaneCurve line({0, 0});
  line.line_to({1, 0});
  const TakenSamples samples = taken(shape(line), by_feature_size(0.25));
  CHECK(samples.data.positions.size() >= 2);
  CHECK(samples.data.positions.front() == Vec2{0, 0});
  CHECK(samples.data.positions.back() == Vec2{1, 0});
  CHECK(taken(std::make_shared<const CurveSet>(), by_feature_size(0.25)).data.positions.empty());
}

TEST_CASE("a stop that is requested ends the sampling") {
  JobControl job;
  job.stop_at_look(3);
  CHECK_THROWS_AS(take_samples(shape(ellipse_around({0, 0}, 3, 1)), by_feature_size(0.01), job), Cancelled);
}

TEST_CASE("a curve through samples passes through each of them, and has its vertices there") {
  JobControl job;
  std::vector<Vec2> positions;
  constexpr int kSamples = 60;
  for (int i = 0; i < kSamples; ++i)
    positions.push_back({3 * std::cos(2 * kPi * i / kSamples), std::sin(2 * kPi * i / kSamples)});
  positions.push_back(positions[7]);
  positions.push_back({50, 50});
  const CurveSet curves = curves_through(positions, job);
  REQUIRE(curves.curves.size() == 1);
  CHECK(curves.curves[0].is_closed());
  CHECK(curves.curves[0].piece_count() == kSamples);
  CHECK(curves.points == std::vector<Vec2>{{50, 50}});
  const TakenSamples same = taken(std::make_shared<const CurveSet>(curves), {.rule = SamplingRule::vertices});
  std::vector<Vec2> sorted = same.data.positions;
  std::vector<Vec2> expected(positions.begin(), positions.end());
  expected.erase(expected.begin() + kSamples);
  std::ranges::sort(sorted, lexicographically_less);
  std::ranges::sort(expected, lexicographically_less);
  CHECK(sorted == expected);
}
