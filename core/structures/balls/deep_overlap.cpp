// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/deep_overlap.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>

#include "core/structures/balls/internal/numbers/union_numbers.h"

namespace mes {
namespace {

template <class Number>
struct Overlap {
  Number t;       // w_1 + w_2 - d^2
  Number excess;  // t^2 - 2 w_1 w_2
};
template <class Number>
Overlap<Number> overlap_of(const PipelineBall& first, const PipelineBall& second) {
  const BallOf<Number> a = ball_in<Number>(first);
  const BallOf<Number> b = ball_in<Number>(second);
  const Number t = -ball_polynomials::gap(a, b);
  return {t, t * t - Number(2) * a.w * b.w};
}

}  // namespace

bool overlap_deeply(const PipelineBall& a, const PipelineBall& b) {
  {
    CGAL::Protect_FPU_rounding<true> rounding;
    const auto [t, excess] = overlap_of<CGAL::Interval_nt<false>>(a, b);
    if (t.sup() < 0.0 || excess.sup() < 0.0) return false;
    if (t.inf() > 0.0 && excess.inf() > 0.0) return true;
  }
  const auto [t, excess] = overlap_of<CGAL::Exact_rational>(a, b);
  return t > 0 && excess > 0;
}

double cosine_at_crossing(const Disk& a, const Disk& b) {
  // Squares of lengths within the range of coordinates may leave the range of doubles.
  const int exponent = -std::ilogb(std::max(a.radius, b.radius));
  const auto length = [exponent](double x) { return std::ldexp(x, exponent); };
  const Vec2 d{length(b.center.x - a.center.x), length(b.center.y - a.center.y)};
  const double r = length(a.radius);
  const double s = length(b.radius);
  // (w_1 + w_2 - d^2) / 2 r_1 r_2, with the two large terms of nearly equal balls kept apart.
  const double difference = r - s;
  return 1.0 + (difference * difference - dot(d, d)) / (2.0 * r * s);
}

}  // namespace mes
