// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "core/base/rng.h"
#include "core/draw/instance_difference.h"

using namespace mes;

namespace {

std::vector<double> random_instances(PrimitiveKind kind, std::size_t count, Rng& random) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count * stride_of(kind); ++i) out.push_back(random.uniform(0.5, 100.0));
  return out;
}

/// The same instances, with their points in another order where that means nothing, moved by a little.
std::vector<double> reordered(PrimitiveKind kind, std::vector<double> values, double by, Rng& random) {
  const std::size_t stride = stride_of(kind);
  for (std::size_t at = 0; at < values.size(); at += stride) {
    double* const v = values.data() + at;
    if (kind == PrimitiveKind::segment) std::swap_ranges(v, v + 2, v + 2);
    if (kind == PrimitiveKind::triangle) std::rotate(v, v + 2 * (1 + at % 2), v + 6);
    if (kind == PrimitiveKind::line) v[2] = -2.0 * v[2], v[3] = -2.0 * v[3];
    if (kind == PrimitiveKind::ray) v[2] *= 3.0, v[3] *= 3.0;
    const bool has_direction = kind == PrimitiveKind::line || kind == PrimitiveKind::ray;
    for (std::size_t i = 0; i < (has_direction ? 2 : doubles_per(kind)); ++i) v[i] += random.uniform(-by, by);
    v[stride - 1] = random.uniform();  // the scalar
  }
  return values;
}

}  // namespace

TEST_CASE("what two layers share is left out of their difference, however it is written") {
  constexpr double kTolerance = 1e-6;
  Rng random(1);
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    INFO(name_of(kind));
    const std::vector<double> some = random_instances(kind, 300, random);
    const std::vector<double> same = reordered(kind, some, 0.4 * kTolerance, random);
    CHECK(without_counterpart(kind, some, same, kTolerance).empty());
    CHECK(without_counterpart(kind, same, some, kTolerance).empty());
    CHECK(without_counterpart(kind, some, {}, kTolerance).size() == 300);
    CHECK(without_counterpart(kind, {}, some, kTolerance).empty());
  }
}

TEST_CASE("a difference in any coordinate is one, and no other instance is named") {
  constexpr double kTolerance = 1e-6;
  Rng random(2);
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    const std::vector<double> some = random_instances(kind, 100, random);
    for (std::size_t i = 0; i < doubles_per(kind); ++i) {
      INFO(name_of(kind) << ", number " << i);
      std::vector<double> other = some;
      other[42 * stride_of(kind) + i] += 10.0;
      CHECK(without_counterpart(kind, some, other, kTolerance) == std::vector<std::uint32_t>{42});
      CHECK(without_counterpart(kind, other, some, kTolerance) == std::vector<std::uint32_t>{42});
    }
  }
}

TEST_CASE("instances far from the origin and at both sides of it are compared as others") {
  const std::vector<double> some{-1e-9, 1e-9, 0.0, 1e15, -1e15, 0.0, 0.0, 0.0, 0.0};
  const std::vector<double> same{1e-9, -1e-9, 5.0, 1e15, -1e15, 5.0, -0.0, 0.0, 5.0};
  CHECK(without_counterpart(PrimitiveKind::point, some, same, 1e-8).empty());
  CHECK(without_counterpart(PrimitiveKind::point, some, same, 1e-10) == std::vector<std::uint32_t>{0});
}
