// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines of shapes whose axis is known, what smoothing and extending promise, and widths along lines.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/structures/filters/axis_center_lines.h"
#include "core/structures/filters/center_lines.h"
#include "core/workbench/workbench.h"
#include "tests/support/pi.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// The whole axis, and nothing that lines do not need.
struct LineBench {
  explicit LineBench(const SampleData& data) {
    REQUIRE(bench.need({bench.get<LambdaAxis>().id(), bench.get<AngleAxis>().id()}));
    ComputationSettings settings;
    settings[Parameter::lambda_limit] = 0.0;
    bench.choose(settings);
    REQUIRE(bench.load(data));
    JobControl job;
    REQUIRE(bench.run(job));
  }
  explicit LineBench(const std::vector<Vec2>& samples) : LineBench(SampleData{.positions = samples}) {}
  CenterLines lines(const CenterLineRequest& request = {}) const {
    const auto& lambda = bench.get<LambdaAxis>();
    JobControl job;
    const auto branches = branches_of(lambda, bench.get<InnerBalls>(), lambda, bench.get<AngleAxis>());
    return center_lines_of(lambda, bench.get<OneStepCrust>(), branches, request, job);
  }
  CenterLine line(double salience = 0.5) const {
    const CenterLines out = lines({.least_salience = salience});
    REQUIRE(out.lines.size() == 1);
    return out.lines.front();
  }
  void extend(CenterLines& set) const { extend_to_curve(set, bench.get<Delaunay>(), bench.get<OneStepCrust>()); }
  Workbench bench{builtins()};
};

/// The sides of a polygon in equal steps.
std::vector<Vec2> sampled(const std::vector<Vec2>& corners, double step) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 b = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::round(distance(a, b) / step)));
    for (int k = 0; k < n; ++k) out.push_back(a + (static_cast<double>(k) / n) * (b - a));
  }
  return out;
}

std::vector<Vec2> rectangle(double width, double height, double step) {
  return sampled({{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}, step);
}

/// A winding river with noise on both banks, and its mouth at both ends.
std::vector<Vec2> river(std::uint64_t seed, double step, double noise = 0.05) {
  Rng rng(seed);
  std::vector<Vec2> left;
  std::vector<Vec2> right;
  for (double x = 0.0; x <= 20.0; x += step) {
    const Vec2 middle{x, 1.5 * std::sin(0.6 * x)};
    const double slope = 0.9 * std::cos(0.6 * x);
    const Vec2 normal = (1.0 / std::hypot(1.0, slope)) * Vec2{-slope, 1.0};
    left.push_back(middle + (0.5 + noise * rng.uniform(-1.0, 1.0)) * normal);
    right.push_back(middle - (0.5 + noise * rng.uniform(-1.0, 1.0)) * normal);
  }
  std::vector<Vec2> out = left;
  out.insert(out.end(), right.rbegin(), right.rend());
  return sampled(out, 0.5 * step);
}

/// A star with two long tips side by side, between which the axis turns sharply.
std::vector<Vec2> star() {
  std::vector<Vec2> corners;
  for (int i = 0; i < 10; ++i) {
    const double radius = i % 2 == 1 ? 0.4 : (i < 4 ? 3.0 : 1.0);
    corners.push_back(radius * Vec2{std::cos(kPi * i / 5.0), std::sin(kPi * i / 5.0)});
  }
  return sampled(corners, 0.02);
}

double distance_to(const std::vector<Vec2>& line, Vec2 p) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 along = line[i] - line[i - 1];
    const double t = std::clamp(dot(p - line[i - 1], along) / dot(along, along), 0.0, 1.0);
    out = std::min(out, distance(p, line[i - 1] + t * along));
  }
  return out;
}

std::vector<Vec2> places(const CenterLine& line) {
  std::vector<Vec2> out;
  for (const CenterLine::Point& point : line.points) out.push_back(point.place);
  return out;
}

/// Points along a line, dense enough to stand for it.
std::vector<Vec2> dense(const std::vector<Vec2>& line, int parts) {
  std::vector<Vec2> out;
  for (std::size_t i = 1; i < line.size(); ++i)
    for (int k = 0; k < parts; ++k)
      out.push_back(line[i - 1] + (static_cast<double>(k) / parts) * (line[i] - line[i - 1]));
  out.push_back(line.back());
  return out;
}

