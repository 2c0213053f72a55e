// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of parabolas against the definition of a parabola, and against very fine chains of chords.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/geometry/parabola_arc.h"
#include "core/base/rng.h"

using namespace mes;

namespace {

/// The points equally far from a focus and the line through `foot` along `along`, turned and moved.
struct Parabola {
  Vec2 foot{}, along{}, up{};
  double h = 1.0;

  Vec2 focus() const { return foot + h * up; }
  Vec2 at(double x) const { return foot + x * along + (0.5 * x * x / h + 0.5 * h) * up; }
  /// The tangents at two points meet midway between them along the line.
  ParabolaArc arc(double x, double y) const {
    return {at(x), foot + 0.5 * (x + y) * along + 0.5 * (x * y / h + h) * up, at(y)};
  }
  double from_line(Vec2 p) const { return dot(p - foot, up); }
};

Parabola some_parabola(Rng& rng) {
  const double angle = rng.uniform(0.0, 6.0);
  const Vec2 along{std::cos(angle), std::sin(angle)};
  return {{rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)}, along, perpendicular(along), rng.uniform(0.1, 3.0)};
}

double fine_length(const ParabolaArc& arc) {
  constexpr int kChords = 100'000;
  double out = 0.0;
  for (int i = 0; i < kChords; ++i)
    out += distance(point_at(arc, double(i) / kChords), point_at(arc, double(i + 1) / kChords));
  return out;
}

}  // namespace

TEST_CASE("every point of an arc is as far from the focus as from the directrix, and so is every part of it") {
  Rng rng(3);
  for (int round = 0; round < 100; ++round) {
    const Parabola parabola = some_parabola(rng);
    const ParabolaArc arc = parabola.arc(rng.uniform(-8.0, 8.0), rng.uniform(-8.0, 8.0));
    const ParabolaArc part = part_of(arc, 0.25, 0.625);
    for (int i = 0; i <= 16; ++i)
      for (const Vec2 p : {point_at(arc, i / 16.0), point_at(part, i / 16.0)})
        CHECK(distance(p, parabola.focus()) == Approx(parabola.from_line(p)).epsilon(1e-10));
    CHECK(part.from == point_at(arc, 0.25));
    CHECK(distance(point_at(part, 1.0), point_at(arc, 0.625)) < 1e-12);
  }
}

TEST_CASE("chords leave an arc by at most 1/1024 of the distance from the focus") {
  Rng rng(4);
  for (int round = 0; round < 100; ++round) {
    const Parabola parabola = some_parabola(rng);
    const std::vector<Vec2> corners = corners_of(parabola.arc(rng.uniform(-80.0, 80.0), rng.uniform(-80.0, 80.0)));
    REQUIRE(corners.size() >= 2);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      // The curve is farthest from its chord midway along the line.
      const Vec2 chord = corners[i] - corners[i - 1];
      const double x = 0.5 * dot(corners[i] + corners[i - 1] - 2.0 * parabola.foot, parabola.along);
      const Vec2 at = parabola.at(x);
      const double off = std::abs(cross(chord, at - corners[i - 1])) / length(chord);
      CHECK(off <= 1.001 / 1024.0 * distance(at, parabola.focus()));
      CHECK(distance(corners[i], parabola.focus()) == Approx(parabola.from_line(corners[i])).epsilon(1e-9));
    }
  }
}

TEST_CASE("length, box and distance are those of a very fine chain") {
  Rng rng(5);
  for (int round = 0; round < 30; ++round) {
    const Parabola parabola = some_parabola(rng);
    // Some are nearly straight.
    const double x = rng.uniform(-8.0, 8.0);
    const ParabolaArc arc = parabola.arc(x, x + rng.uniform(-8.0, 8.0) * std::pow(10.0, -(round % 6)));
    CHECK(length_of(arc) == Approx(fine_length(arc)).epsilon(1e-8));
    const Box2 box = bounding_box_of(arc);
    Box2 fine;
    for (int i = 0; i <= 4096; ++i) {
      const Vec2 p = point_at(arc, i / 4096.0);
      fine.add(p);
      CHECK(box.low.x <= p.x + 1e-12);
      CHECK(box.low.y <= p.y + 1e-12);
      CHECK(box.high.x >= p.x - 1e-12);
      CHECK(box.high.y >= p.y - 1e-12);
    }
    CHECK(fine.low.x == Approx(box.low.x).margin(1e-5));
    CHECK(fine.high.y == Approx(box.high.y).margin(1e-5));
    for (int i = 0; i < 20; ++i) {
      const Vec2 p{rng.uniform(-20.0, 20.0), rng.uniform(-20.0, 20.0)};
      double nearest = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 4096; ++k) nearest = std::min(nearest, distance(p, point_at(arc, k / 4096.0)));
      CHECK(distance_to(arc, p) == Approx(nearest).margin(1e-3));
      CHECK(distance_to(arc, p) <= nearest + 1e-9);
    }
  }
}

TEST_CASE("a straight arc is its chord, in any unit of length") {
  for (const double unit : {1.0, 0x1p-490, 0x1p490}) {
    const ParabolaArc straight{{0.0, 0.0}, {1.5 * unit, 2.0 * unit}, {3.0 * unit, 4.0 * unit}};
    CHECK(length_of(straight) == 5.0 * unit);
    CHECK(corners_of(straight) == std::vector<Vec2>{straight.from, straight.to});
    CHECK(distance_to(straight, {4.0 * unit, -3.0 * unit}) == Approx(5.0 * unit));
    const ParabolaArc bent{{0.0, 0.0}, {unit, unit}, {2.0 * unit, 0.0}};
    CHECK(length_of(bent) / unit == length_of({{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}}));
    CHECK(corners_of(bent).size() == corners_of(ParabolaArc{{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}}).size());
  }
}
