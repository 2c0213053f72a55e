// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/circle_order.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/geometry/coordinate_range.h"
#include "core/base/jobs/parallel.h"

namespace mes {
namespace {

using Rational = CGAL::Exact_rational;

/// Returns the difference of two doubles; clears `is_exact` if it is rounded.
double difference(double a, double b, bool& is_exact) {
  const double d = a - b;
  const double part = d - a;
  is_exact = is_exact && (a - (d - part)) - (b + part) == 0.0;
  return d;
}
/// Squared length; clears `is_exact` if it is rounded. Not for values near the ends of the range of doubles.
double squared_in_doubles(Vec2 v, bool& is_exact) {
  const double x = v.x * v.x;
  const double y = v.y * v.y;
  const double sum = x + y;
  const double part = sum - x;
  is_exact = is_exact && std::fma(v.x, v.x, -x) == 0.0 && std::fma(v.y, v.y, -y) == 0.0 &&
             (x - (sum - part)) + (y - part) == 0.0;
  return sum;
}

Rational squared_distance(Vec2 p, Vec2 q) {
  const Rational x = Rational(q.x) - Rational(p.x);
  const Rational y = Rational(q.y) - Rational(p.y);
  return x * x + y * y;
}

// For corners as vectors, R = |ab| |bc| |ca| / 2 |det(b - a, c - a)|.
Rational exact_square(const SpannedCircle& circle) {
  if (!circle.has_third) return squared_distance(circle.a, circle.b) / Rational(4);
  const Rational ux = Rational(circle.b.x) - Rational(circle.a.x);
  const Rational uy = Rational(circle.b.y) - Rational(circle.a.y);
  const Rational vx = Rational(circle.c.x) - Rational(circle.a.x);
  const Rational vy = Rational(circle.c.y) - Rational(circle.a.y);
  const Rational det = ux * vy - uy * vx;
  return (ux * ux + uy * uy) * (vx * vx + vy * vy) * squared_distance(circle.b, circle.c) / (Rational(4) * det * det);
}

/// The squared radius, and an interval that holds it.
struct Measure {
  double low = 0.0;
  double high = 0.0;
  double square = 0.0;
  std::array<double, 3> sides{};  ///< squared side lengths, ascending; missing ones are 0
  bool has_sides = false;         ///< `sides` are exact
};

// Sorts the corners lexicographically, so that rounding does not depend on their order.
std::array<Vec2, 3> sorted_corners(const SpannedCircle& circle) {
  std::array<Vec2, 3> out{circle.a, circle.b, circle.c};
  std::sort(out.begin(), out.begin() + (circle.has_third ? 3 : 2), lexicographically_less);
  return out;
}

Measure measure(const SpannedCircle& circle) {
  // Differences, products and sums round once each; 2^-50 is several times the accumulated error.
  constexpr double kOfSquares = 0x1p-48;
  constexpr double kOfArea = 0x1p-50;
  constexpr double kTooFlat = 0x1p-36;
  const auto p = sorted_corners(circle);
  Measure out;
  out.has_sides = true;
  const auto side = [&](std::size_t from, std::size_t to) {
    return Vec2{difference(p[to].x, p[from].x, out.has_sides), difference(p[to].y, p[from].y, out.has_sides)};
  };
  double error = kOfSquares;
  if (!circle.has_third) {
    const double ab = squared_in_doubles(side(0, 1), out.has_sides);
    out.square = 0.25 * ab;
    out.sides = {0.0, 0.0, ab};
  } else {
    // Seen from the corner opposite the longest side, the determinant has the smallest terms.
    std::array<double, 3> opposite{};
    for (std::size_t i = 0; i < 3; ++i)
      opposite[i] = squared_in_doubles(side((i + 1) % 3, (i + 2) % 3), out.has_sides);
    std::size_t top = opposite[1] > opposite[0] ? 1 : 0;
    if (opposite[2] > opposite[top]) top = 2;
    const Vec2 u = p[(top + 1) % 3] - p[top];
    const Vec2 v = p[(top + 2) % 3] - p[top];
    const double area = std::abs(cross(u, v));
    const double terms = std::abs(u.x * v.y) + std::abs(u.y * v.x);
    out.sides = opposite;
    std::ranges::sort(out.sides);
    if (area * kTooFlat > terms * kOfArea) {
      const double uncertain = kOfArea * (terms / area);
      out.square = (out.sides[0] / area) * (out.sides[1] / area) * (0.25 * out.sides[2]);
      error += 2.5 * uncertain;
    } else {
      out.square = CGAL::to_double(exact_square(circle));
    }
  }
  out.low = out.square * (1.0 - error);
  out.high = out.square * (1.0 + error);
  return out;
}

/// The power of two that brings the largest coordinate between 1 and 2; squares and products of coordinates in the
/// allowed range are then normal doubles.
double unit_of(std::span<const SpannedCircle> circles) {
  double most = 0.0;
  for (const SpannedCircle& circle : circles)
    for (const Vec2 p : {circle.a, circle.b, circle.has_third ? circle.c : circle.a})
      most = std::max({most, std::abs(p.x), std::abs(p.y)});
  return most > 0.0 ? std::ldexp(1.0, -exponent_of(most)) : 1.0;
}

SpannedCircle scaled(const SpannedCircle& circle, double unit) {
  return {unit * circle.a, unit * circle.b, unit * circle.c, circle.has_third};
}

/// Ranks circles with overlapping intervals, from 0 on.
class CloseRadii {
 public:
  CloseRadii(std::span<const SpannedCircle> circles, std::span<const Measure> measures, double unit)
      : circles_(circles), measures_(measures), unit_(unit) {}