double turning(const std::vector<Vec2>& line) {
  double out = 0.0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const Vec2 a = line[i - 1] - line[i - 2];
    const Vec2 b = line[i] - line[i - 1];
    out += std::abs(std::atan2(cross(a, b), dot(a, b)));
  }
  return out;
}

}  // namespace

TEST_CASE("samples that nearly lie on a line have no centre line") {
  // Rounding leaves them beside the line, and the ball through three of them is larger than anything near.
  std::vector<Vec2> samples;
  for (int i = 0; i < 5; ++i) samples.push_back({0.1 * i, 0.3 * i});
  CHECK(LineBench(samples).lines().lines.empty());
  samples.clear();
  for (int i = 0; i <= 20; ++i) samples.push_back({0.1 * i, i % 2 == 0 ? 0.0 : 1e-9});
  for (const CenterLine& line : LineBench(samples).lines().lines) CHECK(length_of(line) < 10.0);
}

TEST_CASE("the centre line of a stadium is its segment, with a constant width") {
  for (const double epsilon : {0.4, 0.1}) {
    const TestShape shape = stadium(3.0, 1.0, epsilon);
    const LineBench bench(shape.data);
    CenterLine line = bench.line();
    for (const bool is_smooth : {false, true}) {
      if (is_smooth) smooth(line, {.share = 0.25});
      CHECK(line.is_free == std::array{true, true});
      CHECK(length_of(line) == Approx(6.0).margin(0.5 * epsilon * epsilon));
      CHECK(distance(line.points.front().place, {-3.0, 0.0}) < 0.3 * epsilon * epsilon);
      CHECK(distance(line.points.back().place, {3.0, 0.0}) < 0.3 * epsilon * epsilon);
      for (const Vec2 p : places(line)) CHECK(std::abs(p.y) < 0.5 * epsilon * epsilon);
    }
    const Widths widths = widths_of(line);
    CHECK(widths.least == Approx(2.0).epsilon(0.5 * epsilon * epsilon));
    CHECK(widths.largest == Approx(2.0).epsilon(0.5 * epsilon * epsilon));
    const auto stations = stations_of(line, 0.5);
    CHECK((stations.size() == 12 || stations.size() == 13));
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Station& at = stations[i];
      CHECK(at.along == 0.5 * static_cast<double>(i));
      CHECK(at.place.x == Approx(-3.0 + at.along).margin(0.5 * epsilon * epsilon));
      if (std::abs(at.axis.x) > 2.9) continue;                // the last balls touch the round ends
      CHECK(at.left.y == Approx(1.0).margin(0.1 * epsilon));  // the line runs to the right
      CHECK(at.right.y == Approx(-1.0).margin(0.1 * epsilon));
      CHECK(std::min(at.direction, 360.0 - at.direction) < 60.0 * epsilon);
    }
  }
}

TEST_CASE("the centre line of an ellipse runs between the centres of curvature") {
  const LineBench bench(ellipse(2.0, 1.0, 800).data);
  const CenterLine line = bench.line();
  CHECK(distance(line.points.front().place, {-1.5, 0.0}) < 0.02);
  CHECK(distance(line.points.back().place, {1.5, 0.0}) < 0.02);
  for (const Vec2 p : places(line)) CHECK(std::abs(p.y) < 1e-3);
  for (const Station& at : stations_of(line, 0.1)) {
    if (std::abs(at.axis.x) > 1.4) continue;
    // The nearest point of the ellipse has x / a^2 times the eccentricity squared, so r^2 = b^2 (1 - x^2 / (a^2 - b^2)).
    const double radius = std::sqrt(1.0 - at.axis.x * at.axis.x / 3.0);
    CHECK(at.width == Approx(2.0 * radius).epsilon(1e-4));
  }
  CenterLines set = bench.lines();
  bench.extend(set);
  CHECK(distance(set.lines[0].points.front().place, {-2.0, 0.0}) < 0.02);
  CHECK(distance(set.lines[0].points.back().place, {2.0, 0.0}) < 0.02);
}

