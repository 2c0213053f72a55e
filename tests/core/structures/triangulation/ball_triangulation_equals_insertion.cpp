// SPDX-License-Identifier: GPL-3.0-or-later
// Divide and conquer against CGAL's insertion one by one: few and many hidden balls, one centre several times,
// collinear centres, and balls through a common point.
#include <CGAL/Regular_triangulation_2.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/base/rng.h"
#include "core/structures/triangulation/regular_triangulation.h"

using namespace mes;

namespace {

using WeightedBall = BallOf<double>;
using Raw = CGAL::Regular_triangulation_2<FastKernel>;
using Ends = std::array<double, 4>;

WeightedBall ball_among(int kind, std::size_t count, Rng& rng) {
  const double x = rng.uniform();
  const double y = rng.uniform();
  switch (kind) {
    case 0: return {x, y, 0.3 * rng.uniform() / static_cast<double>(count)};
    case 1: return {x, y, 0.3 * rng.uniform()};
    case 2: return {x, y, rng.below(50) == 0 ? 0.05 * rng.uniform() : 1e-5 * rng.uniform()};
    case 3: return {static_cast<double>(rng.below(12)), static_cast<double>(rng.below(12)), 0.1 * rng.uniform()};
    case 4: return {std::round(1000.0 * x), 2.0 * std::round(1000.0 * x), 0.3 * rng.uniform()};  // on a line
    case 5:  // nearly all on a line
      return {std::round(1000.0 * x), rng.below(60) == 0 ? y : 0.0, 0.3 * rng.uniform()};
    default: return {x, y, (x - 0.5) * (x - 0.5) + (y - 0.3) * (y - 0.3)};
  }
}

Ends ends_of(WeightedBall a, WeightedBall b) {
  if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
  return {a.x, a.y, b.x, b.y};
}

}  // namespace

TEST_CASE("balls are triangulated as by insertion one by one") {
  std::size_t fast = 0;
  for (int run = 0; run < 1000; ++run) {
    CAPTURE(run);
    Rng rng(static_cast<std::uint64_t>(run) + 1);
    const int kind = run % 7;
    const std::size_t count = 3 + rng.below(run % 50 == 2 ? 3000 : run % 10 == 4 ? 400 : 60);
    Table<InputSlot, WeightedBall> balls;
    while (balls.size() < count) {
      balls.push_back(ball_among(kind, count, rng));
      if (rng.below(10) == 0) balls.push_back({balls.back().x, balls.back().y, balls.back().w * 0.9});
    }
    JobControl job;
    fast += ball_triangulation(balls, {}, job) ? 1U : 0U;
    const RegularTables ours = regular_triangulation<FastKernel>(balls, job);
    Raw raw;
    for (const WeightedBall& ball : balls) raw.insert(Raw::Weighted_point(Raw::Bare_point(ball.x, ball.y), ball.w));
    CHECK(ours.dimension == raw.dimension());
    CHECK(std::ranges::count(ours.state, BallState::visible) ==
          static_cast<std::ptrdiff_t>(raw.number_of_vertices()));
    std::set<Ends> our_edges, raw_edges;
    for (const auto& edge : ours.edges) our_edges.insert(ends_of(balls[edge.v[0]], balls[edge.v[1]]));
    for (auto e = raw.finite_edges_begin(); e != raw.finite_edges_end(); ++e) {
      const auto& p = e->first->vertex(Raw::cw(e->second))->point();
      const auto& q = e->first->vertex(Raw::ccw(e->second))->point();
      raw_edges.insert(ends_of({p.x(), p.y(), 0.0}, {q.x(), q.y(), 0.0}));
    }
    // Any triangles will do among balls with one point of equal power up to the last bit.
    CHECK((kind == 6 ? our_edges.size() == raw_edges.size() : our_edges == raw_edges));
  }
  CHECK(fast > 100);
}
