// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of the union of grown balls against its definition: what the balls of all pairs leave of each circle, in
// numbers of fifty digits. Of shapes with circular arcs, whose inner balls have nearly one centre, and of user balls
// that nearly coincide, touch, or are there twice.
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/balls/grown_complex.h"
#include "core/structures/poles/polar_union.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using Long = boost::multiprecision::cpp_bin_float_50;

struct LongBall {
  Long x, y, w;
};

LongBall circumdisk(const std::array<Vec2, 3>& corner) {
  const Long ax(corner[0].x), ay(corner[0].y);
  const Long bx = Long(corner[1].x) - ax, by = Long(corner[1].y) - ay;
  const Long cx = Long(corner[2].x) - ax, cy = Long(corner[2].y) - ay;
  const Long d = 2 * (bx * cy - by * cx);
  const Long bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const Long ux = (cy * bb - by * cc) / d, uy = (bx * cc - cx * bb) / d;
  return {ax + ux, ay + uy, ux * ux + uy * uy};
}

/// As they are by their origin, grown, and each once.
std::vector<LongBall> grown_balls(const BallFamily& family, double growth) {
  std::vector<LongBall> out;
  const Long scale(family.scale());
  for (const FamilySlot row : slots_below<FamilySlot>(family.rows())) {
    if (!family.is_ball(row)) continue;
    LongBall ball;
    if (family.origin(row) == BallOrigin::circumdisk) {
      ball = circumdisk(family.corners(row));
    } else {
      const Disk disk = family.plain_disk(row);
      ball = {Long(disk.center.x), Long(disk.center.y), Long(disk.radius) * Long(disk.radius)};
    }
    ball.w = ball.w * scale * scale + Long(growth) * Long(growth);
    const Long tiny("1e-40");
    if (std::ranges::none_of(out, [&](const LongBall& other) {
          return abs(other.x - ball.x) < tiny && abs(other.y - ball.y) < tiny && abs(other.w - ball.w) < tiny;
        }))
      out.push_back(ball);
  }
  return out;
}

struct Free {
  double perimeter = 0.0;
  std::size_t arcs = 0;  ///< that turn by more than `kSeen`
};
constexpr double kSeen = 1e-7;

/// What the other balls leave of each circle.
Free free_of_all_pairs(const std::vector<LongBall>& balls) {
  Free out;
  const Long turn = 2 * boost::math::constants::pi<Long>();
  for (const LongBall& a : balls) {
    const Long r = sqrt(a.w);
    if (r == 0) continue;
    std::vector<std::pair<Long, Long>> covered;
    bool is_covered = false;
    for (const LongBall& b : balls) {
      if (&a == &b) continue;
      const Long x = b.x - a.x, y = b.y - a.y;
      const Long d = sqrt(x * x + y * y);
      if (d < Long("1e-40")) {
        is_covered = is_covered || a.w < b.w;
        continue;
      }
      const Long cosine = (d * d + a.w - b.w) / (2 * d * r);
      if (cosine > 1) continue;  // a circle that touches this one parts it
      if (cosine <= -1) {
        is_covered = true;
        break;
      }
      const Long half = acos(cosine);
      Long from = atan2(y, x) - half;
      if (from < 0) from += turn;
      if (from >= turn) from -= turn;
      covered.emplace_back(from, from + 2 * half);
    }
    if (is_covered) continue;
    const double radius = static_cast<double>(r);
    if (covered.empty()) {
      out.perimeter += radius * static_cast<double>(turn);
      ++out.arcs;
      continue;
    }
    std::ranges::sort(covered);
    // The part that reaches farthest may go on at the beginning of the circle.
    Long end = std::ranges::max(covered, {}, &std::pair<Long, Long>::second).second - turn;
    Long left = 0;
    for (const auto& [from, to] : covered) {
      const Long gap = from - end;
      end = std::max(end, to);
      if (gap <= 0) continue;
      left += gap;
      if (gap > kSeen) ++out.arcs;
    }
    out.perimeter += radius * static_cast<double>(left);
  }
  return out;
}