TEST_CASE("corners of a rectangle are pruned, and its line extends to the middles of its short sides") {
  const LineBench bench(rectangle(8.0, 2.0, 0.1));
  CenterLine line = bench.line();
  CHECK(length_of(line) == Approx(6.0).margin(0.02));
  CHECK(widths_of(line).least == Approx(2.0).epsilon(1e-3));
  CHECK(widths_of(line).largest == Approx(2.0).epsilon(1e-3));
  CenterLines set = bench.lines();
  bench.extend(set);
  CHECK(distance(set.lines[0].points.front().place, {0.0, 1.0}) < 0.02);
  CHECK(distance(set.lines[0].points.back().place, {8.0, 1.0}) < 0.02);
  CHECK(std::abs(set.lines[0].points.front().place.x) < 1e-12);
  // Without pruning it runs from corner to corner, and the other corners are lines of their own.
  const CenterLines all = bench.lines({.least_salience = 0.0, .most = 100});
  REQUIRE(all.lines.size() == 3);
  CHECK(length_of(all.lines[0]) == Approx(6.0 + 2.0 * std::sqrt(2.0)).margin(0.15));
  CHECK(length_of(all.lines[1]) == Approx(std::sqrt(2.0)).margin(0.1));
  CHECK(all.lines[1].is_free != std::array{true, true});
  CHECK(all.lines[2].rank == 2);
  // A square has no line.
  const CenterLines square = LineBench(rectangle(2.0, 2.0, 0.1)).lines();
  CHECK(square.lines.empty());
  CHECK(square.points == 1);
}

TEST_CASE("the width of a wedge grows linearly") {
  const double half = 10.0 * kPi / 180.0;
  const double length = 10.0;
  const double rise = length * std::tan(half);
  const LineBench bench(sampled({{0.0, 0.0}, {length, -rise}, {length, rise}}, 0.02));
  const CenterLine line = bench.line(0.6);
  // It ends at the centre of the inscribed circle.
  const double radius = rise * length / (rise + std::hypot(length, rise));
  CHECK(distance(line.points.back().place, {length - radius, 0.0}) < 0.01);
  std::size_t count = 0;
  for (const Station& at : stations_of(line, 0.25)) {
    if (at.axis.x < 0.5) continue;
    ++count;
    CHECK(at.width == Approx(2.0 * at.axis.x * std::sin(half)).epsilon(2e-3));
    CHECK(at.left.x == Approx(at.axis.x * std::cos(half) * std::cos(half)).margin(0.01));
  }
  CHECK(count > 20);
}

TEST_CASE("a ring has a closed line, two shapes a line each, and two points choose a line") {
  const LineBench ring(annulus(2.0, 3.0, 0.2).data);
  CenterLine line = ring.line();
  CHECK(line.is_closed);
  CHECK(length_of(line) == Approx(5.0 * kPi).epsilon(0.01));
  smooth(line, {.length = 0.1});
  CHECK(line.points.front().place == line.points.back().place);
  CHECK(length_of(line) == Approx(5.0 * kPi).epsilon(0.01));
  for (const Vec2 p : places(line)) CHECK(length(p) == Approx(2.5).margin(0.02));
  const auto stations = stations_of(line, length_of(line) / 10.0);
  CHECK((stations.size() == 10 || stations.size() == 11));
  for (const Station& at : stations) CHECK(at.width == Approx(1.0).epsilon(0.02));
  CHECK(ring.lines({.between = {{{0.0, 0.0}, {1.0, 0.0}}}}).unjoined == 1);

  const LineBench two(two_ellipses(2.0, 1.0, 1.0, 400).data);
  const CenterLines lines = two.lines();
  REQUIRE(lines.lines.size() == 2);
  CHECK(lines.lines[0].shape == 0);
  CHECK(lines.lines[1].shape == 1);

  const LineBench corners(rectangle(8.0, 2.0, 0.1));
  const CenterLines diagonal = corners.lines({.least_salience = 0.0, .between = {{{9.0, 3.0}, {-1.0, -1.0}}}});
  REQUIRE(diagonal.lines.size() == 1);
  CHECK(distance(diagonal.lines[0].points.front().place, {8.0, 2.0}) < 0.1);
  CHECK(distance(diagonal.lines[0].points.back().place, {0.0, 0.0}) < 0.1);
  CHECK(corners.lines({.between = {{{9.0, 3.0}, {9.0, 2.0}}}}).unjoined == 1);
  const CenterLines several =
      corners.lines({.least_salience = 0.0,
                     .between = {{{9.0, 3.0}, {-1.0, -1.0}}, {{9.0, 3.0}, {9.0, 2.0}}, {{9.0, -1.0}, {9.0, 3.0}}}});
  CHECK(several.unjoined == 1);
  REQUIRE(several.lines.size() == 2);
  CHECK(distance(several.lines[1].points.front().place, {8.0, 0.0}) < 0.1);
}

