// SPDX-License-Identifier: GPL-3.0-or-later
// Repair and decimation: what they promise, checked from the samples that come out.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/resampling/decimate.h"
#include "core/resampling/repair.h"
#include "core/structures/density/feature_size.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

std::vector<Vec2> ellipse_points(std::size_t n, double a = 3.0, double b = 1.0) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.3) / static_cast<double>(n);
    out.push_back({a * std::cos(t), b * std::sin(t)});
  }
  return out;
}

/// Sides of four, `per_side` samples each, from corner to corner.
std::vector<Vec2> square_points(int per_side) {
  std::vector<Vec2> out;
  const Vec2 corner[4]{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < per_side; ++i) {
      const double u = static_cast<double>(i) / per_side;
      out.push_back((1.0 - u) * corner[side] + u * corner[(side + 1) % 4]);
    }
  return out;
}

SampleData loop_of(std::vector<Vec2> positions) {
  SampleData out{.positions = std::move(positions)};
  SampleData::Contour& contour = out.contours.emplace_back();
  for (std::uint32_t i = 0; i < out.positions.size(); ++i) contour.points.push_back(i);
  return out;
}

Repair repaired(const SampleData& data, double epsilon = kDenseEpsilon) {
  JobControl job;
  auto out = repair(builtins(), data, epsilon, job);
  REQUIRE(out.has_value());
  // Samples stay, new ones follow.
  REQUIRE(out->data.positions.size() == data.positions.size() + out->inserted);
  REQUIRE(std::equal(data.positions.begin(), data.positions.end(), out->data.positions.begin()));
  return *std::move(out);
}

Decimation decimated(const SampleData& data, double epsilon) {
  JobControl job;
  auto out = decimate(builtins(), data, epsilon, job);
  REQUIRE(out.has_value());
  REQUIRE(std::ranges::is_sorted(out->removed));
  REQUIRE(out->removed.size() + out->data.positions.size() == data.positions.size());
  return *std::move(out);
}

/// The largest epsilon of the crust edges, from the layer that draws it.
double epsilon_drawn(const std::vector<Vec2>& positions) {
  TestBench bench;
  bench.show({"sampling-epsilon"});
  bench.replace(positions);
  double out = 0.0;
  const auto values = bench.instances("sampling-epsilon", PrimitiveKind::segment);
  for (std::size_t at = 0; at < values.size(); at += stride_of(PrimitiveKind::segment))
    out = std::max(out, values[at + 4]);
  return out;
}

}  // namespace

TEST_CASE("a change is said with the epsilons before and now, and ends with the verdict") {
  Repair repair;
  CHECK(repair.words().front() == "0 samples inserted; there is nothing to prove");
  repair.after = {.light = TheoremLight::green, .epsilon = SamplingEpsilon{.value = 0.2498, .corners = 1, .ends = 2}};
  CHECK(repair.words().front() == "0 samples inserted; before: no epsilon; now: " + repair.after.text());
  CHECK(repair.after.text() == "epsilon 0.25 (1 corner, 2 ends exempt); the theorem is proved for these samples");
  repair.before = {.light = TheoremLight::yellow, .epsilon = SamplingEpsilon{.value = 1.33, .is_estimate = true}};
  CHECK(repair.words().front() == "0 samples inserted; before: estimated epsilon 1.33; now: " + repair.after.text());
  Decimation decimation;
  decimation.before = decimation.after = repair.after;
  CHECK(decimation.words() ==
        "0 samples of 0 removed; the axis has 0 components and 0 cycles as before; " + repair.after.text());
}

TEST_CASE("a curve with too few samples is repaired to green, near the curve they came from") {
  for (const std::size_t n : {12U, 16U, 24U, 40U}) {
    for (const double a : {2.0, 3.0}) {
      INFO(n << " samples, a " << a);
      const SampleData data{.positions = ellipse_points(n, a)};
      const Repair repair = repaired(loop_of(data.positions));
      CHECK(repair.after.light == TheoremLight::green);
      CHECK(repair.corners.empty());
      CHECK(repair.left.empty());
      CHECK(repair.open_ends.empty());
      REQUIRE(repair.after.epsilon);
      CHECK(repair.after.epsilon->value <= kDenseEpsilon);
      if (n < 24) CHECK(repair.inserted > 0);
      CHECK(epsilon_drawn(repair.data.positions) == repair.after.epsilon->value);
      // The spline is near the ellipse, and nearer where there are more samples.
      double far = 0.0;
      for (const Vec2 p : repair.data.positions) far = std::max(far, std::abs(std::hypot(p.x / a, p.y) - 1.0));
      CHECK(far < 12.0 / static_cast<double>(n * n));
      // The loop holds each sample once, in the order of the angle.
      REQUIRE(repair.data.contours.size() == 1);
      const auto& loop = repair.data.contours.front().points;
      CHECK(std::set(loop.begin(), loop.end()).size() == repair.data.positions.size());
      std::size_t steps_back = 0;
      const auto angle = [&](std::uint32_t sample) {
        return std::atan2(repair.data.positions[sample].y, repair.data.positions[sample].x / a);
      };
      for (std::size_t i = 0; i < loop.size(); ++i)
        steps_back += angle(loop[(i + 1) % loop.size()]) < angle(loop[i]) ? 1U : 0U;
      CHECK(steps_back == 1);
    }
  }
}