/// What a layer draws.
Free drawn(const TestBench& bench, const std::string& layer) {
  Free out;
  const auto row = bench.instances(layer, PrimitiveKind::arc);
  for (std::size_t at = 0; at < row.size(); at += stride_of(PrimitiveKind::arc)) {
    const double sweep =
        sweep_of({{row[at], row[at + 1]}, row[at + 2], {row[at + 3], row[at + 4]}, {row[at + 5], row[at + 6]}});
    out.perimeter += row[at + 2] * sweep;
    if (sweep > kSeen) ++out.arcs;
  }
  const auto circles = bench.instances(layer, PrimitiveKind::circle);
  for (std::size_t at = 0; at < circles.size(); at += stride_of(PrimitiveKind::circle)) {
    out.perimeter += 2.0 * std::numbers::pi * circles[at + 2];
    ++out.arcs;
  }
  return out;
}

void check(const TestBench& bench, const BallFiltration& filtration, const std::string& family, double growth) {
  INFO("family " << family << ", growth " << growth << ", scale " << filtration.family().scale());
  const Free wanted = free_of_all_pairs(grown_balls(filtration.family(), growth));
  const Free found = drawn(bench, family + "-alpha-boundary");
  // Ends of arcs are rounded to the coordinates of the document.
  CHECK(found.perimeter == Approx(wanted.perimeter).epsilon(1e-9));
  CHECK(found.arcs == wanted.arcs);
}

void check_samples(const std::vector<Vec2>& points, std::initializer_list<double> growths, double scale = 1.0) {
  TestBench bench(points);
  bench.show({"a-alpha-boundary", "p-alpha-boundary"});
  for (const double growth : growths) {
    ComputationSettings settings;
    settings[Parameter::alpha_radius] = growth;
    settings[Parameter::a_scale] = scale;
    settings[Parameter::p_scale] = scale;
    bench.choose(settings);
    check(bench, bench.get<ABallFiltration>(), "a", growth);
    check(bench, bench.get<PBallFiltration>(), "p", growth);
  }
}

void check_balls(const std::vector<Disk>& balls, std::initializer_list<double> growths) {
  SampleData data;
  data.balls = balls;
  TestBench bench;
  bench.load(data);
  bench.show({"b-alpha-boundary"});
  for (const double growth : growths) {
    ComputationSettings settings;
    settings[Parameter::alpha_radius] = growth;
    bench.choose(settings);
    check(bench, bench.get<BBallFiltration>(), "b", growth);
  }
}

std::vector<Vec2> turned(std::vector<Vec2> points, double angle, Vec2 by = {}) {
  for (Vec2& p : points)
    p = {by.x + std::cos(angle) * p.x - std::sin(angle) * p.y, by.y + std::sin(angle) * p.x + std::cos(angle) * p.y};
  return points;
}