TEST_CASE("smoothing keeps circles and long waves, and removes short ones") {
  // The axis of a ring: beads are an eighth of the radius 2 apart.
  CenterLine ring;
  ring.is_closed = true;
  constexpr int kPieces = 2000;
  for (int i = 0; i < kPieces; ++i) {
    ring.axis.push_back(5.0 * Vec2{std::cos(2.0 * kPi * i / kPieces), std::sin(2.0 * kPi * i / kPieces)});
    ring.banks.push_back({Bank{{3.0, 0.0}, {}, true, Vec2{}}, Bank{{7.0, 0.0}, {}, true, Vec2{}}});
  }
  ring.axis.push_back(ring.axis.front());
  smooth(ring, kUsualSmoothing);
  for (const Vec2 p : places(ring)) CHECK(length(p) == Approx(5.0).epsilon(1e-5));

  // The share of its height that a low wave of so many beads keeps, in a straight strip of half width 1.
  const auto left_of = [](double beads) {
    constexpr double kHeight = 1e-3;
    CenterLine line;
    const auto place = [&](int i) { return Vec2{0.01 * i, kHeight * std::sin(2.0 * kPi * 0.08 * i / beads)}; };
    for (int i = 0; i < 4000; ++i) {
      line.axis.push_back(place(i));
      line.banks.push_back({Bank{{-1e3, 1.0}, {Vec2{1e3, 1.0}, Vec2{1e3, 1.0}}, true, {}},
                            Bank{{-1e3, -1.0}, {Vec2{1e3, -1.0}, Vec2{1e3, -1.0}}, true, {}}});
    }
    line.axis.push_back(place(4000));
    smooth(line, kUsualSmoothing);
    double highest = 0.0;
    for (const Vec2 p : places(line))
      if (p.x > 10.0 && p.x < 30.0) highest = std::max(highest, std::abs(p.y));
    return highest / kHeight;
  };
  CHECK(left_of(6.0) < 0.001);
  CHECK(left_of(13.0) == Approx(0.42).margin(0.02));
  CHECK(left_of(26.0) == Approx(0.98).margin(0.01));
  CHECK(left_of(60.0) == Approx(1.0).margin(0.002));
}

TEST_CASE("a smoothed line stays within its tolerance and deep inside the balls") {
  for (const std::vector<Vec2>& samples : {river(1, 0.2), river(2, 0.2), river(3, 0.2, 0.2), star()}) {
    const LineBench bench(samples);
    const CenterLine axis = bench.lines().lines.at(0);
    CHECK(length_of(axis) > 5.0);
    // Steps of at most a twentieth of the radius, so distances to the axis are known to a fortieth of it.
    std::vector<Vec2> axis_places;
    for (std::size_t i = 0; i + 1 < axis.axis.size(); ++i) {
      const Vec2 sample = axis.banks[i][0].sample;
      const double radius = std::min(distance(axis.axis[i], sample), distance(axis.axis[i + 1], sample));
      const double piece = distance(axis.axis[i], axis.axis[i + 1]);
      const std::vector<Vec2> places =
          dense({axis.axis[i], axis.axis[i + 1]}, static_cast<int>(std::ceil(20.0 * piece / radius)));
      axis_places.insert(axis_places.end(), places.begin(), places.end());
    }
    std::vector<double> radii;
    for (const Vec2 c : axis_places) {
      double radius = std::numeric_limits<double>::infinity();
      for (const Vec2 sample : samples) radius = std::min(radius, distance(c, sample));
      radii.push_back(radius);
    }
    for (const SmoothingTolerance& tolerance :
         {SmoothingTolerance{.length = 0.05}, SmoothingTolerance{.share = 0.25}, SmoothingTolerance{.share = 5.0}}) {
      CenterLine line = axis;
      smooth(line, tolerance);
      CHECK(line.points.front().place == axis.points.front().place);
      CHECK(line.points.back().place == axis.points.back().place);
      CHECK(turning(places(line)) < 0.7 * turning(places(axis)));
      for (const Vec2 p : dense(places(line), 3)) {
        double deepest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < axis_places.size(); ++i)
          deepest = std::min(deepest, distance(p, axis_places[i]) / radii[i]);
        CHECK(deepest <= 0.6875 + 0.025);
        if (tolerance.length > 0.0) CHECK(distance_to(axis.axis, p) <= tolerance.length * (1.0 + 1e-9));
      }
      if (tolerance.length > 0.0)
        for (const Vec2 p : axis_places) CHECK(distance_to(places(line), p) <= tolerance.length * (1.0 + 1e-9));
    }
    CenterLine still = axis;
    smooth(still, {});
    CHECK(places(still) == places(axis));
  }
}