TEST_CASE("what is dense enough is left alone, and repaired samples need no second repair") {
  const Repair dense = repaired({.positions = ellipse_points(400, 2.0)});
  CHECK(dense.inserted == 0);
  CHECK(dense.after.light == TheoremLight::green);
  CHECK(dense.before.epsilon == dense.after.epsilon);
  const Repair once = repaired(loop_of(ellipse_points(16)));
  CHECK(repaired(once.data).inserted == 0);
}

TEST_CASE("a place that a loop names twice in a row is one") {
  const std::vector<Vec2> once = ellipse_points(16);
  const Repair expected = repaired(loop_of(once));
  for (const std::size_t at : {std::size_t{3}, std::size_t{15}}) {
    std::vector<Vec2> twice = once;
    twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(at), once[at]);
    const Repair found = repaired(loop_of(twice));
    CHECK(found.inserted == expected.inserted);
    CHECK(found.after.light == expected.after.light);
  }
  std::vector<Vec2> closing = once;
  closing.push_back(once.front());
  CHECK(repaired(loop_of(closing)).inserted == expected.inserted);
}

TEST_CASE("a corner cannot be repaired, and its angle is said") {
  for (const int per_side : {6, 12}) {
    INFO(per_side << " samples a side");
    const Repair square = repaired(loop_of(square_points(per_side)));
    REQUIRE(square.corners.size() == 4);
    for (const SampledCorner& corner : square.corners) CHECK(corner.degrees == Approx(90.0));
    CHECK(square.after.epsilon->value <= kDenseEpsilon);
    CHECK(square.left.empty());
    // New samples are on the sides.
    for (const Vec2 p : square.data.positions)
      CHECK(std::min(std::min(std::abs(p.x), std::abs(p.x - 4)), std::min(std::abs(p.y), std::abs(p.y - 4))) < 1e-12);
    const std::string all = [&] {
      std::string out;
      for (const std::string& sentence : square.words()) out += sentence + '\n';
      return out;
    }();
    CHECK_THAT(all, Catch::Contains("4 corners") && Catch::Contains("90 degrees"));
  }
}

TEST_CASE("edges that no density repairs get no samples, and all others are repaired as without them") {
  // One sample of a side, among others, lies far along the same side: the curve runs there three times.
  SampleData data = loop_of(square_points(40));
  data.positions[10] = {3.0625, 0.0};
  for (const double scale : {1.0, 0.125}) {
    SampleData scaled = data;
    for (Vec2& p : scaled.positions) p = scale * p;
    const Repair out = repaired(scaled);
    CHECK(out.inserted < scaled.positions.size());
    CHECK(out.left.size() >= 2);
    CHECK(out.left.size() <= 8);
    const auto& loop = out.data.contours.at(0).points;
    const auto far = std::ranges::find(loop, 10U);
    CHECK(*(far - 1) == 9);
    CHECK(*(far + 1) == 11);
  }
  // A spike through the opposite side.
  data = loop_of(square_points(40));
  data.positions[60] = {-3.0, 2.0};
  const Repair out = repaired(data);
  CHECK(out.inserted < data.positions.size());
  CHECK(out.after.light == TheoremLight::green);
}

TEST_CASE("open ends are reported, and inputs without a curve are left alone") {
  std::vector<Vec2> stroke;
  for (int i = 0; i < 20; ++i) stroke.push_back({0.1 * i, 0.02 * i * i / 20.0});
  const Repair open = repaired({.positions = stroke});
  CHECK(open.open_ends.size() == 2);
  for (const std::vector<Vec2>& input :
       {std::vector<Vec2>{}, {{1, 2}}, {{1, 2}, {3, 4}}, {{0, 0}, {1, 1}, {2, 2}}, {{1, 1}, {1, 1}, {1, 1}}}) {
    const Repair repair = repaired({.positions = input});
    if (repair.after.epsilon) CHECK(std::isfinite(repair.after.epsilon->value));
    CHECK(decimated({.positions = input}, 0.25).removed.empty());
  }
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    const Repair repair = repaired({.positions = input.positions});
    for (const Vec2 p : repair.data.positions) REQUIRE(is_finite(p));
    decimated({.positions = input.positions}, 0.25);
  }
}

