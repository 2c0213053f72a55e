// SPDX-License-Identifier: GPL-3.0-or-later
// Signs in fields with roots against integers, and predicates of crossings against algebraic numbers: of balls of small
// integers, where zero is frequent, of balls at random, and of circumdisks through common samples.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <deque>

#include "core/base/rng.h"
#include "core/kernel/numbers/root_sign.h"
#include "core/structures/balls/internal/crossings/crossing_kernel.h"
#include "core/structures/balls/internal/numbers/root_numbers.h"

using namespace mes;

namespace {

using RootRational = RootElement::Rational;
using RootsPoint = RootsKernel::Point_2;
using Root = RootsKernel::FT;

// The same crossing in algebraic numbers, from the formula with the sine of the angle instead of the foot.
RootsPoint algebraic(const CrossingSource& source) {
  const auto p = ball_in<Root>(*source.ball[0]), q = ball_in<Root>(*source.ball[1]);
  const Root dx = q.x - p.x, dy = q.y - p.y, dd = dx * dx + dy * dy;
  const Root along = (dd + p.w - q.w) / (Root(2) * dd);
  const Root across = CGAL::sqrt(Root(p.w / dd - along * along)) * Root(source.left ? 1.0 : -1.0);
  return {p.x + along * dx - across * dy, p.y + along * dy + across * dx};
}

struct Made {
  std::deque<PipelineBall> balls;
  std::deque<Crossing> crossings;
  std::vector<RootsPoint> points;

  void add(const PipelineBall& a, const PipelineBall& b) {
    const auto p = ball_in<RootRational>(a), q = ball_in<RootRational>(b);
    const RootRational dx = q.x - p.x, dy = q.y - p.y, dd = dx * dx + dy * dy, s = dd - q.w + p.w;
    const RootRational radicand = 4 * dd * p.w - s * s;
    if (dd == 0 || radicand < 0) return;
    for (const bool left : {false, true}) {
      const auto kind = radicand == 0 ? CrossingSource::Kind::touch : CrossingSource::Kind::root;
      crossings.push_back(
          crossing_of({kind, left, {&a, &b}, {}}, ball_in<Crossing::First>(a), ball_in<Crossing::First>(b)));
      crossings.back().same = &crossings.back();
      points.push_back(algebraic(crossings.back().source));
    }
  }
  CrossingPoint at(std::size_t i) const { return {&crossings[i]}; }
};

PipelineBall disk_of(double x, double y, double r) {
  PipelineBall out;
  out.disk = out.drawn = {{x, y}, r};
  return out;
}

PipelineBall ball_at_random(int kind, Rng& rng) {
  const auto whole = [&rng](std::size_t below) { return static_cast<double>(rng.below(below)); };
  if (kind == 0) return disk_of(whole(4), whole(4), 1.0 + whole(3));
  if (kind == 1) return disk_of(rng.uniform(), rng.uniform(), 0.3 + rng.uniform());
  // Of three of few samples, so that circles meet in them.
  static constexpr Vec2 kSamples[] = {{0, 0}, {3, 1}, {1, 4}, {5, 5}, {2, 7}, {6, 2}};
  PipelineBall out;
  out.origin = BallOrigin::circumdisk;
  do {
    for (Vec2& corner : out.corner) corner = kSamples[rng.below(6)];
  } while (cross(out.corner[1] - out.corner[0], out.corner[2] - out.corner[0]) == 0.0);
  return out;
}

}  // namespace

TEST_CASE("signs of sums of roots are exact, also where the sum is zero") {
  // Of roots that depend on each other.
  const RootElement::Radicands radicands{2, 3, 6, 12};
  const RootElement two(0, 1, radicands, 0), three(0, 1, radicands, 1), six(0, 1, radicands, 2),
      twelve(0, 1, radicands, 3);
  CHECK((two * three - six).sign() == 0);
  CHECK((twelve - three - three).sign() == 0);
  const RootElement sum = two + three;
  CHECK((sum * sum - RootElement(5.0) - six - six).sign() == 0);
  CHECK((sum - RootElement(3.146)).sign() == 1);
  CHECK((sum - RootElement(3.147)).sign() == -1);
  CHECK((sum * six - RootElement(2.0) * three - RootElement(3.0) * two).sign() == 0);
  CHECK((two * three * six * twelve - RootElement(6.0) * twelve).sign() == 0);
  CHECK((two * three * six * twelve - RootElement(6.0) * twelve - RootElement(0x1p-300)).sign() == -1);
  CHECK((-two).sign() == -1);
  CHECK(RootElement().sign() == 0);
  CHECK((two - two).sign() == 0);

  // Whole numbers in the place of the roots.
  Rng rng(3);
  int zeros = 0;
  for (int run = 0; run < 3000; ++run) {
    RootElement::Radicands squares;
    long roots[4];
    for (std::size_t i = 0; i < 4; ++i) {
      roots[i] = static_cast<long>(rng.below(4));
      squares[i] = roots[i] * roots[i];
    }
    RootElement value(static_cast<double>(rng.below(9)) - 4.0);
    long expected = 0;
    for (int term = 0; term < 4; ++term) {
      const auto root = static_cast<std::size_t>(rng.below(4));
      const long constant = static_cast<long>(rng.below(7)) - 3;
      const long factor = static_cast<long>(rng.below(5)) - 2;
      const RootElement next(constant, factor, squares, root);
      const long number = constant + factor * roots[root];
      if (term == 0) {
        value = next;
        expected = number;
      } else if (rng.below(2) == 0) {
        value = value * next;
        expected *= number;
      } else {
        value = value - next;
        expected -= number;
      }
    }
    zeros += expected == 0 ? 1 : 0;
    REQUIRE(value.sign() == (expected > 0) - (expected < 0));
  }
  CHECK(zeros > 100);
}

