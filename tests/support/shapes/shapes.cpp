// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/assert.h"
#include "core/base/rng.h"

namespace mes::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// A closed curve over u in [0, 1), and a lower bound of its local feature size.
struct ClosedCurve {
  std::function<Vec2(double)> at;
  std::function<double(double)> lfs;
};

/// Position of the i-th of n samples, in units of the spacing.
double station(std::size_t i, const Sampling& sampling, Rng& random) {
  const double wobble = sampling.jitter == 0.0 ? 0.0 : random.uniform(-sampling.jitter, sampling.jitter);
  return static_cast<double>(i) + sampling.offset + wobble;
}

void add_contour(SampleData& data, const std::vector<Vec2>& points) {
  SampleData::Contour contour;
  for (const Vec2 p : points) {
    contour.points.push_back(static_cast<std::uint32_t>(data.positions.size()));
    data.positions.push_back(p);
  }
  data.contours.push_back(std::move(contour));
}

/// Samples at equal steps of u.
std::vector<Vec2> sample_evenly(const ClosedCurve& curve, std::size_t n, const Sampling& sampling) {
  Rng random(sampling.seed);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = station(i, sampling, random) / static_cast<double>(n);
    points.push_back(curve.at(u - std::floor(u)));
  }
  return points;
}

/// Samples at equal steps of the measure ds / lfs, enough for an epsilon-sample.
std::vector<Vec2> sample_graded(const ClosedCurve& curve, double epsilon, const Sampling& sampling) {
  constexpr std::size_t kSteps = 16384;
  std::vector<double> measure(kSteps + 1, 0.0);
  Vec2 before = curve.at(0.0);
  for (std::size_t i = 1; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps;
    const Vec2 here = curve.at(i == kSteps ? 0.0 : u);
    measure[i] = measure[i - 1] + distance(before, here) / curve.lfs(u - 0.5 / kSteps);
    before = here;
  }
  const double total = measure.back();
  // Jitter can pull neighbours apart by twice its size; more samples compensate for this.
  const double step = 2.0 * std::log1p(epsilon) / (1.0 + 2.0 * sampling.jitter);
  const std::size_t n = std::max<std::size_t>(8, static_cast<std::size_t>(std::ceil(total / step)));
  Rng random(sampling.seed);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < n; ++i) {
    double w = station(i, sampling, random) / static_cast<double>(n);
    w = (w - std::floor(w)) * total;
    const auto above = std::upper_bound(measure.begin() + 1, measure.end() - 1, w);
    const double low = *(above - 1);
    const double fraction = (w - low) / (*above - low);
    points.push_back(curve.at((static_cast<double>(above - 1 - measure.begin()) + fraction) / kSteps));
  }
  return points;
}

ClosedCurve circle_curve(Vec2 center, double radius, double lfs) {
  return {[=](double u) {
            return center + radius * Vec2{std::cos(2.0 * kPi * u), std::sin(2.0 * kPi * u)};
          },
          [=](double) { return lfs; }};
}

ClosedCurve ellipse_curve(Vec2 center, double a, double b) {
  const double end = (a * a - b * b) / a;
  return {[=](double u) {
            return center + Vec2{a * std::cos(2.0 * kPi * u), b * std::sin(2.0 * kPi * u)};
          },
          [=](double u) {
            const double x = std::abs(a * std::cos(2.0 * kPi * u));
            return std::hypot(std::max(0.0, x - end), b * std::sin(2.0 * kPi * u));
          }};
}

