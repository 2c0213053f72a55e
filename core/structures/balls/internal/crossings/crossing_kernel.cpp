// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/crossings/crossing_kernel.h"

#include <CGAL/FPU.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/kernel/numbers/root_sign.h"

namespace mes {
namespace {

using Interval = Crossing::Interval;
using Rational = RootElement::Rational;

template <class Number>
struct Place {
  Number x, y;
};

/// Error up to which two doubles suffice for a crossing; otherwise it gets forty digits.
constexpr double kEnough = 0x1p-64;

/// Slope of the sweep. Along the axes many crossings of a symmetric figure are equal, which takes longest to detect.
constexpr double kSlope = 0.6180339887498949;

/// The point (x, y) + sqrt(radicand) (x_root, y_root).
template <class Number>
struct Terms {
  Number x, y, x_root{0}, y_root{0}, radicand{0};
};

template <class Number>
Terms<Number> terms_of(const CrossingSource& source, const BallOf<Number>& p, const BallOf<Number>& q) {
  using Kind = CrossingSource::Kind;
  const Number sx(source.sample.x), sy(source.sample.y);
  if (source.kind == Kind::sample) return {sx, sy};
  const Number dx = q.x - p.x, dy = q.y - p.y;
  const Number dd = dx * dx + dy * dy;
  if (source.kind == Kind::mirrored) {
    const Number twice = Number(2) * (dx * (sy - p.y) - dy * (sx - p.x)) / dd;
    return {sx + twice * dy, sy - twice * dx};
  }
  const Number s = dd - q.w + p.w;
  const Number twice = Number(2) * dd;
  const Number foot = s / twice;
  Terms<Number> out{p.x + foot * dx, p.y + foot * dy};
  if (source.kind == Kind::touch) return out;
  const Number side(source.left ? 1.0 : -1.0);
  out.x_root = -side * dy / twice;
  out.y_root = side * dx / twice;
  out.radicand = Number(4) * dd * p.w - s * s;
  return out;
}

template <class Number>
Terms<Number> terms_of(const CrossingSource& source) {
  return terms_of(source, ball_in<Number>(*source.ball[0]), ball_in<Number>(*source.ball[1]));
}

template <unsigned kDigits>
Place<BigInterval<kDigits>> big_place(const CrossingSource& source, const Terms<BigInterval<kDigits>>& terms) {
  using Number = BigInterval<kDigits>;
  if (source.kind != CrossingSource::Kind::root) return {terms.x, terms.y};
  const Number root = root_of<kDigits>(terms.radicand);
  return {terms.x + terms.x_root * root, terms.y + terms.y_root * root};
}

// The point at which a polynomial is evaluated: a crossing, or the centre of a ball.
template <unsigned kDigits>
Place<BigInterval<kDigits>> place_at(const CrossingPoint& p) {
  if constexpr (kDigits == 40) {
    if (p.at->forty != nullptr) return {p.at->forty->x, p.at->forty->y};
  }
  return big_place<kDigits>(p.at->source, terms_of<BigInterval<kDigits>>(p.at->source));
}
template <unsigned kDigits>
Place<BigInterval<kDigits>> place_at(const PipelineBall* ball) {
  const auto center = ball_in<BigInterval<kDigits>>(*ball);
  return {center.x, center.y};
}
Place<Interval> double_place(const CrossingPoint& p) {
  return {p.at->x, p.at->y};
}
Place<Interval> double_place(const PipelineBall* ball) {
  const auto center = ball_in<Interval>(*ball);
  return {center.x, center.y};
}
Place<TwoDoubles> longer_place(const CrossingPoint& p) {
  return {p.at->first_x, p.at->first_y};
}
Place<TwoDoubles> longer_place(const PipelineBall* ball) {
  const auto center = ball_in<TwoDoubles>(*ball);
  return {center.x, center.y};
}
Place<RootElement> exact_place(const CrossingPoint& p, RootElement::Radicands& radicands, std::size_t& roots) {
  const Terms<Rational> terms = terms_of<Rational>(p.at->source);
  if (p.at->source.kind != CrossingSource::Kind::root) return {RootElement(terms.x), RootElement(terms.y)};
  radicands[roots] = terms.radicand;
  const std::size_t root = roots++;
  return {{terms.x, terms.x_root, radicands, root}, {terms.y, terms.y_root, radicands, root}};
}
Place<RootElement> exact_place(const PipelineBall* ball, RootElement::Radicands&, std::size_t&) {
  const auto center = ball_in<Rational>(*ball);
  return {RootElement(center.x), RootElement(center.y)};
}

template <unsigned kDigits, class Polynomial, class... Operand>
int sign_with_digits(const Polynomial& polynomial, const Operand&... operand) {
  return known_sign<kDigits>(polynomial(place_at<kDigits>(operand)...));
}

template <class Polynomial, class... Operand>
int exact_sign(const Polynomial& polynomial, const Operand&... operand) {
  RootElement::Radicands radicands;
  std::size_t roots = 0;
  return polynomial(exact_place(operand, radicands, roots)...).sign();
}

/// Takes the steps from the second on; see the head of the header.
template <class Polynomial, class... Operand>
int sign_of(const Polynomial& polynomial, const Operand&... operand) {
  {
    CGAL::Protect_FPU_rounding<true> rounding;
    const Interval value = polynomial(double_place(operand)...);
    if (value.inf() > 0.0) return 1;
    if (value.sup() < 0.0) return -1;
  }
  if (const int sign = TwoDoubles(polynomial(longer_place(operand)...)).sign(); sign != 0) return sign;
  if (const int sign = sign_with_digits<40>(polynomial, operand...); sign != 0) return sign;
  if (const int sign = sign_with_digits<80>(polynomial, operand...); sign != 0) return sign;
  if (const int sign = sign_with_digits<160>(polynomial, operand...); sign != 0) return sign;
  if (const int sign = sign_with_digits<320>(polynomial, operand...); sign != 0) return sign;
  return exact_sign(polynomial, operand...);
}

template <unsigned kDigits, class Numerator, class Denominator, class... Operand>
std::optional<double> quotient_with_digits(const Numerator& numerator, const Denominator& denominator,
                                           const Operand&... operand) {
  const auto of = [&](const auto&... place) -> BigInterval<kDigits> {
    return numerator(place...) / denominator(place...);
  };
  return nearest_double<kDigits>(of(place_at<kDigits>(operand)...));
}

/// The nearest double of a quotient of polynomials. Zero takes all steps.
template <class Numerator, class Denominator, class... Operand>
double rounded_quotient(const Numerator& numerator, const Denominator& denominator, const Operand&... operand) {
  const TwoDoubles longer = numerator(longer_place(operand)...) / denominator(longer_place(operand)...);
  if (const auto out = longer.nearest()) return *out;
  if (const auto out = quotient_with_digits<40>(numerator, denominator, operand...)) return *out;
  if (const auto out = quotient_with_digits<80>(numerator, denominator, operand...)) return *out;
  if (const auto out = quotient_with_digits<160>(numerator, denominator, operand...)) return *out;
  if (const auto out = quotient_with_digits<320>(numerator, denominator, operand...)) return *out;
  if (exact_sign(numerator, operand...) == 0) return 0.0;
  const auto of = [&](const auto&... place) -> BigInterval<320> {
    return numerator(place...) / denominator(place...);
  };
  const DoubleEnds ends = ends_of<320>(of(place_at<320>(operand)...));
  return std::abs(ends.low) < std::abs(ends.high) ? ends.low : ends.high;
}

// Selects a coordinate, for polynomials of either.
struct X {
  template <class Number>
  static const Number& of(const Place<Number>& p) {
    return p.x;
  }
};
struct Y {
  template <class Number>
  static const Number& of(const Place<Number>& p) {
    return p.y;
  }
};

template <class Number>
Place<Number> operator-(const Place<Number>& p, const Place<Number>& q) {
  return {p.x - q.x, p.y - q.y};
}
template <class Number>
Number cross(const Place<Number>& p, const Place<Number>& q) {
  return p.x * q.y - p.y * q.x;
}
template <class Number>
Number square(const Place<Number>& p) {
  return p.x * p.x + p.y * p.y;
}

constexpr auto kOne = []<class Number>(const Place<Number>&, const auto&...) { return Number(1.0); };

template <class Axis>
int compare_along(CrossingPoint p, CrossingPoint q) {
  if (p.at->same == q.at->same) return 0;
  return sign_of([](const auto& a, const auto& b) { return Axis::of(a) - Axis::of(b); }, p, q);
}

template <class... Point>
bool are_samples(const Point&... p) {
  return ((p.at->source.kind == CrossingSource::Kind::sample) && ...);
}
FastKernel::Point_2 sample_at(const CrossingPoint& p) {
  return {p.at->source.sample.x, p.at->source.sample.y};
}

bool are_on_one_circle(const Crossing& p, const Crossing& q, const Crossing& r, const Crossing& s) {
  return std::ranges::any_of(p.circles, [&](InputSlot circle) {
    const auto passes = [circle](const Crossing& c) { return std::ranges::binary_search(c.circles, circle); };
    return passes(q) && passes(r) && passes(s);
  });
}

/// Like `coordinate_in_document`.
template <class Numerator, class Denominator, class... Operand>
double document_coordinate(double local, double origin, int exponent, const Numerator& numerator,
                           const Denominator& denominator, const Operand&... operand) {
  if (origin == 0.0) return times_power_of_two(local, exponent);
  const double unit = std::ldexp(1.0, exponent);
  const auto moved = [&](const auto& first, const auto&... rest) {
    using Number = std::remove_cvref_t<decltype(first.x)>;
    return numerator(first, rest...) * Number(unit) + denominator(first, rest...) * Number(origin);
  };
  return rounded_quotient(moved, denominator, operand...);
}

}  // namespace

Crossing crossing_of(const CrossingSource& source, const BallOf<Crossing::First>& a,
                     const BallOf<Crossing::First>& b) {
  Crossing out;
  out.source = source;
  const Terms<TwoDoubles> terms = terms_of(source, a, b);
  const bool has_root = source.kind == CrossingSource::Kind::root;
  const TwoDoubles root = has_root ? root_of(terms.radicand) : TwoDoubles();
  out.first_x = has_root ? terms.x + terms.x_root * root : terms.x;
  out.first_y = has_root ? terms.y + terms.y_root * root : terms.y;
  const double size = std::max(std::abs(out.first_x.value()), std::abs(out.first_y.value()));
  if (out.first_x.error() <= kEnough * size && out.first_y.error() <= kEnough * size) {
    out.x = Interval(out.first_x.low_end(), out.first_x.high_end());
    out.y = Interval(out.first_y.low_end(), out.first_y.high_end());
    return out;
  }
  const auto place = big_place<40>(source, terms_of<BigInterval<40>>(source));
  out.forty = std::make_shared<const Crossing::FortyDigits>(Crossing::FortyDigits{place.x, place.y});
  const auto interval = [](const BigInterval<40>& x) {
    const DoubleEnds ends = ends_of<40>(x);
    return Interval(ends.low, ends.high);
  };
  out.x = interval(place.x);
  out.y = interval(place.y);
  return out;
}

bool CrossingKernel::Less_along::operator()(CrossingPoint p, CrossingPoint q, bool by_second) const {
  if (p.at->same == q.at->same) return false;
  const auto along_first = [](const auto& a, const auto& b) {
    using Number = std::remove_cvref_t<decltype(a.x)>;
    return (a.x - b.x) + Number(kSlope) * (a.y - b.y);
  };
  const auto along_second = [](const auto& a, const auto& b) {
    using Number = std::remove_cvref_t<decltype(a.x)>;
    return (a.y - b.y) - Number(kSlope) * (a.x - b.x);
  };
  if (const int order = by_second ? sign_of(along_second, p, q) : sign_of(along_first, p, q); order != 0)
    return order < 0;
  return by_second ? sign_of(along_first, p, q) > 0 : sign_of(along_second, p, q) < 0;
}

CGAL::Comparison_result CrossingKernel::Compare_x_2::operator()(CrossingPoint p, CrossingPoint q) const {
  return static_cast<CGAL::Comparison_result>(compare_along<X>(p, q));
}
CGAL::Comparison_result CrossingKernel::Compare_y_2::operator()(CrossingPoint p, CrossingPoint q) const {
  return static_cast<CGAL::Comparison_result>(compare_along<Y>(p, q));
}

CGAL::Orientation CrossingKernel::Orientation_2::operator()(CrossingPoint p, CrossingPoint q, CrossingPoint r) const {
  if (p.at->same == q.at->same || q.at->same == r.at->same || r.at->same == p.at->same) return CGAL::COLLINEAR;
  if (are_samples(p, q, r)) return CGAL::orientation(sample_at(p), sample_at(q), sample_at(r));
  return static_cast<CGAL::Orientation>(
      sign_of([](const auto& a, const auto& b, const auto& c) { return cross(b - a, c - a); }, p, q, r));
}

CGAL::Oriented_side CrossingKernel::Side_of_oriented_circle_2::operator()(CrossingPoint p, CrossingPoint q,
                                                                          CrossingPoint r, CrossingPoint s) const {
  if (s.at->same == p.at->same || s.at->same == q.at->same || s.at->same == r.at->same ||
      are_on_one_circle(*p.at->same, *q.at->same, *r.at->same, *s.at->same))
    return CGAL::ON_ORIENTED_BOUNDARY;
  if (are_samples(p, q, r, s))
    return CGAL::side_of_oriented_circle(sample_at(p), sample_at(q), sample_at(r), sample_at(s));
  const auto in_circle = [](const auto& p_, const auto& q_, const auto& r_, const auto& s_) {
    const auto a = p_ - s_, b = q_ - s_, c = r_ - s_;
    return square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b);
  };
  return static_cast<CGAL::Oriented_side>(sign_of(in_circle, p, q, r, s));
}