  /// Calls `give(circle, rank)` for each circle and returns the number of ranks.
  template <class Give>
  std::uint32_t rank(std::span<const std::uint32_t> run, const std::function<void()>& checkpoint, Give give) {
    // Circles with the same exact sides have the same radius.
    entries_.assign(run.begin(), run.end());
    std::ranges::sort(entries_, [this](std::uint32_t a, std::uint32_t b) { return comes_before(a, b); });
    groups_.clear();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (i != 0 && !comes_before(entries_[i - 1], entries_[i]) && measures_[entries_[i]].has_sides) continue;
      groups_.push_back({i, exact_square(scaled(circles_[entries_[i]], unit_))});
      if (groups_.size() % 256 == 0) checkpoint();
    }
    order_.resize(groups_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::size_t looks = 0;
    std::ranges::sort(order_, [&](std::size_t a, std::size_t b) {
      if (++looks % 1024 == 0) checkpoint();
      return groups_[a].square < groups_[b].square;
    });
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i != 0 && groups_[order_[i - 1]].square != groups_[order_[i]].square) ++rank;
      const std::size_t group = order_[i];
      const std::size_t end = group + 1 < groups_.size() ? groups_[group + 1].begin : entries_.size();
      for (std::size_t at = groups_[group].begin; at < end; ++at) give(entries_[at], rank);
    }
    return rank + 1;
  }

 private:
  struct Group {
    std::size_t begin = 0;  ///< index of its first entry
    Rational square;
  };
  /// Circles without exact sides come last, in any order.
  bool comes_before(std::uint32_t a, std::uint32_t b) const {
    const Measure& x = measures_[a];
    const Measure& y = measures_[b];
    if (x.has_sides != y.has_sides) return x.has_sides;
    return x.has_sides && x.sides < y.sides;
  }

  std::span<const SpannedCircle> circles_;
  std::span<const Measure> measures_;
  double unit_;
  std::vector<std::uint32_t> entries_;
  std::vector<Group> groups_;
  std::vector<std::size_t> order_;
};

}  // namespace

RadiusRanks rank_radii(std::span<const SpannedCircle> circles, const std::function<void()>& checkpoint) {
  const double unit = unit_of(circles);
  std::vector<Measure> measures(circles.size());
  parallel_for(circles.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) measures[i] = measure(scaled(circles[i], unit));
  });
  checkpoint();
  struct Key {
    double low = 0.0;
    std::uint32_t circle = 0;
  };
  std::vector<Key> keys(circles.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = {measures[i].low, static_cast<std::uint32_t>(i)};
  std::ranges::sort(keys, {}, &Key::low);
  checkpoint();

  RadiusRanks out;
  out.rank.resize(circles.size());
  std::vector<std::uint32_t> one_of;  // one circle of each rank
  const auto give = [&](std::uint32_t circle, std::uint32_t rank) {
    out.rank[circle] = rank;
    if (rank == one_of.size()) one_of.push_back(circle);
  };
  CloseRadii close(circles, measures, unit);
  std::vector<std::uint32_t> run;
  for (std::size_t begin = 0; begin < keys.size();) {
    double high = measures[keys[begin].circle].high;
    std::size_t end = begin + 1;
    for (; end < keys.size() && keys[end].low <= high; ++end) high = std::max(high, measures[keys[end].circle].high);
    const auto first = static_cast<std::uint32_t>(one_of.size());
    if (end - begin == 1) {
      give(keys[begin].circle, first);
    } else {
      run.clear();
      for (std::size_t i = begin; i < end; ++i) run.push_back(keys[i].circle);
      close.rank(run, checkpoint, [&](std::uint32_t circle, std::uint32_t rank) { give(circle, first + rank); });
    }
    begin = end;
  }
  checkpoint();
  out.radius.resize(one_of.size());
  constexpr std::size_t kLook = 0x10000;  // radii between two checkpoints
  for (std::size_t first = 0; first < one_of.size(); first += kLook) {
    parallel_for(std::min(kLook, one_of.size() - first), [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = first + begin; i < first + end; ++i) out.radius[i] = radius_above(circles[one_of[i]]);
    });
    checkpoint();
  }
  return out;
}

