// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/draw/layer_digest.h"

using namespace mes;

namespace {

LayerDigest of(PrimitiveKind kind, const std::vector<double>& data) {
  return digest_of(kind, data);
}

}  // namespace

TEST_CASE("a digest does not depend on how the same drawing is written") {
  using enum PrimitiveKind;
  CHECK(of(point, {1, 2, 0, 3, 4, 5}) == of(point, {3, 4, 5, 1, 2, 0}));
  CHECK(of(segment, {1, 2, 3, 4, 9}) == of(segment, {3, 4, 1, 2, 9}));
  CHECK(of(segment, {1, 2, 1, 0, 9}) == of(segment, {1, 0, 1, 2, 9}));
  CHECK(of(line, {1, 2, 3, -4, 0}) == of(line, {1, 2, -3, 4, 0}));
  CHECK(of(line, {1, 2, 0, -4, 0}) == of(line, {1, 2, -0.0, 4, 0}));
  CHECK(of(disk, {0.0, -0.0, 1, 0}) == of(disk, {-0.0, 0.0, 1, -0.0}));
  const LayerDigest triangles = of(triangle, {0, 0, 1, 0, 0, 1, 7});
  for (const std::vector<double>& other : {std::vector<double>{1, 0, 0, 1, 0, 0, 7},
                                           {0, 1, 0, 0, 1, 0, 7},
                                           {0, 0, 0, 1, 1, 0, 7},
                                           {1, 0, 0, 0, 0, 1, 7}})
    CHECK(of(triangle, other) == triangles);
}

TEST_CASE("a digest depends on everything that is drawn") {
  using enum PrimitiveKind;
  CHECK(of(point, {1, 2, 0}) != of(point, {2, 1, 0}));
  CHECK(of(point, {1, 2, 0}) != of(point, {1, 2, 1}));
  CHECK(of(point, {1, 2, 0}) != of(point, {1, std::nextafter(2.0, 3.0), 0}));
  CHECK(of(point, {1, 2, 0}) != of(point, {1, 2, 0, 1, 2, 0}));
  CHECK(of(point, {}) != of(point, {0, 0, 0}));
  CHECK(of(disk, {1, 2, 3, 0}) != of(circle, {1, 2, 3, 0}));
  CHECK(of(ray, {1, 2, 3, 4, 0}) != of(ray, {1, 2, -3, -4, 0}));
  CHECK(of(segment, {1, 2, 3, 4, 0}) != of(segment, {1, 4, 3, 2, 0}));
  // Counter-clockwise from the first end to the second.
  CHECK(of(arc, {0, 0, 5, 5, 0, 0, 5, 0}) != of(arc, {0, 0, 5, 0, 5, 5, 0, 0}));
  CHECK(of(segment, {1, 2, 3, 4, 0, 5, 6, 7, 8, 0}) != of(segment, {1, 2, 7, 8, 0, 5, 6, 3, 4, 0}));
}

TEST_CASE("numbers that only tell elements apart can be left out") {
  using enum PrimitiveKind;
  const std::vector<double> a{1, 2, 17, 3, 4, 18};
  const std::vector<double> b{3, 4, 2, 1, 2, 1};
  CHECK(digest_of(point, a) != digest_of(point, b));
  CHECK(digest_of(point, a, false) == digest_of(point, b, false));
}

TEST_CASE("digests of parts add up to that of the whole") {
  using enum PrimitiveKind;
  LayerDigest sum = of(point, {1, 2, 0});
  sum += of(point, {3, 4, 0});
  CHECK(sum == of(point, {1, 2, 0, 3, 4, 0}));
  CHECK(named("curve", sum) != named("points", sum));
  CHECK(sum.text().size() == 32);
}