int compare_distances_to_line(CrossingPoint p, CrossingPoint q, const PipelineBall& a, const PipelineBall& b) {
  return sign_of(
      [](const auto& p_, const auto& q_, const auto& a_, const auto& b_) { return cross(q_ - p_, a_ - b_); }, p, q,
      &a, &b);
}

PlacedPoint place_of(CrossingPoint p, const LocalFrame& frame) {
  const auto x = [](const auto& place) { return place.x; };
  const auto y = [](const auto& place) { return place.y; };
  const Vec2 local{rounded_quotient(x, kOne, p), rounded_quotient(y, kOne, p)};
  return {local,
          {document_coordinate(local.x, frame.origin.x, frame.exponent, x, kOne, p),
           document_coordinate(local.y, frame.origin.y, frame.exponent, y, kOne, p)}};
}

PlacedPoint place_of_circumcenter(CrossingPoint p, CrossingPoint q, CrossingPoint r, const LocalFrame& frame) {
  const auto denominator = [](const auto& a, const auto& b, const auto& c) {
    const auto out = cross(b - a, c - a);
    return out + out;
  };
  const auto x = [&](const auto& a, const auto& b, const auto& c) {
    const auto u = b - a, v = c - a;
    return v.y * square(u) - u.y * square(v) + a.x * denominator(a, b, c);
  };
  const auto y = [&](const auto& a, const auto& b, const auto& c) {
    const auto u = b - a, v = c - a;
    return u.x * square(v) - v.x * square(u) + a.y * denominator(a, b, c);
  };
  const Vec2 local{rounded_quotient(x, denominator, p, q, r), rounded_quotient(y, denominator, p, q, r)};
  return {local,
          {document_coordinate(local.x, frame.origin.x, frame.exponent, x, denominator, p, q, r),
           document_coordinate(local.y, frame.origin.y, frame.exponent, y, denominator, p, q, r)}};
}

Vec2 rounded_vector(const PipelineBall& ball, CrossingPoint p) {
  return {rounded_quotient([](const auto& at, const auto& center) { return at.x - center.x; }, kOne, p, &ball),
          rounded_quotient([](const auto& at, const auto& center) { return at.y - center.y; }, kOne, p, &ball)};
}

}  // namespace mes
