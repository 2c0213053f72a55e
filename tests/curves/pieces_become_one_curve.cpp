// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"
#include "core/curves/joined_ends.h"

using namespace mes;

namespace {

PlaneCurve line(Vec2 from, Vec2 to) {
  PlaneCurve out(from);
  out.line_to(to);
  return out;
}

std::vector<Vec2> corners_of(const PlaneCurve& curve) {
  std::vector<Vec2> out{curve.start()};
  curve.for_each_piece([&](const Piece& piece) { out.push_back(piece.to()); });
  return out;
}

}  // namespace

TEST_CASE("lines in any order and direction become the curves that they are parts of") {
  // Two polygons and a chain of random corners, cut up, turned around and shuffled.
  Rng rng(3);
  const auto corners = [&](std::size_t count) {
    std::vector<Vec2> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back({rng.uniform(), rng.uniform()});
    return out;
  };
  const std::vector<std::vector<Vec2>> parts{corners(50), corners(3), corners(17)};
  std::vector<PlaneCurve> lines;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t i = 0; i + (p == 2 ? 1 : 0) < parts[p].size(); ++i) {
      const Vec2 a = parts[p][i];
      const Vec2 b = parts[p][(i + 1) % parts[p].size()];
      lines.push_back(rng.uniform() < 0.5 ? line(a, b) : line(b, a));
    }
  for (std::size_t i = lines.size() - 1; i > 0; --i)
    std::swap(lines[i], lines[static_cast<std::size_t>(rng.uniform() * static_cast<double>(i + 1))]);
  const std::vector<PlaneCurve> joined = joined_ends(lines, 1e-12);
  REQUIRE(joined.size() == 3);
  std::vector<std::size_t> sizes;
  for (const PlaneCurve& curve : joined) {
    sizes.push_back(curve.piece_count());
    CHECK(curve.is_closed() == (curve.piece_count() != 16));
    // Each corner of a part once, whatever the beginning.
    std::vector<Vec2> seen = corners_of(curve);
    if (curve.is_closed()) seen.pop_back();
    const auto part = std::ranges::find(parts, seen.size(), &std::vector<Vec2>::size);
    REQUIRE(part != parts.end());
    CHECK(std::ranges::is_permutation(seen, *part));
  }
  std::ranges::sort(sizes);
  CHECK(sizes == std::vector<std::size_t>{3, 16, 50});
}

TEST_CASE("where three meet none are joined, and ends that are too far apart neither") {
  const std::vector<PlaneCurve> star{line({0, 0}, {1, 0}), line({0, 0}, {0, 1}), line({0, 0}, {-1, 0}),
                                     line({-1, 1e-3}, {-2, 0})};
  CHECK(joined_ends(star, 1e-6).size() == 4);
  CHECK(joined_ends(star, 1e-2).size() == 3);
  CHECK(joined_ends({}, 1.0).empty());
  CHECK(joined_ends(star, 0.0).size() == 4);
}

TEST_CASE("curves that cross or touch where they were cut go on most straight, in any order of the pieces") {
  Rng rng(9);
  const auto half = [](Vec2 center, double radius, double from) {
    const EllipticArc arc{center, {radius, 0}, {0, radius}, from, std::numbers::pi};
    const auto at = [&](double angle) { return center + radius * Vec2{std::cos(angle), std::sin(angle)}; };
    PlaneCurve out(at(from));
    out.arc_to(arc, at(from + std::numbers::pi));
    return out;
  };
  const auto joined_in_any_order = [&](std::vector<PlaneCurve> pieces) {
    for (std::size_t i = pieces.size(); i > 1; --i) std::swap(pieces[i - 1], pieces[rng.below(i)]);
    for (PlaneCurve& piece : pieces)
      if (rng.below(2) == 0) piece = reversed(piece);
    return joined_ends(pieces, 1e-6);
  };
  for (int round = 0; round < 20; ++round) {
    // Circles that touch from inside, from outside, and three in one point.
    const double turn = 0.37 * round;
    const Vec2 way{std::cos(turn), std::sin(turn)};
    for (const std::vector<double>& radii : {std::vector{5.0, 3.0}, {5.0, -3.0}, {5.0, 4.0, -2.0}}) {
      std::vector<PlaneCurve> pieces;
      for (const double radius : radii) {
        // All go through the point 5 way.
        pieces.push_back(half((5.0 - radius) * way, std::abs(radius), turn));
        pieces.push_back(half((5.0 - radius) * way, std::abs(radius), turn + std::numbers::pi));
      }
      const std::vector<PlaneCurve> joined = joined_in_any_order(pieces);
      REQUIRE(joined.size() == radii.size());
      for (const PlaneCurve& one : joined) {
        CHECK(one.is_closed());
        REQUIRE(one.arcs().size() == 2);
        CHECK(one.arcs()[0].center == one.arcs()[1].center);
      }
    }
  }
  // Four lines into one point are two.
  const std::vector<PlaneCurve> cross{line({0, 0}, {5, 1}), line({0, 0}, {-5, -1.1}), line({0, 0}, {0, 2}),
                                      line({0, 0}, {0.1, -2})};
  const std::vector<PlaneCurve> through = joined_in_any_order(cross);
  REQUIRE(through.size() == 2);
  for (const PlaneCurve& one : through) CHECK(std::abs(dot(one.start(), one.end())) > 3.9);
  // Where one would turn back, nothing is joined.
  CHECK(
      joined_in_any_order({line({0, 0}, {5, 1}), line({0, 0}, {-5, 1}), line({0, 0}, {0, 2}), line({0, 0}, {0.1, 2})})
          .size() == 4);
}

