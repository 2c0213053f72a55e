// SPDX-License-Identifier: GPL-3.0-or-later
// Rules under which the spacing changes along a curve.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/curves/jitter.h"
#include "core/curves/sampling.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::kPi;

namespace {

constexpr double kA = 3.0;
constexpr double kB = 1.0;

PlaneCurve ellipse() {
  PlaneCurve curve({kA, 0});
  curve.arc_to({{0, 0}, {kA, 0}, {0, kB}, 0.0, 2.0 * kPi}, {kA, 0});
  curve.close();
  return curve;
}

/// Distance to the axis of the ellipse, the segment between the centres of curvature at its ends.
double feature_size(Vec2 p) {
  const double reach = (kA * kA - kB * kB) / kA;
  return distance(p, {std::clamp(p.x, -reach, reach), 0.0});
}

FeatureSizes of_ellipse(int& asked) {
  return [&asked](std::span<const Vec2> places) -> Expected<std::vector<double>> {
    ++asked;
    std::vector<double> out;
    for (const Vec2 p : places) out.push_back(feature_size(p));
    return out;
  };
}

SampledCurves sampled_ellipse(const SamplingRequest& request, const FeatureSizes& sizes = {}) {
  auto samples = sample({.curves = {ellipse()}}, request, sizes);
  REQUIRE(samples);
  return *std::move(samples);
}

}  // namespace

TEST_CASE("an epsilon-sample is dense everywhere and not much denser than it must be") {
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const double epsilon : {0.05, 0.1, 0.25, 0.5}) {
    int asked = 0;
    const SampledCurves samples =
        sampled_ellipse({.rule = SamplingRule::feature_size, .count = 400, .epsilon = epsilon}, of_ellipse(asked));
    CHECK(asked > 0);
    CHECK(asked < 24);
    const std::size_t n = samples.positions.size();
    double sum = 0.0;  // of what the intervals use of what they may
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 a = samples.positions[i];
      const Vec2 b = samples.positions[(i + 1) % n];
      const double used = 0.5 * distance(a, b) / std::min(feature_size(a), feature_size(b));
      CHECK(used <= epsilon * (1 + 1e-9));
      sum += used;
    }
    CHECK(sum / static_cast<double>(n) > 0.7 * epsilon);
    CHECK(n < before);
    before = n;
  }
}

TEST_CASE("the first samples are as dense as feature sizes may grow from the bends of a curve on") {
  constexpr double kEpsilon = 0.25;  // of the samples that show the axis, to begin with
  constexpr int kSides = 360;
  PlaneCurve sides({kA, 0});
  for (int i = 1; i < kSides; ++i)
    sides.line_to({kA * std::cos(2.0 * kPi * i / kSides), kB * std::sin(2.0 * kPi * i / kSides)});
  sides.close();
  std::vector<Vec2> first;
  const auto samples = sample({.curves = {sides}}, {.rule = SamplingRule::feature_size, .count = 10, .epsilon = 0.1},
                              [&first](std::span<const Vec2> places) -> Expected<std::vector<double>> {
                                if (first.empty()) first.assign(places.begin(), places.end());
                                std::vector<double> out;
                                for (const Vec2 p : places) out.push_back(feature_size(p));
                                return out;
                              });
  REQUIRE(samples);
  REQUIRE(first.size() > 8);
  // At the narrow ends the radius of the bend is the size; from there on it grows by the way, which is less than one and
  // a half times the distance. Radii of bends grow several times as fast.
  const auto bound = [](Vec2 p) {
    return kB * kB / kA + 1.5 * std::min(distance(p, {kA, 0}), distance(p, {-kA, 0}));
  };
  for (std::size_t i = 1; i < first.size(); ++i)
    CHECK(0.5 * distance(first[i - 1], first[i]) <= kEpsilon * std::max(bound(first[i - 1]), bound(first[i])));
}