TEST_CASE("decimation keeps the curve, the topology of the axis and the epsilon") {
  std::vector<std::vector<Vec2>> inputs{ellipse_points(600, 2.0), ellipse_points(600, 3.0)};
  for (const TestShape& shape : oracle_shapes(0.1, {0.3, 0.2, 4})) inputs.push_back(shape.data.positions);
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    for (const double epsilon : {0.15, 0.25}) {
      INFO("input " << k << " epsilon " << epsilon);
      const SampleData data{.positions = inputs[k]};
      TestBench before;
      before.show({"medial-axis", "feature-size", "curve"});
      before.replace(inputs[k]);
      const Decimation rest = decimated(data, epsilon);
      TestBench after;
      after.show({"medial-axis", "sampling-epsilon", "curve"});
      after.replace(rest.data.positions);
      for (const char* key : {"components", "cycles"})
        CHECK(after.count("medial-axis", key) == before.count("medial-axis", key));
      CHECK(after.count("one-step-crust", "crust_edges") == static_cast<std::int64_t>(rest.data.positions.size()));
      CHECK(rest.after.light <= std::max(rest.before.light, TheoremLight::green));
      CHECK(epsilon_drawn(rest.data.positions) == rest.after.epsilon->value);
      CHECK(rest.after.epsilon->value <= std::max(epsilon, rest.before.epsilon->value));
      // Neighbours that were none before are near by the sizes of all samples.
      std::set<std::pair<double, double>> left;
      for (const Vec2 p : rest.data.positions) left.insert({p.x, p.y});
      for (const Vec2 p : inputs[k])
        if (left.contains({p.x, p.y})) left.erase({p.x, p.y});
      CHECK(left.empty());
      if (k < 2) CHECK(rest.removed.size() > inputs[k].size() / 2);
    }
  }
}

TEST_CASE("what is decimated and then repaired to the same epsilon gets nothing back, and corners stay") {
  const Decimation rest = decimated(loop_of(ellipse_points(500, 2.0)), 0.2);
  CHECK(rest.removed.size() > 200);
  REQUIRE(rest.data.contours.size() == 1);
  CHECK(rest.data.contours.front().points.size() == rest.data.positions.size());
  CHECK(repaired(rest.data, 0.2).inserted == 0);
  const std::vector<Vec2> square = square_points(50);
  const Decimation thin = decimated(loop_of(square), 0.25);
  for (const Vec2 corner : {Vec2{0, 0}, Vec2{4, 0}, Vec2{4, 4}, Vec2{0, 4}})
    CHECK(std::ranges::count(thin.data.positions, corner) == 1);
  CHECK(thin.removed.size() > 40);
}

TEST_CASE("parcels with common borders keep an axis each, and become as few as a single one") {
  // Two rectangles of 100 x 40 one above the other, with samples at each unit, of which the common side has one set.
  SampleData data;
  std::map<std::pair<double, double>, std::uint32_t> number_of;
  for (const double low : {0.0, 40.0}) {
    SampleData::Contour& contour = data.contours.emplace_back();
    const auto add = [&](double x, double y) {
      const auto [at, is_new] = number_of.try_emplace({x, low + y}, static_cast<std::uint32_t>(number_of.size()));
      if (is_new) data.positions.push_back({x, low + y});
      contour.points.push_back(at->second);
    };
    for (int i = 0; i < 100; ++i) add(i, 0);
    for (int i = 0; i < 40; ++i) add(100, i);
    for (int i = 0; i < 100; ++i) add(100 - i, 40);
    for (int i = 0; i < 40; ++i) add(0, 40 - i);
  }
  const Decimation rest = decimated(data, 0.5);
  CHECK(rest.components == 2);
  CHECK(rest.cycles == 0);
  CHECK(rest.removed.size() > 150);
  TestBench bench;
  bench.show({"medial-axis"});
  bench.load(rest.data);
  CHECK(bench.count("medial-axis", "components") == 2);
  CHECK(bench.count("medial-axis", "cycles") == 0);
}