TEST_CASE("predicates of crossings are those of algebraic numbers") {
  Rng rng(8);
  int zeros = 0;
  for (int run = 0; run < 60; ++run) {
    INFO("run " << run);
    const int kind = run % 3;
    Made made;
    while (made.crossings.size() < 6) {
      made.balls.push_back(ball_at_random(kind, rng));
      const std::size_t last = made.balls.size() - 1;
      for (std::size_t i = 0; i < last && made.crossings.size() < 6; ++i) made.add(made.balls[i], made.balls[last]);
    }
    const auto pick = [&] { return static_cast<std::size_t>(rng.below(made.crossings.size())); };
    for (int test = 0; test < 8; ++test) {
      const std::size_t i = pick(), j = pick(), k = pick(), l = pick();
      const auto p = made.at(i), q = made.at(j), r = made.at(k), s = made.at(l);
      const auto& a = made.points[i];
      const auto& b = made.points[j];
      const auto& c = made.points[k];
      const auto& d = made.points[l];
      const int x_order = CGAL::compare_x(a, b);
      REQUIRE(CrossingKernel::Compare_x_2()(p, q) == x_order);
      REQUIRE(CrossingKernel::Compare_y_2()(p, q) == CGAL::compare_y(a, b));
      const auto turn = CGAL::orientation(a, b, c);
      REQUIRE(CrossingKernel::Orientation_2()(p, q, r) == turn);
      if (turn == CGAL::LEFT_TURN) {
        const auto side = CGAL::side_of_oriented_circle(a, b, c, d);
        REQUIRE(CrossingKernel::Side_of_oriented_circle_2()(p, q, r, s) == side);
        zeros += side == CGAL::ON_ORIENTED_BOUNDARY && i != l && j != l && k != l ? 1 : 0;
      }
      const PipelineBall& first = made.balls.front();
      const PipelineBall& last = made.balls.back();
      const auto center = [](const PipelineBall& ball) {
        const auto exact = ball_in<Root>(ball);
        return RootsPoint(exact.x, exact.y);
      };
      REQUIRE(compare_distances_to_line(p, q, first, last) ==
              CGAL::sign(Root((b.x() - a.x()) * (center(first).y() - center(last).y()) -
                              (b.y() - a.y()) * (center(first).x() - center(last).x()))));
    }
  }
  CHECK(zeros > 10);
}

TEST_CASE("crossings and their circumcentres are rounded to the nearest doubles") {
  Rng rng(5);
  for (int run = 0; run < 60; ++run) {
    INFO("run " << run);
    Made made;
    while (made.crossings.size() < 3) {
      made.balls.push_back(ball_at_random(run % 3, rng));
      const std::size_t last = made.balls.size() - 1;
      for (std::size_t i = 0; i < last && made.crossings.size() < 3; ++i) made.add(made.balls[i], made.balls[last]);
    }
    for (const LocalFrame frame : {LocalFrame{}, LocalFrame{{3.0, -1024.5}, 7}, LocalFrame{{0.0, 0x1p-40}, -60}}) {
      for (std::size_t i = 0; i < 3; ++i) {
        const PlacedPoint expected = place_of(made.points[i], frame);
        const PlacedPoint place = place_of(made.at(i), frame);
        REQUIRE(place.local == expected.local);
        REQUIRE(place.document == expected.document);
      }
      if (CGAL::collinear(made.points[0], made.points[1], made.points[2])) continue;
      const PlacedPoint expected = place_of_circumcenter(made.points[0], made.points[1], made.points[2], frame);
      const PlacedPoint place = place_of_circumcenter(made.at(0), made.at(1), made.at(2), frame);
      REQUIRE(place.local == expected.local);
      REQUIRE(place.document == expected.document);
    }
    const auto center = ball_in<Root>(made.balls[0]);
    const Vec2 way = rounded_vector(made.balls[0], made.at(2));
    CHECK(way.x == rounded(Root(made.points[2].x() - center.x)));
    CHECK(way.y == rounded(Root(made.points[2].y() - center.y)));
  }
}