TEST_CASE("smoothed lines meet where the axis does, at points of both") {
  // A tree of strips, and a ring with a tail.
  const LineBench tree(sampled({{0.0, 0.0},
                                {4.0, 0.0},
                                {4.6, -3.0},
                                {5.6, -3.0},
                                {5.0, 0.0},
                                {12.0, 0.4},
                                {12.0, 1.4},
                                {9.0, 1.2},
                                {9.2, 5.0},
                                {8.2, 5.0},
                                {8.0, 1.2},
                                {0.0, 1.0}},
                               0.05));
  std::vector<Vec2> tailed = sampled({{2.0, -0.4}, {9.0, -0.4}, {9.0, 0.4}, {2.0, 0.4}}, 0.05);
  std::erase_if(tailed, [](Vec2 p) { return length(p) < 3.0; });
  for (double angle = 0.14; angle < 6.15; angle += 0.0167)
    tailed.push_back(3.0 * Vec2{std::cos(angle), std::sin(angle)});
  for (double angle = 0.0; angle < 6.28; angle += 0.025)
    tailed.push_back(2.0 * Vec2{std::cos(angle), std::sin(angle)});
  const LineBench racket(tailed);
  for (const LineBench* bench : {&tree, &racket}) {
    CenterLines set = bench->lines({.most = 9});
    REQUIRE(set.lines.size() == (bench == &tree ? 3U : 1U));
    smooth(set, {.share = 0.5});
    std::size_t met = 0;
    for (const CenterLine& line : set.lines) {
      for (const bool is_first : {true, false}) {
        if (line.is_free[is_first ? 0 : 1]) continue;
        const Vec2 end = is_first ? line.points.front().place : line.points.back().place;
        std::size_t count = 0;
        for (const CenterLine& other : set.lines)
          count += static_cast<std::size_t>(std::ranges::count(places(other), end));
        CHECK(count == 2);
        ++met;
      }
    }
    CHECK(met == (bench == &tree ? 2U : 1U));
  }
}

TEST_CASE("an extension that meets no curve soon is left out") {
  const LineBench bench(rectangle(8.0, 2.0, 0.1));
  CenterLines set = bench.lines();
  extend_to_curve(set, bench.bench.get<Delaunay>(), bench.bench.get<OneStepCrust>(), 0.9);
  CHECK(length_of(set.lines[0]) == length_of(bench.line()));
}

