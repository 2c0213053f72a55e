// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shapes/shapes_degenerate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/rng.h"

namespace mes::test {
namespace {

using Count = std::optional<std::size_t>;

/// Fills in the facts that can be counted.
DegenerateInput input(std::string name, std::vector<Vec2> positions, Count crust_edges = {}, Count odd = {}) {
  std::vector<Vec2> sorted = positions;
  std::sort(sorted.begin(), sorted.end(), lexicographically_less);
  const auto end = std::unique(sorted.begin(), sorted.end());
  DegenerateInput made;
  made.name = std::move(name);
  made.positions = std::move(positions);
  made.distinct = static_cast<std::size_t>(end - sorted.begin());
  made.crust_edges = crust_edges;
  made.odd_samples = odd;
  return made;
}

std::vector<Vec2> on_line(Vec2 step, std::size_t n) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(static_cast<double>(i) * step);
  return points;
}

/// A dozen points of a bent closed curve, by integers below 64; crust and hull are ordinary.
std::vector<Vec2> small_curve() {
  return {{0, 0},   {10, -2}, {20, -3}, {30, -2}, {40, 0}, {45, 7},
          {40, 14}, {30, 16}, {20, 15}, {10, 16}, {0, 14}, {-5, 7}};
}

std::vector<Vec2> transformed(std::vector<Vec2> points, double scale, Vec2 offset) {
  for (Vec2& p : points) p = scale * p + offset;
  return points;
}

std::vector<Vec2> repeated(const std::vector<Vec2>& points, std::size_t times) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < times; ++i) out.insert(out.end(), points.begin(), points.end());
  return out;
}

}  // namespace

DegenerateInput integer_lattice(std::size_t k) {
  MES_ASSERT(k >= 2);
  std::vector<Vec2> points;
  for (std::size_t y = 0; y < k; ++y)
    for (std::size_t x = 0; x < k; ++x) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return input("lattice " + std::to_string(k) + " x " + std::to_string(k), std::move(points), 2 * k * (k - 1),
               4 * (k - 2));
}

DegenerateInput lattice_circle() {
  std::vector<Vec2> points;
  for (int x = -65; x <= 65; ++x)
    for (int y = -65; y <= 65; ++y)
      if (x * x + y * y == 65 * 65) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) {
    const bool a_is_lower = a.y < 0.0 || (a.y == 0.0 && a.x < 0.0);
    const bool b_is_lower = b.y < 0.0 || (b.y == 0.0 && b.x < 0.0);
    return a_is_lower != b_is_lower ? b_is_lower : cross(a, b) > 0.0;
  });
  return input("lattice circle", std::move(points), 36, 0);
}

DegenerateInput foreign_crossing(int number) {
  MES_ASSERT(number >= 1 && number <= 3);
  std::vector<Vec2> points;
  if (number == 1) points = {{4, 3}, {5, 38}, {6, 16}, {16, 35}, {22, 16}, {23, 29}, {24, 3}};
  if (number == 2) points = {{9, 8}, {10, 32}, {13, 35}, {20, 0}, {30, 6}, {39, 15}};
  if (number == 3)
    points = {{3, 9}, {4, 28}, {4, 35}, {12, 0}, {15, 18}, {17, 23}, {21, 12}, {21, 39}, {24, 13}, {27, 6}};
  const std::size_t n = points.size();
  return input("foreign crossing " + std::to_string(number), std::move(points), n, 0);
}

std::vector<DegenerateInput> degenerate_inputs() {
  std::vector<DegenerateInput> all;
  all.push_back(input("no point", {}, 0, 0));
  all.push_back(input("one point", {{3, 4}}, 0, 0));
  all.push_back(input("two points", {{0, 0}, {3, 4}}, 1, 2));
  all.push_back(input("acute triangle", {{0, 0}, {4, 0}, {2, 3}}, 3, 0));
  // The opposite angle of the hypotenuse is a right angle: a tie, and ties are crust.
  all.push_back(input("right triangle", {{0, 0}, {4, 0}, {0, 3}}, 3, 0));
  all.push_back(input("obtuse triangle", {{0, 0}, {4, 0}, {2, 1}}, 2, 2));
  all.push_back(input("flat triangle", {{0, 0}, {1, 0}, {0.5, 0x1p-80}}, 2, 2));
  all.push_back(input("square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 4, 0));

  // On a line the sides have opposite angles of 0: neighbours are crust, and the two ends are odd.
  all.push_back(input("horizontal line", on_line({1, 0}, 9), 8, 2));
  all.push_back(input("vertical line", on_line({0, 1}, 9), 8, 2));
  all.push_back(input("slanted line", on_line({3, 2}, 9), 8, 2));
  all.push_back(input("slanted line in tenths", on_line({0.1, 0.3}, 9)));
  std::vector<Vec2> line_and_point = on_line({1, 0}, 9);
  line_and_point.push_back({4, 7});
  all.push_back(input("line and one point", std::move(line_and_point)));

  for (std::size_t k = 3; k <= 6; ++k) all.push_back(integer_lattice(k));
  all.push_back(lattice_circle());
  std::vector<Vec2> with_center = lattice_circle().positions;
  with_center.push_back({0, 0});
  all.push_back(input("lattice circle and centre", std::move(with_center)));

  all.push_back(input("one place twenty times", repeated({{1, 2}}, 20), 0, 0));
  all.push_back(input("two places ten times", repeated({{0, 0}, {3, 4}}, 10), 1, 2));
  all.push_back(input("small curve", small_curve(), 12, 0));
  all.push_back(input("small curve three times", repeated(small_curve(), 3), 12, 0));
  all.push_back(input("zeros of both signs", {{0.0, 0.0}, {-0.0, 1.0}, {1.0, -0.0}, {-0.0, -0.0}}, 3, 0));

  for (const double scale : {0x1p-480, 0x1p-400, 0x1p400, 0x1p490})
    all.push_back(input("small curve times 2^" + std::to_string(std::ilogb(scale)),
                        transformed(small_curve(), scale, {}), 12, 0));
  all.push_back(input("small curve at 1e15", transformed(small_curve(), 1.0, {1e15, -1e15}), 12, 0));
  all.push_back(input("small curve in last bits at 2^52", transformed(small_curve(), 1.0, {0x1p52, 0x1p52}), 12, 0));

  std::vector<Vec2> spread;
  for (int exponent = -15; exponent <= 15; ++exponent)
    spread.push_back({std::pow(10.0, exponent), std::pow(10.0, -exponent)});
  all.push_back(input("1e-15 to 1e15 in one set", std::move(spread)));
  constexpr double kLargest = 0x1.fffffffffffffp499;
  all.push_back(
      input("the largest numbers",
            {{kLargest, kLargest}, {-kLargest, kLargest}, {-kLargest, -kLargest}, {kLargest, -kLargest}, {0, 0}}));

  // Nearly cocircular points, which only exact arithmetic can decide; filters cannot.
  std::vector<Vec2> nearly = lattice_circle().positions;
  for (std::size_t i = 0; i < nearly.size(); i += 2) nearly[i].x = std::nextafter(nearly[i].x, 1e9);
  all.push_back(input("circle off by a last bit", std::move(nearly), 36, 0));
  Rng random(7);
  std::vector<Vec2> grid_draws;
  for (int i = 0; i < 200; ++i)
    grid_draws.push_back({static_cast<double>(random.below(12)), static_cast<double>(random.below(12))});
  all.push_back(input("draws from a 12 x 12 grid", std::move(grid_draws)));

  for (int number = 1; number <= 3; ++number) all.push_back(foreign_crossing(number));
  return all;
}

}  // namespace mes::test