TEST_CASE("what is said of feature sizes counts: an error ends the sampling, without them there is none") {
  const SamplingRequest request{.rule = SamplingRule::feature_size, .count = 400};
  const auto none = sample({.curves = {ellipse()}}, request);
  REQUIRE_FALSE(none);
  CHECK(none.error().code == ErrorCode::usage);
  const auto failed = sample({.curves = {ellipse()}}, request, [](auto) -> Expected<std::vector<double>> {
    return std::unexpected(Error{ErrorCode::bad_input, "not here"});
  });
  REQUIRE_FALSE(failed);
  CHECK(failed.error().text == "not here");
  // A size of zero everywhere, as at a corner, asks for no more than the finest spacing.
  SamplingRequest few = request;
  few.count = 10;
  few.most = 100'000;
  const auto corner = sample({.curves = {ellipse()}}, few, [](auto places) -> Expected<std::vector<double>> {
    return std::vector<double>(places.size(), 0.0);
  });
  REQUIRE(corner);
  CHECK(corner->positions.size() > 9'000);
  CHECK(corner->positions.size() < 12'000);
  few.most = 500;
  CHECK_FALSE(sample({.curves = {ellipse()}}, few, [](auto places) -> Expected<std::vector<double>> {
    return std::vector<double>(places.size(), 0.0);
  }));
  // Without an axis as many as the bends ask for, of which there is a whole turn.
  const auto line = sample({.curves = {ellipse()}}, request, [](auto places) -> Expected<std::vector<double>> {
    return std::vector<double>(places.size(), std::numeric_limits<double>::infinity());
  });
  REQUIRE(line);
  CHECK(line->positions.size() >= 12);
  CHECK(line->positions.size() <= 16);
}

TEST_CASE("waves that lie between the samples of the first look are found") {
  // Feature sizes as the samples show them: of a circle, as long as there are too few samples to show the waves.
  constexpr int kWaves = 3000;
  const auto place = [](double turn) {
    const double radius = 1.0 + 1e-4 * std::cos(kWaves * turn);
    return Vec2{radius * std::cos(turn), radius * std::sin(turn)};
  };
  PlaneCurve waves(place(0.0));
  constexpr int kPieces = 12 * kWaves;
  for (int i = 1; i < kPieces; ++i) waves.line_to(place(2.0 * kPi * i / kPieces));
  waves.close();
  const auto of_circle = [](auto places) -> Expected<std::vector<double>> {
    return std::vector<double>(places.size(), 1.0);
  };
  const auto samples = sample({.curves = {waves}}, {.rule = SamplingRule::feature_size, .count = 400}, of_circle);
  REQUIRE(samples);
  // Each wave turns by four times the arc tangent of its slope, 0.3, and a sample stands for 0.45 of a radian at most.
  CHECK(static_cast<double>(samples->positions.size()) > 2.5 * kWaves);
}

TEST_CASE("rays from one point have equal samples, few rays or many") {
  for (const int rays : {6, 60, 70, 3000}) {
    INFO(rays << " rays");
    CurveSet star;
    for (int i = 0; i < rays; ++i) {
      PlaneCurve ray({0, 0});
      // As whole numbers, so that the middle is one point.
      ray.line_to(
          {std::round(1e6 * std::cos(2.0 * kPi * i / rays)), std::round(1e6 * std::sin(2.0 * kPi * i / rays))});
      star.curves.push_back(ray);
    }
    const auto samples = sample(star, {.rule = SamplingRule::adaptive, .count = static_cast<std::size_t>(20 * rays)});
    REQUIRE(samples);
    REQUIRE(samples->chains.size() == static_cast<std::size_t>(rays));
    const auto [least, most] = std::ranges::minmax(samples->chains, {}, &SampledCurves::Chain::count);
    CHECK(least.count > 5);
    CHECK(most.count <= least.count + 1);
  }
}

TEST_CASE("a stop that is requested ends the sampling of one curve, whatever the rule") {
  PlaneCurve circle({1, 0});
  constexpr int kPieces = 100'000;
  for (int i = 1; i < kPieces; ++i)
    circle.line_to({std::cos(2.0 * kPi * i / kPieces), std::sin(2.0 * kPi * i / kPieces)});
  circle.close();
  const CurveSet curves{.curves = {circle}};
  const auto none = [](auto places) -> Expected<std::vector<double>> {
    return std::vector<double>(places.size(), 1.0);
  };
  for (const SamplingRuleDescriptor& rule : sampling_rules()) {
    JobControl job;
    job.stop_at_look(5);
    const SamplingRequest request{.rule = rule.rule, .spacing = 1e-4, .count = 50'000};
    CHECK_THROWS_AS(sample(curves, request, none, &job), Cancelled);
  }
}

TEST_CASE("samples by curvature turn no more than asked for, and are as wide apart as they may be elsewhere") {
  const double turn = 0.1;
  const SampledCurves samples = sampled_ellipse({.rule = SamplingRule::curvature, .count = 60, .turn = turn});
  const std::size_t n = samples.positions.size();
  double widest = 0.0;
  double narrowest = 1e9;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = samples.positions[i];
    const Vec2 before = p - samples.positions[(i + n - 1) % n];
    const Vec2 after = samples.positions[(i + 1) % n] - p;
    CHECK(std::abs(std::atan2(cross(before, after), dot(before, after))) < 1.15 * turn);
    widest = std::max(widest, length(after));
    narrowest = std::min(narrowest, length(after));
  }
  // Radii of curvature are from 1/3 at the ends to 9.
  CHECK(narrowest < 0.25 * widest);
  CHECK(narrowest > 0.1 * widest);
}

namespace {

/// An ellipse of half axes 3 and 1 in arcs, from one of its points on.
PlaneCurve ellipse_from(double start) {
  const auto at = [](double angle) { return Vec2{3.0 * std::cos(angle), std::sin(angle)}; };
  constexpr int kArcs = 8;
  PlaneCurve out(at(start));
  for (int i = 0; i < kArcs; ++i) {
    const double begin = start + 2.0 * kPi * i / kArcs;
    const double sweep = 2.0 * kPi / kArcs;
    out.arc_to({{0, 0}, {3, 0}, {0, 1}, begin, sweep}, i + 1 == kArcs ? out.start() : at(begin + sweep));
  }
  out.close();
  return out;
}

/// Where the middle of an interval lies, and how long it is.
struct Gap {
  double angle = 0.0;
  double length = 0.0;
};

/// From the first sample on; the last one ends there.
std::vector<Gap> gaps_of(const SampledCurves& samples) {
  std::vector<Gap> out;
  const std::size_t n = samples.positions.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = samples.positions[i];
    const Vec2 b = samples.positions[(i + 1) % n];
    out.push_back({std::atan2(a.y + b.y, (a.x + b.x) / 3.0), distance(a, b)});
  }
  return out;
}

/// The length between those of the two that are nearest on both sides.
double length_at(double angle, const std::vector<Gap>& gaps) {
  Gap before{-10.0, 0.0};
  Gap after{10.0, 0.0};
  for (const Gap& gap : gaps) {
    const double away = std::remainder(gap.angle - angle, 2.0 * kPi);
    if (away <= 0.0 && away > before.angle) before = {away, gap.length};
    if (away >= 0.0 && away < after.angle) after = {away, gap.length};
  }
  if (before.angle == after.angle) return before.length;
  return before.length - before.angle / (after.angle - before.angle) * (after.length - before.length);
}

Expected<std::vector<double>> no_axis(std::span<const Vec2> places) {
  return std::vector<double>(places.size(), std::numeric_limits<double>::infinity());
}

}  // namespace

TEST_CASE("where a closed curve begins is seen neither in the number of its samples nor in their distances") {
  for (const SamplingRule rule : {SamplingRule::curvature, SamplingRule::feature_size}) {
    constexpr int kStarts = 16;
    std::vector<std::size_t> counts;
    std::vector<std::vector<Gap>> gaps;
    for (int i = 0; i < kStarts; ++i) {
      const PlaneCurve curve = ellipse_from(2.0 * kPi * i / kStarts + 0.01);
      const auto samples =
          sample({.curves = {curve}}, {.rule = rule, .count = 10, .turn = 0.1, .epsilon = 0.05}, no_axis);
      REQUIRE(samples);
      counts.push_back(samples->positions.size());
      gaps.push_back(gaps_of(*samples));
    }
    for (int i = 0; i < kStarts; ++i) {
      const std::vector<Gap>& here = gaps[static_cast<std::size_t>(i)];
      const std::vector<Gap>& opposite = gaps[static_cast<std::size_t>((i + kStarts / 2) % kStarts)];
      for (const Gap& gap : {here.front(), here.back()}) {
        const double ratio = gap.length / length_at(gap.angle, opposite);
        INFO(static_cast<int>(rule) << ' ' << i << ": " << ratio);
        CHECK(ratio > 0.95);
        CHECK(ratio < 1.05);
      }
    }
    const auto [least, most] = std::ranges::minmax(counts);
    CHECK(most - least <= 1);
  }
}

TEST_CASE("a bend at the beginning of a closed curve counts as it does elsewhere") {
  // A drop: nearly a circle of 200 vertices, with one turn of 0.45 where the others have about 0.03.
  std::vector<Vec2> drop;
  constexpr int kVertices = 200;
  for (int i = 0; i < kVertices; ++i) {
    const double turn = 2.0 * kPi * i / kVertices;
    const double radius = 1.0 + 0.22 * std::max(0.0, 1.0 - std::abs(std::remainder(turn, 2.0 * kPi)));
    drop.push_back({radius * std::cos(turn), radius * std::sin(turn)});
  }
  const auto near_tip = [&](int first) {
    PlaneCurve curve(drop[static_cast<std::size_t>(first)]);
    for (int i = 1; i < kVertices; ++i) curve.line_to(drop[static_cast<std::size_t>((first + i) % kVertices)]);
    curve.close();
    const auto samples =
        sample({.curves = {curve}}, {.rule = SamplingRule::feature_size, .count = 20, .epsilon = 0.05}, no_axis);
    REQUIRE(samples);
    return std::ranges::count_if(samples->positions, [&](Vec2 p) { return distance(p, drop[0]) < 0.1; });
  };
  const auto [least, most] = std::ranges::minmax({near_tip(10), near_tip(50), near_tip(100), near_tip(150)});
  CHECK(least >= 3);
  CHECK(most - least <= 2);
  for (const int beginning : {0, 1, 199}) {
    const auto here = near_tip(beginning);
    CHECK(here >= least - 1);
    CHECK(here <= most + 1);
  }
}

TEST_CASE("a jitter moves each sample by no more than asked for, as the seed says") {
  const SamplingRequest even{.rule = SamplingRule::count, .count = 200};
  SamplingRequest moved = even;
  moved.jitter = 0.5;
  const SampledCurves a = sampled_ellipse(even);
  const SampledCurves b = sampled_ellipse(moved);
  const SampledCurves again = sampled_ellipse(moved);
  moved.seed = 2;
  const SampledCurves other = sampled_ellipse(moved);
  REQUIRE(b.positions.size() == a.positions.size());
  CHECK(b.chains == a.chains);
  CHECK(again.positions == b.positions);
  CHECK(other.positions != b.positions);
  double perimeter = 0.0;
  for (std::size_t i = 0; i < 200; ++i) perimeter += distance(a.positions[i], a.positions[(i + 1) % 200]);
  double farthest = 0.0;
  for (std::size_t i = 0; i < 200; ++i) farthest = std::max(farthest, distance(a.positions[i], b.positions[i]));
  CHECK(farthest <= 0.5 * perimeter / 200 * (1 + 1e-12));
  CHECK(farthest > 0.4 * perimeter / 200);
}

TEST_CASE("requests that make no sense are refused") {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  using Rule = SamplingRule;
  for (const SamplingRequest& request :
       std::array{SamplingRequest{.rule = Rule::spacing, .spacing = 0.0},
                  SamplingRequest{.rule = Rule::spacing, .spacing = kNaN}, SamplingRequest{.rule = Rule::count},
                  SamplingRequest{.rule = Rule::adaptive},
                  SamplingRequest{.rule = Rule::curvature, .count = 10, .turn = 0.0},
                  SamplingRequest{.rule = Rule::feature_size, .count = 10, .epsilon = kNaN},
                  SamplingRequest{.corner_angle = -1.0}, SamplingRequest{.corner_radius = -1.0},
                  SamplingRequest{.corner_radius = std::numeric_limits<double>::infinity()},
                  SamplingRequest{.jitter = -0.1}, SamplingRequest{.jitter = kNaN}}) {
    const auto good = check(request);
    REQUIRE_FALSE(good);
    CHECK(good.error().code == ErrorCode::usage);
    CHECK_FALSE(sample({.curves = {ellipse()}}, request));
  }
  CHECK(check({}));
}

TEST_CASE("rules are listed in their order, each with a name of its own") {
  const auto rules = sampling_rules();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    CHECK(static_cast<std::size_t>(rules[i].rule) == i);
    for (std::size_t j = 0; j < i; ++j) CHECK(rules[i].id != rules[j].id);
  }
}

TEST_CASE(
    "of many vertices that are near enough to each other the vertices are the samples, and a wide gap is filled") {
  constexpr std::size_t kMany = 30'000;
  const auto at = [](std::size_t i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(kMany);
    return Vec2{std::cos(angle), 0.5 * std::sin(angle)};
  };
  for (const std::size_t gap : {std::size_t{0}, kMany / 2}) {
    PlaneCurve curve(at(gap));
    for (std::size_t i = gap + 1; i < kMany; ++i) curve.line_to(at(i));
    curve.close();
    const CurveSet curves{.curves = {curve}};
    const SamplingRequest request = default_sampling(curves);
    CHECK(request.rule == SamplingRule::refined);
    const auto samples = sample(curves, request);
    const auto vertices = sample(curves, {.rule = SamplingRule::vertices});
    REQUIRE(samples);
    REQUIRE(vertices);
    if (gap == 0)
      CHECK(samples->positions == vertices->positions);
    else
      CHECK(samples->positions.size() >= vertices->positions.size() + 30);
    CHECK(samples->chains.size() == 1);
  }
}