/// Boundary of the points within `q` of the box [-w, w] x [-h, h], by arc length, starting at (w + q, 0).
ClosedCurve rounded_box_curve(double w, double h, double q) {
  const double arc = kPi * q / 2.0;
  const double total = 4.0 * (w + h + arc);
  auto at = [=](double u) -> Vec2 {
    const double s = u * total;
    const double quarter = total / 4.0;
    const double turn = std::floor(s / quarter);
    // The quarters alternate in proportions, but up to mirroring they are one path: up h, around the arc, along w.
    const bool is_mirrored = static_cast<int>(turn) % 2 != 0;
    double t = s - turn * quarter;
    if (is_mirrored) t = quarter - t;
    Vec2 p;
    if (t <= h) {
      p = {w + q, t};
    } else if (t <= h + arc) {
      const double angle = (t - h) / q;
      p = {w + q * std::cos(angle), h + q * std::sin(angle)};
    } else {
      p = {quarter - t, h + q};
    }
    const int quadrant = static_cast<int>(turn) % 4;
    if (quadrant == 1 || quadrant == 2) p.x = -p.x;
    if (quadrant >= 2) p.y = -p.y;
    return p;
  };
  return {at, [=](double) { return q; }};
}

/// Reverses the direction for holes and islands: the interior must be on the left.
std::vector<Vec2> clockwise(std::vector<Vec2> points) {
  std::reverse(points.begin() + 1, points.end());
  return points;
}

/// Circumference of an ellipse by the arithmetic-geometric mean; exact to rounding (Gauss).
double ellipse_perimeter(double a, double b) {
  double sum = a * a;
  double weight = 0.5;
  double difference = std::sqrt(a * a - b * b);
  sum -= weight * difference * difference;
  while (std::abs(difference) > 1e-9 * a) {
    const double mean = 0.5 * (a + b);
    difference = 0.5 * (a - b);
    b = std::sqrt(a * b);
    a = mean;
    weight *= 2.0;
    sum -= weight * difference * difference;
  }
  return 2.0 * kPi * sum / a;
}

