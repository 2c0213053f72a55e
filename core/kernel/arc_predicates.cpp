// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/arc_predicates.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>

#include "core/base/power_of_two.h"

namespace mes {
namespace {

using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

// `Bounded` is an interval given by its middle and radius: it works in any rounding mode and is cheaper. Each bound is
// the sum of the operands' bounds, a unit in the last place and the loss below the smallest double. These sums round,
// too, which `kMore` makes up for.
constexpr double kPlace = 0x1p-52;
constexpr double kMore = 1.0 + 0x1p-48;
constexpr double kTiny = 0x1p-1070;

[[gnu::always_inline]] inline Bounded bounded(double value, double error) {
  return {value, (error + kPlace * std::abs(value)) * kMore};
}
[[gnu::always_inline]] inline Bounded operator-(const Bounded& a) {
  return {-a.value, a.error};
}
[[gnu::always_inline]] inline Bounded operator+(const Bounded& a, const Bounded& b) {
  return bounded(a.value + b.value, a.error + b.error);
}
[[gnu::always_inline]] inline Bounded operator-(const Bounded& a, const Bounded& b) {
  return bounded(a.value - b.value, a.error + b.error);
}
[[gnu::always_inline]] inline Bounded operator*(const Bounded& a, const Bounded& b) {
  return bounded(a.value * b.value, std::abs(a.value) * b.error + a.error * (std::abs(b.value) + b.error) + kTiny);
}
[[gnu::always_inline]] inline Bounded operator/(const Bounded& a, const Bounded& b) {
  const double least = (std::abs(b.value) - b.error) * (1.0 - 0x1p-48);
  const double value = a.value / b.value;
  if (!(least > 0.0)) return {value, std::numeric_limits<double>::infinity()};
  return bounded(value, (a.error + (std::abs(value) + kTiny) * b.error + kTiny) / least + kTiny);
}
[[gnu::always_inline]] inline bool is_surely_positive(const Bounded& x) {
  return x.value > x.error;
}

template <class Number>
struct Vector {
  Number x, y;
};
template <class Number>
Vector<Number> between(Vec2 from, Vec2 to) {
  return {Number{to.x} - Number{from.x}, Number{to.y} - Number{from.y}};
}
template <class Number>
Number cross_product(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.y - u.y * v.x;
}
template <class Number>
Number dot_product(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.x + u.y * v.y;
}
/// Vector from `a` to the circumcentre of a, b, c.
template <class Number>
Vector<Number> to_center(Vec2 a, Vec2 b, Vec2 c) {
  const Vector<Number> u = between<Number>(a, b);
  const Vector<Number> v = between<Number>(a, c);
  const Number uu = dot_product(u, u);
  const Number vv = dot_product(v, v);
  const Number twice = Number{2.0} * cross_product(u, v);
  return {(v.y * uu - u.y * vv) / twice, (u.x * vv - v.x * uu) / twice};
}

// Returns -1, 0 or 1, or nothing where the sign is not known.
std::optional<int> known_sign(const Interval& x) {
  if (x.inf() > 0.0) return 1;
  if (x.sup() < 0.0) return -1;
  if (x.inf() == 0.0 && x.sup() == 0.0) return 0;
  return std::nullopt;
}
std::optional<int> known_sign(const Rational& x) {
  return static_cast<int>(CGAL::sign(x));
}

// Three-valued logic: a sign that is not known makes the answer `unsure` unless the other part settles it.
template <class Number>
Meets points_into_arc(const Vector<Number>& p, const Vector<Number>& q, const Vector<Number>& direction) {
  const auto turn = known_sign(cross_product(p, q));
  const auto after_p = known_sign(cross_product(p, direction));
  const auto before_q = known_sign(cross_product(direction, q));
  if (!turn) return Meets::unsure;
  if (*turn > 0) {
    if ((after_p && *after_p <= 0) || (before_q && *before_q <= 0)) return Meets::no;
    return after_p && before_q ? Meets::yes : Meets::unsure;
  }
  // The arc is a half circle or more: the direction is outside of it when it is in the closed cone from q to p.
  if ((after_p && *after_p > 0) || (before_q && *before_q > 0)) return Meets::yes;
  return after_p && before_q ? Meets::no : Meets::unsure;
}

template <class Number>
Meets decide(const OuterArc& arc, const Corners& disk) {
  const Vector<Number> from_p = to_center<Number>(arc.p, arc.q, arc.s);
  const Vector<Number> from_a = to_center<Number>(disk.a, disk.b, disk.c);
  const Vector<Number> pa = between<Number>(arc.p, disk.a);
  const Vector<Number> pq = between<Number>(arc.p, arc.q);
  const Vector<Number> direction{pa.x + from_a.x - from_p.x, pa.y + from_a.y - from_p.y};
  const Vector<Number> p{-from_p.x, -from_p.y};
  const Vector<Number> q{pq.x - from_p.x, pq.y - from_p.y};
  const Meets points = points_into_arc(p, q, direction);
  if (points == Meets::no) return Meets::no;
  const Number own = dot_product(from_p, from_p);
  const Number other = dot_product(from_a, from_a);
  const Number gap = dot_product(direction, direction) - own - other;
  const auto apart = known_sign(gap);
  if (apart && *apart <= 0) return points;
  const auto beyond = known_sign(gap * gap - Number(4) * own * other);
  if (beyond && *beyond > 0) {
    if (apart) return Meets::no;
    return Meets::unsure;
  }
  return beyond ? points : Meets::unsure;
}

// The farthest point of the circle beyond u -> v must be on the arc and beyond the line.
template <class Number>
Meets decide(const OuterArc& arc, Vec2 u, Vec2 v) {
  const Vector<Number> from_p = to_center<Number>(arc.p, arc.q, arc.s);
  const Vector<Number> pq = between<Number>(arc.p, arc.q);
  const Vector<Number> uv = between<Number>(u, v);
  const Vector<Number> up = between<Number>(u, arc.p);
  const Meets points = points_into_arc(Vector<Number>{-from_p.x, -from_p.y},
                                       Vector<Number>{pq.x - from_p.x, pq.y - from_p.y}, Vector<Number>{-uv.y, uv.x});
  if (points == Meets::no) return Meets::no;
  const Number height = cross_product(uv, Vector<Number>{up.x + from_p.x, up.y + from_p.y});
  const auto side = known_sign(height);
  if (side && *side >= 0) return points;
  const auto reach = known_sign(dot_product(from_p, from_p) * dot_product(uv, uv) - height * height);
  if (reach && *reach <= 0) return side ? Meets::no : Meets::unsure;
  return reach ? points : Meets::unsure;
}

Vec2 in_unit(Vec2 p, int exponent) {
  return {times_power_of_two(p.x, exponent), times_power_of_two(p.y, exponent)};
}

// The predicates have degree eight in coordinates, so their values leave the range of doubles long before coordinates
// do. Returns the power of two that brings the largest coordinate near 1, or 0 if scaling is not needed or not exact.
int exponent_to_unit(std::initializer_list<Vec2> points) {
  constexpr double kLarge = 0x1p100;
  constexpr double kSmall = 0x1p-100;
  double largest = 0.0;
  for (const Vec2 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  if ((largest < kLarge && largest > kSmall) || largest == 0.0 || !std::isfinite(largest)) return 0;
  const int exponent = -std::ilogb(largest);
  const auto is_exact = [exponent](double x) {
    return times_power_of_two(times_power_of_two(x, exponent), -exponent) == x;
  };
  for (const Vec2 p : points)
    if (!is_exact(p.x) || !is_exact(p.y)) return 0;
  return exponent;
}

}  // namespace

// The centre of the arc's circle is stored relative to the arc's start.
ArcFilter::ArcFilter(const OuterArc& arc) : start_(arc.p) {
  const Vector<Bounded> from_p = to_center<Bounded>(arc.p, arc.q, arc.s);
  const Vector<Bounded> pq = between<Bounded>(arc.p, arc.q);
  from_start_[0] = from_p.x;
  from_start_[1] = from_p.y;
  to_start_[0] = -from_p.x;
  to_start_[1] = -from_p.y;
  to_end_[0] = pq.x - from_p.x;
  to_end_[1] = pq.y - from_p.y;
  const Bounded turn = cross_product<Bounded>({to_start_[0], to_start_[1]}, {to_end_[0], to_end_[1]});
  is_narrow_ = is_surely_positive(turn);
  is_wide_ = is_surely_positive(-turn);
}

// Multiplying the direction by the determinant of the disk's corners, which is positive, avoids a division.
bool ArcFilter::misses(const Corners& disk) const {
  const Vector<Bounded> u = between<Bounded>(disk.a, disk.b);
  const Vector<Bounded> v = between<Bounded>(disk.a, disk.c);
  const Bounded uu = dot_product(u, u);
  const Bounded vv = dot_product(v, v);
  const Bounded cross = cross_product(u, v);
  if (!is_surely_positive(cross)) return false;
  const Bounded twice{2.0 * cross.value, 2.0 * cross.error};
  const Vector<Bounded> pa = between<Bounded>(start_, disk.a);
  const Vector<Bounded> direction{(pa.x - from_start_[0]) * twice + (v.y * uu - u.y * vv),
                                  (pa.y - from_start_[1]) * twice + (u.x * vv - v.x * uu)};
  const Vector<Bounded> p{to_start_[0], to_start_[1]};
  const Vector<Bounded> q{to_end_[0], to_end_[1]};
  const bool before_p = is_surely_positive(cross_product(direction, p));
  const bool after_q = is_surely_positive(cross_product(q, direction));
  // An arc of half a circle or more is missed only between its end and its start.
  return is_narrow_ ? before_p || after_q : is_wide_ && before_p && after_q;
}

Meets meets_arc_quickly(const OuterArc& arc, const Corners& disk) {
  CGAL::Protect_FPU_rounding<true> rounding;
  const int exponent = exponent_to_unit({arc.s, arc.p, arc.q, disk.a, disk.b, disk.c});
  if (exponent == 0) return decide<Interval>(arc, disk);
  const auto scaled = [exponent](Vec2 p) { return in_unit(p, exponent); };
  return decide<Interval>(OuterArc{scaled(arc.s), scaled(arc.p), scaled(arc.q)},
                          Corners{scaled(disk.a), scaled(disk.b), scaled(disk.c)});
}

Meets meets_arc_quickly(const OuterArc& arc, Vec2 u, Vec2 v) {
  CGAL::Protect_FPU_rounding<true> rounding;
  const int exponent = exponent_to_unit({arc.s, arc.p, arc.q, u, v});
  if (exponent == 0) return decide<Interval>(arc, u, v);
  const auto scaled = [exponent](Vec2 p) { return in_unit(p, exponent); };
  return decide<Interval>(OuterArc{scaled(arc.s), scaled(arc.p), scaled(arc.q)}, scaled(u), scaled(v));
}

bool meets_arc(const OuterArc& arc, const Corners& disk) {
  const Meets quick = meets_arc_quickly(arc, disk);
  if (quick != Meets::unsure) return quick == Meets::yes;
  return decide<Rational>(arc, disk) == Meets::yes;
}

}  // namespace mes
