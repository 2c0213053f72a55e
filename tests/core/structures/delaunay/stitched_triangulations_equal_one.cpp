// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations made in pieces and stitched along lines against CGAL's check of every face, and against the edges of
// the triangulation made at once.
#include <CGAL/Delaunay_triangulation_2.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "core/base/rng.h"
#include "core/kernel/kernels.h"
#include "core/structures/delaunay/internal/delaunay_stitch.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"

using namespace mes;
using namespace mes::test;

namespace {

using Triangulation = CGAL::Delaunay_triangulation_2<FastKernel>;

void insert(Triangulation& triangulation, const std::vector<Vec2>& points) {
  for (const Vec2 p : points) triangulation.insert({p.x, p.y});
}

// Cuts at random places across random sides down to a few points; pieces on a line are put in point by point.
void stitch_pieces(Triangulation& out, std::vector<Vec2> points, std::size_t least, Rng& rng) {
  if (points.size() < least) return insert(out, points);
  const SweepOrder before{rng.below(2) == 0};
  std::ranges::sort(points, before);
  const auto middle =
      std::ranges::lower_bound(points, points[points.size() / 4 + rng.below(points.size() / 2 + 1)], before);
  if (middle == points.begin()) return insert(out, points);
  const std::vector<Vec2> low(points.begin(), middle);
  const std::vector<Vec2> high(middle, points.end());
  Triangulation rest;
  stitch_pieces(out, low, least, rng);
  stitch_pieces(rest, high, least, rng);
  if (out.dimension() == 2 && rest.dimension() == 2) {
    DelaunayStitch<Triangulation>::run(out, rest, before);
  } else if (rest.dimension() == 2) {
    out.swap(rest);
    insert(out, low);
  } else {
    insert(out, high);
  }
}

std::set<std::array<double, 4>> edges_of(const Triangulation& triangulation) {
  std::set<std::array<double, 4>> edges;
  for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e) {
    auto a = e->first->vertex(Triangulation::ccw(e->second))->point();
    auto b = e->first->vertex(Triangulation::cw(e->second))->point();
    if (b < a) std::swap(a, b);
    edges.insert({a.x(), a.y(), b.x(), b.y()});
  }
  return edges;
}

void check_stitching(const std::vector<Vec2>& points, std::size_t least, std::uint64_t seed,
                     bool diagonals_are_unique) {
  Rng rng(seed);
  Triangulation pieces;
  stitch_pieces(pieces, points, least, rng);
  Triangulation at_once;
  insert(at_once, points);
  REQUIRE(pieces.dimension() == at_once.dimension());
  REQUIRE(pieces.number_of_vertices() == at_once.number_of_vertices());
  REQUIRE(pieces.tds().number_of_faces() == at_once.tds().number_of_faces());
  CHECK(pieces.is_valid());
  if (diagonals_are_unique) CHECK(edges_of(pieces) == edges_of(at_once));
  // It is one like any other: it grows and shrinks.
  for (const Vec2 p : uniform_square(20, seed)) pieces.insert({p.x, p.y});
  while (pieces.number_of_vertices() > at_once.number_of_vertices() / 2)
    pieces.remove(pieces.finite_vertices_begin());
  CHECK(pieces.is_valid());
}

}  // namespace

TEST_CASE("pieces of random points and of curves are stitched") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const std::size_t least : std::array<std::size_t, 3>{4, 12, 150}) {
      check_stitching(uniform_square(300, seed), least, seed, true);
      check_stitching(benchmark_curve(400, seed), least, seed, true);
      check_stitching(noisy_curve(400, seed), least, seed, true);
    }
  }
}

TEST_CASE("pieces of points in few places are stitched") {
  // Small lattices: cocircular and collinear samples, duplicates, hulls with many points on a side.
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Rng rng(seed);
    const std::uint64_t width = 2 + rng.below(12);
    const std::uint64_t height = 2 + rng.below(12);
    std::vector<Vec2> points;
    for (std::uint64_t i = 0; i < 10 + rng.below(100); ++i)
      points.push_back({static_cast<double>(rng.below(width)), static_cast<double>(rng.below(height))});
    for (const std::size_t least : std::array<std::size_t, 2>{4, 20}) check_stitching(points, least, seed, false);
  }
}

TEST_CASE("pieces of degenerate inputs are stitched") {
  for (const DegenerateInput& input : degenerate_inputs())
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      if (!input.positions.empty()) check_stitching(input.positions, 4, seed, false);
}
