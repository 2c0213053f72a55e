// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shapes/shapes_benchmark.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"

namespace mes::test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Vec2 curve_point(double t) {
  const double r = 200.0 * (1.0 + 0.3 * std::cos(5.0 * t) + 0.05 * std::cos(37.0 * t));
  return {r * std::cos(t), r * std::sin(t)};
}

double jittered_parameter(std::size_t i, std::size_t n, Rng& random) {
  return kTurn * (static_cast<double>(i) + random.uniform(-0.25, 0.25)) / static_cast<double>(n);
}

}  // namespace

std::vector<Vec2> benchmark_curve(std::size_t n, std::uint64_t seed) {
  Rng random(seed);
  std::vector<Vec2> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(curve_point(jittered_parameter(i, n, random)));
  return points;
}

std::vector<Vec2> rough_curve(std::size_t n, std::uint64_t seed) {
  Rng random(seed);
  std::vector<Vec2> points;
  points.reserve(n);
  const double step = kTurn / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = jittered_parameter(i, n, random);
    const Vec2 p = curve_point(t);
    const Vec2 chord = curve_point(t + 0.5 * step) - curve_point(t - 0.5 * step);
    const bool is_corner = random.below(100) == 0;
    const double sign = random.below(2) == 0 ? -1.0 : 1.0;
    const double away = sign * (is_corner ? random.uniform(1.0, 3.0) : random.uniform(0.0, 0.05));
    points.push_back(p + away * perpendicular(chord));
  }
  return points;
}

std::vector<Vec2> noisy_curve(std::size_t n, std::uint64_t seed) {
  Rng random(seed);
  std::vector<Vec2> points;
  points.reserve(n);
  const double step = kTurn / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = jittered_parameter(i, n, random);
    const double reach = distance(curve_point(t - 0.5 * step), curve_point(t + 0.5 * step));
    const Vec2 p = curve_point(t);
    const double dx = random.uniform(-reach, reach);
    points.push_back(p + Vec2{dx, random.uniform(-reach, reach)});
  }
  return points;
}
std::vector<Vec2> noisy_trefoil(std::size_t n, double noise, std::uint64_t seed) {
  Rng random(seed);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = kTurn * static_cast<double>(i) / static_cast<double>(n);
    const double r = 100.0 * (1.0 + 0.3 * std::cos(3.0 * t)) + noise * (random.uniform() - 0.5);
    points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return points;
}

std::vector<Vec2> uniform_square(std::size_t n, std::uint64_t seed) {
  Rng random(seed);
  std::vector<Vec2> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform(0.0, 400.0);
    points.push_back({x, random.uniform(0.0, 400.0)});
  }
  return points;
}

std::vector<Vec2> duplicate_heavy(std::size_t n, std::uint64_t seed) {
  Rng random(seed);
  const double wanted = 0.5 * std::sqrt(static_cast<double>(n));
  const auto side = std::max<std::uint64_t>(2, static_cast<std::uint64_t>(std::ceil(wanted)));
  std::vector<Vec2> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto x = static_cast<double>(random.below(side));
    points.push_back({x, static_cast<double>(random.below(side))});
  }
  return points;
}

std::vector<Vec2> drawn_by_hand(std::size_t n, std::uint64_t seed, double grid) {
  Rng random(seed);
  double amplitude[6], phase[6];
  for (int k = 0; k < 6; ++k) {
    amplitude[k] = random.uniform(-40.0, 40.0) / (1.0 + k);
    phase[k] = random.uniform(0.0, kTurn);
  }
  std::vector<double> times{0.0};
  double speed = 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    speed = std::clamp(speed * random.uniform(0.75, 1.34), 0.2, 5.0);
    times.push_back(times.back() + speed);
  }
  std::vector<Vec2> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = kTurn * times[i] / times.back();
    double r = 200.0;
    for (int k = 0; k < 6; ++k) r += amplitude[k] * std::cos((2 + k) * t + phase[k]);
    points.push_back({grid * std::round(r * std::cos(t) / grid), grid * std::round(r * std::sin(t) / grid)});
  }
  return points;
}

}  // namespace mes::test