std::string number(double x) {
  std::string text = std::to_string(x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

Facts ellipse_facts(double a, double b, double relative_error) {
  Facts facts;
  facts.leaves = 2;
  facts.branch_points = 0;
  facts.axis_length = 2.0 * (a * a - b * b) / a;
  facts.axis_length_tolerance = relative_error * b;
  facts.min_radius = b * b / a;
  facts.max_radius = b;
  facts.radius_tolerance = relative_error * b;
  facts.merge_distance = 1e-9 * b;
  return facts;
}

Sampling with_seed(Sampling sampling, std::uint64_t change) {
  sampling.seed += change;
  return sampling;
}

void check(bool holds) {
  MES_ASSERT(holds);
}

}  // namespace

TestShape ellipse(double a, double b, std::size_t n, const Sampling& sampling) {
  check(a > b && b > 0.0 && n >= 5);
  TestShape shape;
  shape.name = "ellipse " + number(a) + ":" + number(b) + " n=" + std::to_string(n);
  add_contour(shape.data, sample_evenly(ellipse_curve({}, a, b), n, sampling));
  const double steps = static_cast<double>(n) / (1.0 + 2.0 * sampling.jitter);
  shape.expected = ellipse_facts(a, b, 25.0 * (a / b) * (a / b) / (steps * steps));
  return shape;
}

TestShape ellipse_graded(double a, double b, double epsilon, const Sampling& sampling) {
  check(a > b && b > 0.0 && epsilon > 0.0);
  TestShape shape;
  shape.name = "ellipse " + number(a) + ":" + number(b) + " epsilon=" + number(epsilon);
  shape.epsilon = epsilon;
  add_contour(shape.data, sample_graded(ellipse_curve({}, a, b), epsilon, sampling));
  shape.expected = ellipse_facts(a, b, epsilon * epsilon * a / b);
  return shape;
}

TestShape stadium(double half_length, double radius, double epsilon, const Sampling& sampling) {
  check(half_length > 0.0 && radius > 0.0 && epsilon > 0.0);
  TestShape shape;
  shape.name = "stadium " + number(half_length) + "," + number(radius) + " epsilon=" + number(epsilon);
  shape.epsilon = epsilon;
  add_contour(shape.data, sample_graded(rounded_box_curve(half_length, 0.0, radius), epsilon, sampling));
  Facts& facts = shape.expected;
  facts.leaves = 2;
  facts.branch_points = 0;
  facts.axis_length = 2.0 * half_length;
  facts.axis_length_tolerance = epsilon * epsilon * (radius + half_length);
  facts.min_radius = radius;
  facts.max_radius = radius;
  facts.radius_tolerance = epsilon * epsilon * radius;
  facts.merge_distance = 1e-9 * radius;
  return shape;
}

TestShape annulus_aligned(double inner_radius, double outer_radius, std::size_t n) {
  check(0.0 < inner_radius && inner_radius < outer_radius && n >= 5);
  TestShape shape;
  shape.name = "aligned annulus n=" + std::to_string(n);
  add_contour(shape.data, sample_evenly(circle_curve({}, outer_radius, 1.0), n, {}));
  add_contour(shape.data, clockwise(sample_evenly(circle_curve({}, inner_radius, 1.0), n, {})));
  const double count = static_cast<double>(n);
  const double sum = inner_radius + outer_radius;
  Facts& facts = shape.expected;
  facts.cycles = 1;
  facts.leaves = 0;
  facts.branch_points = 0;
  facts.axis_length = count * sum * std::tan(kPi / count);
  facts.axis_length_tolerance = 1e-9 * sum;
  const double node = sum / (2.0 * std::cos(kPi / count));
  const double sample = 2.0 * kPi / count / 2.0;  // half a step: the nodes lie between the samples
  const double radius = std::hypot(node - outer_radius * std::cos(sample), outer_radius * std::sin(sample));
  facts.min_radius = radius;
  facts.max_radius = radius;
  facts.radius_tolerance = 1e-9 * sum;
  facts.merge_distance = 1e-9 * sum;
  return shape;
}

TestShape annulus(double inner_radius, double outer_radius, double epsilon, const Sampling& sampling) {
  check(0.0 < inner_radius && inner_radius < outer_radius && epsilon > 0.0);
  TestShape shape;
  shape.name = "annulus " + number(inner_radius) + "," + number(outer_radius) + " epsilon=" + number(epsilon);
  shape.epsilon = epsilon;
  const double radius = 0.5 * (outer_radius - inner_radius);
  const double sum = inner_radius + outer_radius;
  add_contour(shape.data, sample_graded(circle_curve({}, outer_radius, radius), epsilon, sampling));
  const ClosedCurve hole = circle_curve({}, inner_radius, std::min(inner_radius, radius));
  add_contour(shape.data, clockwise(sample_graded(hole, epsilon, with_seed(sampling, 1))));
  Facts& facts = shape.expected;
  facts.cycles = 1;
  facts.leaves = 0;
  facts.branch_points = 0;
  facts.axis_length = kPi * sum;
  facts.axis_length_tolerance = epsilon * epsilon * sum;
  facts.min_radius = radius;
  facts.max_radius = radius;
  facts.radius_tolerance = epsilon * epsilon * radius;
  facts.merge_distance = 1e-9 * sum;
  return shape;
}

TestShape eccentric_hole(double hole_radius, double disk_radius, double distance, double epsilon,
                         const Sampling& sampling) {
  check(0.0 < hole_radius && 0.0 < distance && distance < disk_radius - hole_radius && epsilon > 0.0);
  TestShape shape;
  shape.name = "disk " + number(disk_radius) + " with hole " + number(hole_radius) + " at " + number(distance) +
               " epsilon=" + number(epsilon);
  shape.epsilon = epsilon;
  const double least = 0.5 * (disk_radius - hole_radius - distance);
  add_contour(shape.data, sample_graded(circle_curve({}, disk_radius, least), epsilon, sampling));
  const ClosedCurve hole = circle_curve({distance, 0.0}, hole_radius, std::min(hole_radius, least));
  add_contour(shape.data, clockwise(sample_graded(hole, epsilon, with_seed(sampling, 1))));
  const double sum = hole_radius + disk_radius;
  Facts& facts = shape.expected;
  facts.cycles = 1;
  facts.leaves = 0;
  facts.branch_points = 0;
  facts.axis_length = ellipse_perimeter(0.5 * sum, 0.5 * std::sqrt(sum * sum - distance * distance));
  facts.axis_length_tolerance = epsilon * epsilon * sum;
  facts.min_radius = least;
  facts.max_radius = 0.5 * (disk_radius - hole_radius + distance);
  facts.radius_tolerance = epsilon * epsilon * disk_radius;
  facts.merge_distance = 1e-9 * sum;
  return shape;
}

TestShape rounded_rectangle(double half_width, double half_height, double corner_radius, double epsilon,
                            const Sampling& sampling) {
  check(half_width > half_height && half_height > corner_radius && corner_radius > 0.0 && epsilon > 0.0);
  TestShape shape;
  shape.name = "rounded rectangle " + number(half_width) + "," + number(half_height) + "," + number(corner_radius) +
               " epsilon=" + number(epsilon);
  shape.epsilon = epsilon;
  const ClosedCurve curve = rounded_box_curve(half_width - corner_radius, half_height - corner_radius, corner_radius);
  add_contour(shape.data, sample_graded(curve, epsilon, sampling));
  Facts& facts = shape.expected;
  facts.leaves = 4;
  facts.branch_points = 2;
  facts.axis_length = 2.0 * (half_width - half_height) + 4.0 * std::numbers::sqrt2 * (half_height - corner_radius);
  facts.axis_length_tolerance = epsilon * epsilon * half_width;
  facts.min_radius = corner_radius;
  facts.max_radius = half_height;
  facts.radius_tolerance = epsilon * epsilon * corner_radius;
  facts.merge_distance = 1e-9 * half_width;
  return shape;
}

TestShape two_ellipses(double a, double b, double gap, std::size_t n, const Sampling& sampling) {
  TestShape shape = ellipse(a, b, n, sampling);
  check(gap > 0.0);
  shape.name = "two of " + shape.name;
  const ClosedCurve second = ellipse_curve({2.0 * a + gap, 0.0}, a, b);
  add_contour(shape.data, sample_evenly(second, n, with_seed(sampling, 1)));
  Facts& facts = shape.expected;
  facts.components = 2;
  facts.leaves = 4;
  facts.axis_length = 2.0 * *facts.axis_length;
  facts.axis_length_tolerance *= 2.0;
  return shape;
}

TestShape disk_with_holes(std::size_t k, double disk_radius, double hole_radius, double hole_distance, double epsilon,
                          const Sampling& sampling) {
  const double half_angle = kPi / static_cast<double>(k);
  const double to_rim = 0.5 * (disk_radius - hole_distance - hole_radius);
  const double to_neighbour = hole_distance * std::sin(half_angle) - hole_radius;
  check(k >= 2 && to_rim > 0.0 && to_neighbour > 0.0 && epsilon > 0.0);
  TestShape shape;
  shape.name = "disk with " + std::to_string(k) + " holes epsilon=" + number(epsilon);
  shape.epsilon = epsilon;
  const double least = std::min(to_rim, to_neighbour);
  add_contour(shape.data, sample_graded(circle_curve({}, disk_radius, least), epsilon, sampling));
  for (std::size_t i = 0; i < k; ++i) {
    const double angle = 2.0 * half_angle * static_cast<double>(i);
    const Vec2 center = hole_distance * Vec2{std::cos(angle), std::sin(angle)};
    const ClosedCurve hole = circle_curve(center, hole_radius, std::min(hole_radius, least));
    add_contour(shape.data, clockwise(sample_graded(hole, epsilon, with_seed(sampling, i + 1))));
  }
  // A ball at distance s on the bisector of two neighbours touches all three: |x - hole| = h + R - s.
  const double sum = disk_radius + hole_radius;
  const double s = (sum * sum - hole_distance * hole_distance) / (2.0 * (sum - hole_distance * std::cos(half_angle)));
  Facts& facts = shape.expected;
  facts.cycles = k;
  facts.leaves = 0;
  facts.min_radius = least;
  facts.max_radius = std::max(disk_radius - s, hole_distance - hole_radius);
  facts.radius_tolerance = epsilon * epsilon * disk_radius;
  facts.merge_distance = 1e-9 * disk_radius;
  return shape;
}

TestShape island_in_hole(double a, double b, double inner_radius, double outer_radius, double epsilon,
                         const Sampling& sampling) {
  check(a > b && b > 0.0 && a < inner_radius && inner_radius < outer_radius && epsilon > 0.0);
  TestShape shape;
  shape.name = "island in a hole epsilon=" + number(epsilon);
  shape.epsilon = epsilon;
  const double ring = 0.5 * (outer_radius - inner_radius);
  // The water between hole and island has an axis too; its smallest ball bounds the feature size of both.
  const double water = 0.5 * (inner_radius - a);
  add_contour(shape.data, sample_graded(circle_curve({}, outer_radius, ring), epsilon, sampling));
  const ClosedCurve hole = circle_curve({}, inner_radius, std::min(ring, water));
  add_contour(shape.data, clockwise(sample_graded(hole, epsilon, with_seed(sampling, 1))));
  ClosedCurve island = ellipse_curve({}, a, b);
  island.lfs = [lfs = island.lfs, water](double u) { return std::min(lfs(u), water); };
  add_contour(shape.data, sample_graded(island, epsilon, with_seed(sampling, 2)));
  Facts& facts = shape.expected;
  facts.components = 2;
  facts.cycles = 1;
  facts.leaves = 2;
  facts.branch_points = 0;
  facts.axis_length = kPi * (inner_radius + outer_radius) + 2.0 * (a * a - b * b) / a;
  facts.axis_length_tolerance = epsilon * epsilon * (inner_radius + outer_radius + a * a / b);
  facts.min_radius = std::min(ring, b * b / a);
  facts.max_radius = std::max(ring, b);
  facts.radius_tolerance = epsilon * epsilon * std::max(ring, a);
  facts.merge_distance = 1e-9 * outer_radius;
  return shape;
}

std::vector<TestShape> oracle_shapes(double epsilon, const Sampling& sampling) {
  std::vector<TestShape> shapes;
  const auto samples = static_cast<std::size_t>(std::ceil(25.0 / epsilon));
  shapes.push_back(ellipse(2.0, 1.0, samples, sampling));
  shapes.push_back(ellipse_graded(2.0, 1.0, epsilon, sampling));
  shapes.push_back(ellipse_graded(5.0, 1.0, epsilon, sampling));
  shapes.push_back(stadium(2.0, 1.0, epsilon, sampling));
  shapes.push_back(annulus_aligned(1.0, 2.0, samples));
  shapes.push_back(annulus(1.0, 2.0, epsilon, sampling));
  shapes.push_back(annulus(0.3, 2.0, epsilon, sampling));
  shapes.push_back(eccentric_hole(1.0, 3.0, 1.0, epsilon, sampling));
  shapes.push_back(rounded_rectangle(3.0, 2.0, 0.5, epsilon, sampling));
  shapes.push_back(two_ellipses(2.0, 1.0, 0.5, samples, sampling));
  shapes.push_back(disk_with_holes(2, 3.0, 0.5, 1.5, epsilon, sampling));
  shapes.push_back(disk_with_holes(3, 3.0, 0.5, 1.6, epsilon, sampling));
  shapes.push_back(disk_with_holes(5, 3.0, 0.5, 1.7, epsilon, sampling));
  shapes.push_back(island_in_hole(1.0, 0.6, 2.0, 3.0, epsilon, sampling));
  return shapes;
}

}  // namespace mes::test