bool sees_wide(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 u = a - p;
  const Vec2 v = b - p;
  const double value = dot(u, v);
  const double size = std::abs(u.x * v.x) + std::abs(u.y * v.y);
  // Differences, products and the sum round once each.
  if (size > 1e-280 && size < 1e300 && std::abs(value) > 0x1p-49 * size) return value < 0.0;
  const auto minus = [](double x, double y) { return Rational(x) - Rational(y); };
  return minus(a.x, p.x) * minus(b.x, p.x) + minus(a.y, p.y) * minus(b.y, p.y) <= 0;
}

namespace {

/// The squared radius and its error bound, in the machine's extended precision. Where that has longer exponents than
/// doubles, no double in the range of coordinates is too large or too small for it.
struct FineMeasure {
  long double square = 0.0L;
  long double error = 0.0L;  ///< relative; infinite where nothing is known
};

FineMeasure fine_measure(const SpannedCircle& circle) {
  using Limits = std::numeric_limits<long double>;
  constexpr long double kUnit = Limits::epsilon();  // twice the error of one operation
  const auto p = sorted_corners(circle);
  const auto side = [&](std::size_t from, std::size_t to) {
    return std::array{static_cast<long double>(p[to].x) - p[from].x, static_cast<long double>(p[to].y) - p[from].y};
  };
  const auto squared_length = [](const std::array<long double, 2>& v) { return v[0] * v[0] + v[1] * v[1]; };
  if (!circle.has_third) return {0.25L * squared_length(side(0, 1)), 4 * kUnit};
  std::array<long double, 3> opposite{};
  for (std::size_t i = 0; i < 3; ++i) opposite[i] = squared_length(side((i + 1) % 3, (i + 2) % 3));
  std::size_t top = opposite[1] > opposite[0] ? 1 : 0;
  if (opposite[2] > opposite[top]) top = 2;
  const auto u = side(top, (top + 1) % 3);
  const auto v = side(top, (top + 2) % 3);
  const long double area = std::abs(u[0] * v[1] - u[1] * v[0]);
  const long double terms = std::abs(u[0] * v[1]) + std::abs(u[1] * v[0]);
  const long double uncertain = 4 * kUnit * (terms / area);
  if (!(uncertain < 0x1p-8L)) return {0.0L, Limits::infinity()};
  return {(opposite[0] / area) * (opposite[1] / area) * (0.25L * opposite[2]), 16 * kUnit + 4 * uncertain};
}

/// Compares exactly, in rationals.
int compare_with_rationals(const SpannedCircle& circle, double r) {
  const Rational exact = exact_square(circle);
  const Rational wanted = Rational(r) * Rational(r);
  return exact < wanted ? -1 : (wanted < exact ? 1 : 0);
}

/// Takes a circle scaled near 1, whose squares are far from the ends of the range of doubles.
int compare_near_one(const SpannedCircle& circle, const FineMeasure& fine, double r) {
  const long double wanted = static_cast<long double>(r) * r;
  const long double apart = fine.square - wanted;
  const long double margin = fine.square * (fine.error + 4 * std::numeric_limits<long double>::epsilon());
  if (std::abs(apart) > margin) return apart > 0.0L ? 1 : -1;
  return compare_with_rationals(circle, r);
}

}  // namespace

double radius_above(const SpannedCircle& circle) {
  const double unit = unit_of({&circle, 1});
  const SpannedCircle here = scaled(circle, unit);
  FineMeasure fine = fine_measure(here);
  // The search below steps from double to double, in rationals where the error exceeds their spacing.
  if (!(fine.error < 0x1p-50L)) {
    fine = {static_cast<long double>(CGAL::to_double(exact_square(here))), 0x1p-50L};
  }
  const double infinity = std::numeric_limits<double>::infinity();
  auto out = static_cast<double>(std::sqrt(fine.square));
  while (compare_near_one(here, fine, out) > 0) out = std::nextafter(out, infinity);
  for (;;) {
    const double below = std::nextafter(out, 0.0);
    if (compare_near_one(here, fine, below) > 0) return out / unit;
    out = below;
  }
}

}  // namespace mes
