// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths of pieces against formulas, where the speed has a sharp minimum wherever in the piece.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"
#include "core/curves/internal/arc_length.h"

using namespace mes;

namespace {

Piece quadratic(Vec2 a, Vec2 b, Vec2 c) {
  Piece out{.kind = PieceKind::quadratic};
  out.points[0] = a;
  out.points[1] = b;
  out.points[2] = c;
  return out;
}

Piece arc(double width, double height, double start, double sweep) {
  Piece out{.kind = PieceKind::arc};
  out.arc = {.center = {}, .u = {width, 0.0}, .v = {0.0, height}, .start = start, .sweep = sweep};
  out.points[0] = out.at(0.0);
  out.points[1] = out.at(1.0);
  return out;
}

}  // namespace

TEST_CASE("a piece that turns back on a line is as long as the way there and back, wherever it turns") {
  for (const double turn : {1e-6, 0.002, 0.005, 0.0095, 0.1, 0.3, 0.77, 0.991, 0.9999}) {
    INFO("turn at " << turn);
    const double control = turn / (2.0 * turn - 1.0);
    const auto at = [control](double t) { return 2.0 * control * t * (1.0 - t) + t * t; };
    const double expected = std::abs(at(turn)) + std::abs(1.0 - at(turn));
    for (const int exponent : {-480, -400, 0, 400, 480}) {
      const PieceLength length(quadratic({}, {std::ldexp(control, exponent), 0.0}, {std::ldexp(1.0, exponent), 0.0}));
      CHECK(std::ldexp(length.total(), -exponent) == Approx(expected).epsilon(1e-13));
      const double half = length.parameter_at(0.5 * length.total());
      const double way = half < turn ? std::abs(at(half)) : std::abs(at(turn)) + std::abs(at(half) - at(turn));
      CHECK(way == Approx(0.5 * expected).epsilon(1e-12));
    }
  }
}

TEST_CASE("arcs of an ellipse as flat as a line are as long as the line, there and back") {
  Rng rng(3);
  for (int i = 0; i < 200; ++i) {
    const double start = rng.uniform(-7.0, 7.0);
    const double sweep = rng.uniform(-2.0, 2.0) * std::numbers::pi;
    // Of the cosine: its total variation.
    double expected = 0.0;
    const double low = std::min(start, start + sweep);
    const double high = std::max(start, start + sweep);
    double before = low;
    for (double turn = std::ceil(low / std::numbers::pi) * std::numbers::pi; turn < high; turn += std::numbers::pi) {
      expected += std::abs(std::cos(turn) - std::cos(before));
      before = turn;
    }
    expected += std::abs(std::cos(high) - std::cos(before));
    INFO("from " << start << " by " << sweep);
    CHECK(PieceLength(arc(1.0, 1e-9, start, sweep)).total() == Approx(expected).epsilon(1e-11));
    CHECK(PieceLength(arc(3.0, 3.0, start, sweep)).total() == Approx(3.0 * std::abs(sweep)).epsilon(1e-14));
  }
}