TEST_CASE("repair and decimation of an input in another unit are those of the input") {
  for (const double scale : {0x1p-40, 0x1p30}) {
    std::vector<Vec2> scaled = ellipse_points(20);
    for (Vec2& p : scaled) p = scale * p;
    const Repair one = repaired(loop_of(ellipse_points(20)));
    const Repair other = repaired(loop_of(scaled));
    REQUIRE(one.data.positions.size() == other.data.positions.size());
    std::size_t differ = 0;
    for (std::size_t i = 0; i < one.data.positions.size(); ++i)
      differ += scale * one.data.positions[i] != other.data.positions[i] ? 1U : 0U;
    CHECK(differ == 0);
    std::vector<Vec2> dense = ellipse_points(200, 2.0);
    const Decimation first = decimated({.positions = dense}, 0.25);
    for (Vec2& p : dense) p = scale * p;
    CHECK(decimated({.positions = dense}, 0.25).removed == first.removed);
  }
}

TEST_CASE("a loop that passes a place or an edge twice is repaired as if it passed it once") {
  const auto loop = [](std::vector<Vec2> positions, std::vector<std::uint32_t> points) {
    SampleData out{.positions = std::move(positions)};
    out.contours.emplace_back().points = std::move(points);
    return out;
  };
  const std::vector<Vec2> once = ellipse_points(16);
  const Repair expected = repaired(loop_of(once));
  std::vector<std::uint32_t> around;
  for (std::uint32_t i = 0; i < 32; ++i) around.push_back(i % 16);
  const Repair twice = repaired(loop(once, around));
  CHECK(twice.inserted == expected.inserted);
  CHECK(twice.after.light == TheoremLight::green);
  CHECK(twice.open_ends.empty());
  REQUIRE(twice.data.contours.size() == 1);
  CHECK(twice.data.contours.front().points.size() == 2 * expected.data.positions.size());
  // Forth and back along the same edges, which is an open arc.
  SampleData arc = loop(once, {around.begin(), around.begin() + 16});
  arc.contours.front().closed = false;
  const Repair along = repaired(arc);
  std::vector<std::uint32_t> there_and_back = arc.contours.front().points;
  for (std::uint32_t i = 14; i != 0; --i) there_and_back.push_back(i);
  const Repair back = repaired(loop(once, there_and_back));
  CHECK(back.data.positions == along.data.positions);
  CHECK(back.after.light == along.after.light);
  CHECK(back.open_ends == along.open_ends);
  // Two loops of an eight that meet in one sample.
  std::vector<Vec2> eight;
  std::vector<std::uint32_t> points;
  for (int i = 0; i < 48; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 48.0;
    points.push_back(i == 24 ? 0 : static_cast<std::uint32_t>(eight.size()));
    if (i != 24) eight.push_back({3.0 * std::sin(t), std::sin(2.0 * t)});
  }
  const Repair named = repaired(loop(eight, points));
  REQUIRE(named.open_ends.size() == 1);
  CHECK(named.open_ends.front() == eight.front());
  CHECK(named.inserted < 200);
}

TEST_CASE("where there is no axis, repair and decimation say so and add nothing") {
  for (const std::vector<Vec2>& positions :
       {std::vector<Vec2>{}, {{3, 4}}, {{0, 0}, {1, 1}}, {{0, 0}, {1, 0}, {5, 0}}, {{0, 0}, {1, 0}, {0.5, 0.8}}}) {
    const Repair repair = repaired({.positions = positions});
    CHECK(repair.inserted == 0);
    REQUIRE(repair.words().size() == 1);
    CHECK_THAT(repair.words().front(), Catch::Contains("there is no axis"));
    CHECK_THAT(decimated({.positions = positions}, 0.25).words(), Catch::Contains("there is no axis"));
  }
  // Loops that go to and fro on a line, one of which no double lies on.
  for (const std::vector<Vec2>& positions :
       {std::vector<Vec2>{{0, 0}, {2, 0}, {1, 0}, {3, 0}}, {{0, 0}, {2, 1}, {1, 0.5}, {4, 2}, {3, 1.5}}}) {
    const Repair repair = repaired(loop_of(positions));
    CHECK(repair.inserted == 0);
    CHECK(repair.data.contours == loop_of(positions).contours);
    REQUIRE(repair.words().size() == 1);
    CHECK_THAT(repair.words().front(), Catch::Contains("there is no axis"));
  }
}

TEST_CASE("a corner that is passed twice is one corner") {
  std::vector<Vec2> drop;
  for (int i = 0; i < 80; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 80.0;
    const double half = std::sin(0.5 * t);
    drop.push_back({std::cos(t), std::sin(t) * half * half});
  }
  const SampleData once = loop_of(drop);
  drop.insert(drop.end(), once.positions.begin(), once.positions.end());
  const SampleData twice = loop_of(drop);
  REQUIRE(repaired(once).corners.size() == 1);
  REQUIRE(repaired(twice).corners.size() == 1);
  CHECK(repaired(twice).corners.front().degrees == repaired(once).corners.front().degrees);
}
