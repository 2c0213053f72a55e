// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature that noise has disturbed keeps the extremes that move the curve, and rises or falls between them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/raster/internal/fitting/curvature.h"

using namespace mes;

namespace {

std::size_t turns_of(const std::vector<double>& values, bool is_closed) {
  std::size_t out = 0;
  double direction = 0.0, first = 0.0;
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < (is_closed ? count : count - 1); ++i) {
    const double step = values[(i + 1) % count] - values[i];
    if (step == 0.0) continue;
    if (direction * step < 0.0) ++out;
    if (first == 0.0) first = step;
    direction = step;
  }
  return out + (is_closed && first * direction < 0.0 ? 1 : 0);
}

/// A wave with so many maxima, and noise.
std::vector<double> noisy(std::size_t count, int maxima, double noise, Rng& rng) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(
        0.05 +
        0.02 * std::cos(2.0 * std::numbers::pi * maxima * static_cast<double>(i) / static_cast<double>(count)) +
        noise * (rng.uniform() - 0.5));
  return out;
}

double tolerance(double /*length*/) {
  return 0.05;
}

}  // namespace

TEST_CASE("extremes of noise go, and those of the curve stay") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng(seed);
    const int maxima = 2 + static_cast<int>(rng.below(4));
    const std::size_t count = 120 + rng.below(200);
    const std::vector<double> lengths(count, 1.0 + rng.uniform());
    const std::vector<double> values = noisy(count, maxima, 3e-3, rng);
    INFO("seed " << seed << ", " << maxima << " maxima of " << count);
    CHECK(turns_of(values, true) > 2 * static_cast<std::size_t>(maxima));
    const CalmCurvature calm = calmed(values, lengths, true, [](double) { return 0.6; });
    CHECK(turns_of(calm.at, true) == 2 * static_cast<std::size_t>(maxima));
    for (std::size_t i = 0; i < count; ++i) CHECK(calm.at[i] == Approx(values[i]).margin(9e-3));
    CHECK(std::ranges::count(calm.is_level, 1) > 0);
  }
}

TEST_CASE("it does not matter where a closed curve begins, nor in what unit its curvature is") {
  Rng rng(7);
  const std::size_t count = 150;
  const std::vector<double> lengths(count, 1.5);
  const std::vector<double> values = noisy(count, 3, 3e-3, rng);
  const CalmCurvature calm = calmed(values, lengths, true, tolerance);
  for (const std::size_t shift : {1U, 40U, 149U}) {
    std::vector<double> turned = values;
    std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(shift));
    std::vector<double> expected = calm.at;
    std::ranges::rotate(expected, expected.begin() + static_cast<std::ptrdiff_t>(shift));
    const CalmCurvature other = calmed(turned, lengths, true, tolerance);
    for (std::size_t i = 0; i < count; ++i) CHECK(other.at[i] == Approx(expected[i]).margin(1e-12));
  }
  std::vector<double> doubled = values, halved = lengths;
  for (double& value : doubled) value *= 2.0;
  for (double& length : halved) length *= 0.5;
  const CalmCurvature other = calmed(doubled, halved, true, [](double length) { return 0.5 * tolerance(length); });
  CHECK(turns_of(other.at, true) == turns_of(calm.at, true));
}

TEST_CASE("what moves the curve by more than the tolerance stays") {
  Rng rng(3);
  const std::vector<double> values = noisy(100, 2, 2e-2, rng);
  const std::vector<double> lengths(100, 4.0);
  const auto strict = calmed(values, lengths, true, [](double) { return 1e-9; });
  CHECK(turns_of(strict.at, true) > 20);
  CHECK(turns_of(calmed(values, lengths, true, [](double) { return 1e9; }).at, true) <= 4);
}

TEST_CASE("an open curve is monotone where its ends differ most") {
  Rng rng(11);
  std::vector<double> values;
  for (int i = 0; i < 80; ++i) values.push_back(1e-3 * i + 2e-3 * (rng.uniform() - 0.5));
  values.front() = -1.0;
  values.back() = 1.0;
  const CalmCurvature calm = calmed(values, std::vector<double>(79, 1.0), false, tolerance);
  CHECK(std::ranges::is_sorted(calm.at));
  CHECK(calm.at.front() == -1.0);
  CHECK(calm.at.back() == 1.0);
}

TEST_CASE("few nodes and equal values stay as they are") {
  CHECK(calmed({}, {}, true, tolerance).at.empty());
  const std::vector<double> two{1.0, 2.0};
  CHECK(calmed(two, std::vector{1.0}, false, tolerance).at == two);
  const std::vector<double> zeros(10, 0.0);
  CHECK(calmed(zeros, std::vector<double>(10, 1.0), true, tolerance).at == zeros);
}