TEST_CASE("a star of ends stays apart, whatever lies near its middle") {
  std::vector<PlaneCurve> rays;
  for (int i = 0; i < 3000; ++i) rays.push_back(line({0, 0}, {1.0 + i, 5.0}));
  // Two ends at one place are joined, though many others are near.
  rays.push_back(line({1e-4, 0}, {0, -9}));
  rays.push_back(line({1e-4, 0}, {1, -9}));
  const std::vector<PlaneCurve> joined = joined_ends(rays, 1e-3);
  REQUIRE(joined.size() == 3001);
  CHECK(joined.back().piece_count() == 2);
  CHECK(joined.front().points().size() == 2);
}

TEST_CASE("a slot of two lines and two arcs is closed exactly, though its ends are not") {
  const auto half = [](Vec2 center, double from) {
    const EllipticArc arc{center, {1, 0}, {0, 1}, from, std::numbers::pi};
    PlaneCurve out(center + Vec2{std::cos(from), std::sin(from)});
    out.arc_to(arc, center + Vec2{std::cos(from + std::numbers::pi), std::sin(from + std::numbers::pi)});
    return out;
  };
  const auto slot = joined_ends({line({0, -1}, {5, -1.0000001}), half({5, 0}, -0.5 * std::numbers::pi),
                                 line({0, 1}, {5, 1}), half({0, 0}, 0.5 * std::numbers::pi)},
                                1e-5);
  REQUIRE(slot.size() == 1);
  CHECK(slot[0].is_closed());
  CHECK(slot[0].piece_count() == 4);
  CHECK(slot[0].start() == slot[0].end());
}

TEST_CASE("a curve turned around has the same points") {
  PlaneCurve curve({0, 0});
  curve.line_to({1, 0});
  curve.quadratic_to({2, 0}, {2, 1});
  curve.cubic_to({2, 2}, {1, 2}, {1, 1});
  curve.arc_to({{0, 1}, {1, 0}, {0, 1}, 0.0, 2.0}, {std::cos(2.0), 1 + std::sin(2.0)});
  std::vector<Vec2> forth;
  std::vector<Vec2> back;
  curve.for_each_piece([&](const Piece& piece) {
    for (const double t : {0.0, 0.25, 0.5, 0.75}) forth.push_back(piece.at(t));
  });
  reversed(curve).for_each_piece([&](const Piece& piece) {
    for (const double t : {0.25, 0.5, 0.75, 1.0}) back.push_back(piece.at(t));
  });
  std::ranges::reverse(back);
  REQUIRE(forth.size() == back.size());
  for (std::size_t i = 0; i < forth.size(); ++i) CHECK(distance(forth[i], back[i]) < 1e-14);
}

TEST_CASE("equal ends are joined before near ones, and short lines stay lines") {
  // A line shorter than the tolerance, between two that it joins exactly.
  const auto chain = joined_ends({line({0, 0}, {1, 0}), line({1, 0}, {1.01, 0}), line({1.01, 0}, {2, 0})}, 0.05);
  REQUIRE(chain.size() == 1);
  CHECK(corners_of(chain[0]) == std::vector<Vec2>{{0, 0}, {1, 0}, {1.01, 0}, {2, 0}});
  CHECK_FALSE(chain[0].is_closed());
  const auto alone = joined_ends({line({0, 0}, {0.01, 0}), line({5, 5}, {6, 6})}, 0.05);
  REQUIRE(alone.size() == 2);
  CHECK_FALSE(alone[0].is_closed());
}
