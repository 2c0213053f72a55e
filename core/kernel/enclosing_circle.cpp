// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/enclosing_circle.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/kernel/internal/vector_of.h"

namespace mes {
namespace {

using Rational = CGAL::Exact_rational;

using RationalVector = VectorOf<Rational>;

Rational squared_length(const RationalVector& v) {
  return dot_of(v, v);
}

int order(const Rational& a, const Rational& b) {
  return a < b ? -1 : (b < a ? 1 : 0);
}

/// True if the corner at p has 90 degrees or more.
bool is_wide(Vec2 p, Vec2 q, Vec2 r) {
  return sign_of_corner(p, q, r) <= 0;
}

}  // namespace

int sign_of_corner(Vec2 p, Vec2 q, Vec2 r) {
  const Vec2 u = q - p;
  const Vec2 v = r - p;
  const double value = dot(u, v);
  const double size = std::abs(u.x * v.x) + std::abs(u.y * v.y);
  // Differences, products and the sum round once each.
  if (size > 1e-280 && size < 1e300 && std::abs(value) > 0x1p-49 * size) return value < 0.0 ? -1 : 1;
  const RationalVector exact_u = vector_between<Rational>(p, q);
  const RationalVector exact_v = vector_between<Rational>(p, r);
  return order(dot_of(exact_u, exact_v), Rational(0));
}

bool is_right_or_obtuse(Vec2 a, Vec2 b, Vec2 c) {
  return is_wide(a, b, c) || is_wide(b, c, a) || is_wide(c, a, b);
}

double half_longest_side(Vec2 a, Vec2 b, Vec2 c) {
  return 0.5 * std::max({distance(a, b), distance(b, c), distance(c, a)});
}

int compare_half_distance_exactly(Vec2 a, Vec2 b, double r) {
  if (r < 0.0) return 1;
  return order(squared_length(vector_between<Rational>(a, b)), Rational(4) * Rational(r) * Rational(r));
}

int compare_enclosing_radius(Vec2 a, Vec2 b, Vec2 c, double r) {
  if (r < 0.0) return 1;
  // The radius is at least half the longest side. It is at most that side / sqrt(3), as in an equilateral triangle:
  // where all angles are below 90 degrees, the longest side is opposite one of 60 or more.
  const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  const double right = 4.0 * r * r;
  if (longest > right && is_order_decided(longest, right)) return 1;
  if (longest < 0.75 * right && is_order_decided(longest, 0.75 * right)) return -1;
  if (is_wide(a, b, c)) return compare_half_distance(b, c, r);
  if (is_wide(b, c, a)) return compare_half_distance(c, a, r);
  if (is_wide(c, a, b)) return compare_half_distance(a, b, r);
  // All angles are below 90 degrees, so the largest is 60 degrees or more: seen from its corner, the determinant is not
  // small against its terms.
  std::array<Vec2, 3> corner{a, b, c};
  const auto opposite = [&](std::size_t i) {
    const Vec2 side = corner[(i + 2) % 3] - corner[(i + 1) % 3];
    return dot(side, side);
  };
  std::size_t top = opposite(1) > opposite(0) ? 1 : 0;
  if (opposite(2) > opposite(top)) top = 2;
  const Vec2 u = corner[(top + 1) % 3] - corner[top];
  const Vec2 v = corner[(top + 2) % 3] - corner[top];
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double area = cross(u, v);
  // R^2 is |u|^2 |v|^2 |w|^2 / 4 area^2; dividing factor by factor keeps the products in range.
  const double left = (uu / area) * (vv / area) * opposite(top);
  if (std::min(uu, vv) > 1e-250 && is_order_decided(left, right)) return left < right ? -1 : 1;
  const RationalVector p = vector_between<Rational>(a, b);
  const RationalVector q = vector_between<Rational>(a, c);
  const Rational det = cross_of(p, q);
  return order(squared_length(p) * squared_length(q) * squared_length(vector_between<Rational>(b, c)),
               Rational(4) * det * det * Rational(r) * Rational(r));
}

}  // namespace mes