TEST_CASE("lines follow the shape when it is listed otherwise, scaled, turned, or sampled more densely") {
  const auto line_of = [](const std::vector<Vec2>& samples, double tolerance) {
    CenterLines set = LineBench(samples).lines();
    REQUIRE(set.lines.size() == 1);
    smooth(set.lines[0], {.length = tolerance});
    return places(set.lines[0]);
  };
  const std::vector<Vec2> samples = river(4, 0.2);
  const std::vector<Vec2> line = line_of(samples, 0.1);

  std::vector<Vec2> reversed(samples.rbegin(), samples.rend());
  CHECK(line_of(reversed, 0.1) == line);

  std::vector<Vec2> larger;
  for (const Vec2 p : samples) larger.push_back(4.0 * p);
  const std::vector<Vec2> scaled = line_of(larger, 0.4);
  REQUIRE(scaled.size() == line.size());
  for (std::size_t i = 0; i < line.size(); ++i) CHECK(distance(scaled[i], 4.0 * line[i]) < 1e-9);

  std::vector<Vec2> turned;
  for (const Vec2 p : samples) turned.push_back(Vec2{0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y} + Vec2{5.0, -3.0});
  for (const Vec2 p : line_of(turned, 0.1)) {
    const Vec2 q = p - Vec2{5.0, -3.0};
    CHECK(distance_to(line, Vec2{0.6 * q.x + 0.8 * q.y, -0.8 * q.x + 0.6 * q.y}) < 1e-6);
  }

  // The same polygon with twice and four times as many samples: the difference falls.
  const auto polygon = [](double step) {
    return sampled({{0.0, 0.0}, {9.0, 0.0}, {9.0, 4.0}, {7.5, 4.0}, {7.5, 1.6}, {0.0, 1.6}}, step);
  };
  const std::vector<Vec2> fine = line_of(polygon(0.01), 0.05);
  double before = std::numeric_limits<double>::infinity();
  for (const double step : {0.2, 0.05}) {
    double farthest = 0.0;
    for (const Vec2 p : line_of(polygon(step), 0.05)) farthest = std::max(farthest, distance_to(fine, p));
    CHECK(farthest < 0.2 * step);
    CHECK(farthest < before);
    before = farthest;
  }
}

TEST_CASE("samples without a shape have no line") {
  for (const std::vector<Vec2>& samples :
       {std::vector<Vec2>{}, {{1.0, 2.0}}, {{1.0, 2.0}, {3.0, 4.0}}, {{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}}}) {
    const CenterLines none = LineBench(samples).lines();
    CHECK(none.lines.empty());
    CHECK(none.points == 0);
  }
}

TEST_CASE("the structure has the lines of all shapes, and transects in equal steps across them") {
  std::vector<Vec2> samples = rectangle(8.0, 2.0, 0.05);
  for (const Vec2 p : rectangle(4.0, 1.0, 0.05)) samples.push_back(p + Vec2{0.0, 5.0});
  TestBench bench;
  bench.show({"center-lines", "transects"});
  ComputationSettings settings;
  settings[Parameter::transects] = 20.0;
  bench.choose(settings);
  bench.replace(samples);
  const auto& lines = bench.get<AxisCenterLines>();
  const LineBench known(samples);
  CenterLines set = known.lines();
  smooth(set, kUsualSmoothing);
  REQUIRE(set.lines.size() == 2);
  REQUIRE(lines.lines().size() == 2);
  double length = 0.0;
  std::size_t row = 0;
  for (const AxisCenterLines::Line& line : lines.lines()) {
    CHECK(line.length == length_of(set.lines[row++]));
    length += line.length;
  }
  std::vector<Vec2> drawn;
  for (const AxisCenterLines::Piece& piece : lines.pieces())
    if (piece.line == AxisCenterLines::LineSlot(0)) drawn.push_back(piece.to);
  drawn.insert(drawn.begin(), set.lines[0].points[0].place);
  CHECK(drawn == places(set.lines[0]));

  REQUIRE(lines.transects().size() >= 20);
  REQUIRE(lines.transects().size() <= 22);
  double station = 0.0;
  for (const AxisCenterLines::Transect& at : lines.transects()) {
    const bool is_first = at.line == AxisCenterLines::LineSlot(0);
    if (at.station == 0.0) station = 0.0;
    CHECK(std::abs(at.station - station) < 1e-9);
    station += length / 20.0;
    CHECK(std::abs(at.width - (is_first ? 2.0 : 1.0)) < 1e-6);
    CHECK(std::abs(distance(at.left, at.axis) + distance(at.axis, at.right) - at.width) < 1e-12);
    CHECK(distance(at.axis, at.place) < 0.5 * at.width);
  }
  const LayerIndex transects = builtins().find_layer("transects");
  CHECK(bench.mirror().instances(transects, PrimitiveKind::segment).size() ==
        2 * lines.transects().size() * stride_of(PrimitiveKind::segment));

  // Without pruning the lines run into corners. The first line of a rectangle joins two of them.
  settings[Parameter::center_line_pruning] = 0.0;
  settings[Parameter::center_line_branches] = 10.0;
  bench.choose(settings);
  CHECK(lines.lines().size() == 6);
}

