// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/point_predicates.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include "core/kernel/kernels.h"

namespace mes {
namespace {

/// The sign of an expression, evaluated in intervals first and in rationals where these do not decide.
template <class Expression>
int exact_sign(Expression expression) {
  const CGAL::Uncertain<CGAL::Sign> quick = CGAL::sign(expression(CGAL::Interval_nt<true>()));
  if (quick.is_certain()) return static_cast<int>(quick.make_certain());
  return static_cast<int>(CGAL::sign(expression(CGAL::Exact_rational())));
}

template <class Number>
struct Difference {
  Number x, y;
  Difference(Vec2 to, Vec2 from) : x(Number(to.x) - Number(from.x)), y(Number(to.y) - Number(from.y)) {}
  Number length2() const { return x * x + y * y; }
  Number cross(const Difference& other) const { return x * other.y - y * other.x; }
};

FastKernel::Point_2 point(Vec2 p) {
  return {p.x, p.y};
}

}  // namespace

int orientation(Vec2 a, Vec2 b, Vec2 c) {
  return static_cast<int>(FastKernel().orientation_2_object()(point(a), point(b), point(c)));
}

int side_of_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return static_cast<int>(FastKernel().side_of_oriented_circle_2_object()(point(a), point(b), point(c), point(d)));
}

int side_of_diametral_circle(Vec2 a, Vec2 b, Vec2 c) {
  return static_cast<int>(FastKernel().side_of_bounded_circle_2_object()(point(a), point(b), point(c)));
}

int side_of_power_circle(const Disk& a, const Disk& b, const Disk& c, const Disk& d) {
  return exact_sign([&]<class Number>(const Number& /*type*/) -> Number {
    const Number weight = Number(d.radius) * Number(d.radius);
    const auto lift = [&](const Difference<Number>& v, double radius) -> Number {
      return v.length2() - Number(radius) * Number(radius) + weight;
    };
    const Difference<Number> u(a.center, d.center);
    const Difference<Number> v(b.center, d.center);
    const Difference<Number> w(c.center, d.center);
    return lift(u, a.radius) * v.cross(w) + lift(v, b.radius) * w.cross(u) + lift(w, c.radius) * u.cross(v);
  });
}

int compare_distances(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return exact_sign([&]<class Number>(const Number& /*type*/) -> Number {
    return Difference<Number>(b, a).length2() - Difference<Number>(d, c).length2();
  });
}

int compare_circumradii(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 e, Vec2 f) {
  // The squared radius is the product of the squared sides, divided by four times the square of twice the area.
  return exact_sign([&]<class Number>(const Number& /*type*/) -> Number {
    const auto sides = [](Vec2 p, Vec2 q, Vec2 r) -> Number {
      return Difference<Number>(q, p).length2() * Difference<Number>(r, q).length2() *
             Difference<Number>(p, r).length2();
    };
    const auto area = [](Vec2 p, Vec2 q, Vec2 r) -> Number {
      return Difference<Number>(q, p).cross(Difference<Number>(r, p));
    };
    const Number first = area(a, b, c);
    const Number second = area(d, e, f);
    return sides(a, b, c) * second * second - sides(d, e, f) * first * first;
  });
}

}  // namespace mes
