// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/arc_predicates.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <optional>

namespace mes {
namespace {

using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

template <class Number>
struct Vector {
  Number x, y;
};
template <class Number>
Vector<Number> between(Vec2 from, Vec2 to) {
  return {Number(to.x) - Number(from.x), Number(to.y) - Number(from.y)};
}
template <class Number>
Number cross_of(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.y - u.y * v.x;
}
template <class Number>
Number dot_of(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.x + u.y * v.y;
}
/// From `a` to the circumcentre of a, b, c.
template <class Number>
Vector<Number> to_center(Vec2 a, Vec2 b, Vec2 c) {
  const Vector<Number> u = between<Number>(a, b);
  const Vector<Number> v = between<Number>(a, c);
  const Number uu = dot_of(u, u);
  const Number vv = dot_of(v, v);
  const Number twice = Number(2) * cross_of(u, v);
  return {(v.y * uu - u.y * vv) / twice, (u.x * vv - v.x * uu) / twice};
}

// -1, 0, 1, or nothing when it is not known.
std::optional<int> sign_of(const Interval& x) {
  if (x.inf() > 0.0) return 1;
  if (x.sup() < 0.0) return -1;
  if (x.inf() == 0.0 && x.sup() == 0.0) return 0;
  return std::nullopt;
}
std::optional<int> sign_of(const Rational& x) {
  return static_cast<int>(CGAL::sign(x));
}

// Three-valued logic: a sign that is not known makes the answer `unsure` unless the other part settles it.
template <class Number>
Meets points_into_arc(const Vector<Number>& p, const Vector<Number>& q, const Vector<Number>& direction) {
  const auto turn = sign_of(cross_of(p, q));
  const auto after_p = sign_of(cross_of(p, direction));
  const auto before_q = sign_of(cross_of(direction, q));
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
  const Number own = dot_of(from_p, from_p);
  const Number other = dot_of(from_a, from_a);
  const Number gap = dot_of(direction, direction) - own - other;
  const auto apart = sign_of(gap);
  if (apart && *apart <= 0) return points;
  const auto beyond = sign_of(gap * gap - Number(4) * own * other);
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
  const Number height = cross_of(uv, Vector<Number>{up.x + from_p.x, up.y + from_p.y});
  const auto side = sign_of(height);
  if (side && *side >= 0) return points;
  const auto reach = sign_of(dot_of(from_p, from_p) * dot_of(uv, uv) - height * height);
  if (reach && *reach <= 0) return side ? Meets::no : Meets::unsure;
  return reach ? points : Meets::unsure;
}

}  // namespace

Meets meets_arc_quickly(const OuterArc& arc, const Corners& disk) {
  CGAL::Protect_FPU_rounding<true> rounding;
  return decide<Interval>(arc, disk);
}

Meets meets_arc_quickly(const OuterArc& arc, Vec2 u, Vec2 v) {
  CGAL::Protect_FPU_rounding<true> rounding;
  return decide<Interval>(arc, u, v);
}

bool meets_arc(const OuterArc& arc, const Corners& disk) {
  const Meets quick = meets_arc_quickly(arc, disk);
  if (quick != Meets::unsure) return quick == Meets::yes;
  return decide<Rational>(arc, disk) == Meets::yes;
}

}  // namespace mes