TEST_CASE("the lines between ends that the user chose follow the samples there, and replace the others") {
  // A cross with arms of length 9 to both sides, and of 6 upwards and downwards.
  const std::vector<Vec2> samples = sampled(
      {{1, -1}, {9, -1}, {9, 1}, {1, 1}, {1, 6}, {-1, 6}, {-1, 1}, {-9, 1}, {-9, -1}, {-1, -1}, {-1, -6}, {1, -6}},
      0.125);
  const auto near = [&](Vec2 p) {
    return static_cast<std::uint32_t>(std::ranges::min_element(samples, {}, [&](Vec2 q) { return distance(p, q); }) -
                                      samples.begin());
  };
  TestBench bench;
  bench.show({"center-lines", "transects"});
  const auto ends_of_line = [&](std::size_t line) {
    std::vector<Vec2> out;
    for (const AxisCenterLines::Piece& piece : bench.get<AxisCenterLines>().pieces()) {
      if (piece.line != AxisCenterLines::LineSlot(line)) continue;
      if (out.empty()) out.push_back(piece.from);
      out.resize(1);
      out.push_back(piece.to);
    }
    REQUIRE(out.size() == 2);
    return out;
  };
  SampleData data{.positions = samples};
  bench.load(data);
  CHECK(distance(ends_of_line(0)[0], {-8, 0}) < 0.3);
  CHECK(distance(ends_of_line(0)[1], {8, 0}) < 0.3);

  data.annotations = {
      {.kind = AnnotationKind::text, .text = "cross", .anchors = {{}}},
      {.kind = AnnotationKind::center_line,
       .anchors = {{.at = {0, 6}, .samples = {near({0, 6})}}, {.at = {9, 0}, .samples = {near({9, 0})}}}}};
  bench.load(data);
  CHECK(bench.count("center-lines", "lines") == 1);
  CHECK(bench.count("center-lines", "ends_without_line") == 0);
  CHECK(distance(ends_of_line(0)[0], {0, 5}) < 0.3);
  CHECK(distance(ends_of_line(0)[1], {8, 0}) < 0.3);

  // So far to the left that a fixed end would be nearest to another tip.
  std::vector<std::pair<SampleId, Vec2>> moved;
  const std::vector<SampleId> ids = bench.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) moved.emplace_back(ids[i], samples[i] - Vec2{20, 0});
  bench.move(moved);
  CHECK(distance(ends_of_line(0)[0], {-20, 5}) < 0.3);
  CHECK(distance(ends_of_line(0)[1], {-12, 0}) < 0.3);
  bench.undo();
  CHECK(distance(ends_of_line(0)[0], {0, 5}) < 0.3);
  // Without its sample an end stays where it was set; the tip there is still the nearest.
  bench.remove({ids[near({0, 6})]});
  CHECK(distance(ends_of_line(0)[0], {0, 5}) < 0.3);

  // An end on the centre of a circle, and two lines; a pair at one tip has none.
  const auto top = [&](double x, double y) { return near({x, y}); };
  data.annotations = {
      {.kind = AnnotationKind::center_line,
       .anchors = {{.at = {0, -6}}, {.at = {5, 5}, .samples = {top(-9, 1), top(-9, -1), top(-8, 1)}}}},
      {.kind = AnnotationKind::center_line, .anchors = {{.at = {0, 6}}, {.at = {1, 6}}}},
      {.kind = AnnotationKind::center_line, .anchors = {{.at = {9, 0}}, {.at = {0, 6}}}}};
  bench.load(data);
  CHECK(bench.count("center-lines", "lines") == 2);
  CHECK(bench.count("center-lines", "ends_without_line") == 1);
  CHECK(distance(ends_of_line(0)[0], {0, -5}) < 0.3);
  CHECK(distance(ends_of_line(0)[1], {-8, 0}) < 0.3);
  CHECK(distance(ends_of_line(1)[0], {8, 0}) < 0.3);
  CHECK(center_line_ends(data.annotations).size() == 3);
}