/// Corners are arcs about (+-width, +-height); of a stadium one of the two is 0, of a circle both.
std::vector<Vec2> rounded_rectangle(double width, double height, double radius, int on_arc, int on_side) {
  std::vector<Vec2> out;
  for (int corner = 0; corner < 4; ++corner) {
    const Vec2 center{corner == 0 || corner == 3 ? width : -width, corner < 2 ? height : -height};
    const double begin = 0.5 * std::numbers::pi * corner;
    const bool is_joined = (corner % 2 == 0 ? width : height) == 0.0;
    for (int i = 0; i < on_arc + (is_joined ? 0 : 1); ++i) {
      const double angle = begin + 0.5 * std::numbers::pi * i / on_arc;
      out.push_back(center + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    if (is_joined) continue;
    const double side = corner % 2 == 0 ? width : height;
    const Vec2 along = corner == 0 ? Vec2{-1, 0} : corner == 1 ? Vec2{0, -1} : corner == 2 ? Vec2{1, 0} : Vec2{0, 1};
    const Vec2 last =
        center + radius * Vec2{std::cos(begin + 0.5 * std::numbers::pi), std::sin(begin + 0.5 * std::numbers::pi)};
    for (int i = 1; i < on_side; ++i) out.push_back(last + (2.0 * side * i / on_side) * along);
  }
  return out;
}

}  // namespace

TEST_CASE("samples on one circle have its boundary, whatever their centres are rounded to") {
  check_samples({{0.5000000000000001, -0.8660254037844386},
                 {0.8660254037844384, -0.5000000000000004},
                 {1, -2.4492935982947064e-16},
                 {0.8660254037844382, 0.5000000000000008},
                 {0.5000000000000012, 0.8660254037844379}},
                {0.0, 1e-9, 0.3, 5.0});
  for (const int count : {3, 4, 5, 7, 12, 24})
    for (const double turn : {0.0, 1.0})
      check_samples(turned(rounded_rectangle(0, 0, 1.5, count, 1), turn, {turn, 2.0 * turn}), {0.0, 0.3, 2.0});
}

TEST_CASE("shapes with circular arcs have the boundary of their grown balls") {
  Rng rng(51);
  for (int round = 0; round < 12; ++round) {
    const double width = round % 4 == 1 ? 0.0 : 0.2 + 2.0 * rng.uniform();
    const double height = round % 4 == 2 ? 0.0 : 0.2 + rng.uniform();
    const double radius = 0.3 + rng.uniform();
    const int on_arc = 3 + static_cast<int>(rng.below(9));
    const int on_side = 4 + static_cast<int>(rng.below(8));
    INFO("round " << round);
    check_samples(
        turned(rounded_rectangle(width, height, radius, on_arc, on_side), round % 3 == 0 ? 0.0 : rng.uniform(),
               round % 2 == 0 ? Vec2{} : Vec2{10.0 * rng.uniform(), 3.0}),
        {0.0, 1e-6, 0.1, 1.0}, round % 5 == 4 ? 1.1 : 1.0);
  }
}

TEST_CASE("user balls that nearly coincide have the boundary of their union") {
  Rng rng(52);
  for (int round = 0; round < 150; ++round) {
    std::vector<Disk> balls;
    const double apart = std::pow(10.0, -1.0 - static_cast<double>(rng.below(17)));
    const double differ = rng.below(3) == 0 ? 0.0 : apart * std::pow(10.0, static_cast<double>(rng.below(3)) - 1.0);
    const std::size_t count = 2 + rng.below(7);
    for (std::size_t i = 0; i < count; ++i)
      balls.push_back({{0.3 + apart * (rng.uniform() - 0.5), -0.7 + apart * (rng.uniform() - 0.5)},
                       1.0 + differ * (rng.uniform() - 0.5)});
    // Some of them twice, and one beside that reaches in.
    if (round % 3 == 0) balls.push_back(balls[0]);
    if (round % 4 == 0) balls.push_back({{1.1, -0.2}, 0.6});
    INFO("round " << round << ", " << apart << " apart, radii differ by " << differ);
    check_balls(balls, {0.0, 1e-3, 0.7});
  }
}

TEST_CASE("user balls that touch have the boundary of their union, at that growth and beside it") {
  const std::vector<Disk> row{{{0, 0}, 1}, {{2, 0}, 1}, {{5, 0}, 2}, {{5, 3}, 1}};
  check_balls(row, {0.0, 0x1p-40, 0x1p-20, 1.0});
  // From inside: the smaller ball comes out when both have grown.
  check_balls({{{0, 0}, 5}, {{4, 0}, 1}}, {0.0, 0x1p-30, 1.0});
  check_balls({{{0, 0}, 5}, {{3, 4}, 0}}, {0.0, 0x1p-30, 1.0});
  // Lattices of balls, at the growth at which neighbours touch, and just below and above.
  for (const double radius : {0.0, 0.3}) {
    std::vector<Disk> lattice;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) lattice.push_back({{i + (j % 2 == 0 ? 0.0 : 0.5), j * 0.75}, radius});
    const double tie = std::sqrt(0.25 - radius * radius);
    check_balls(lattice, {0.0, tie * (1 - 1e-9), std::nextafter(tie, 0.0), tie, std::nextafter(tie, 1.0),
                          tie * (1 + 1e-9), 0.45, 0.6});
  }
}

TEST_CASE("random balls of all sizes have the boundary of their union") {
  Rng rng(53);
  for (int round = 0; round < 20; ++round) {
    std::vector<Disk> balls;
    for (std::size_t i = 0; i < 12 + rng.below(20); ++i)
      balls.push_back({{10.0 * rng.uniform(), 10.0 * rng.uniform()}, std::pow(10.0, 1.5 * rng.uniform() - 1.0)});
    INFO("round " << round);
    check_balls(balls, {0.0, 0.1, 1.0, 4.0});
  }
}
