// SPDX-License-Identifier: GPL-3.0-or-later
// Signs that decide which triangles and edges of a regular triangulation belong to the dual complex of a union of
// balls. A ball is its centre and weight w = squared radius.
//
// Let c_1 be the origin, A = |c_2|^2 - w_2 + w_1, B = |c_3|^2 - w_3 + w_1 and D = det(c_2, c_3). The point of equal
// power is x = (A c_3y - B c_2y, B c_2x - A c_3x) / 2D, and the squared radius of the orthogonal circle |x|^2 - w_1. On
// an edge the least common power is A^2 / 4|c_2|^2 - w_1, at the foot c_2 A / 2|c_2|^2.
// Source: Edelsbrunner 1995; the polynomial form is ours.
#pragma once

#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>

#include "core/kernel/kernels.h"
#include "core/kernel/numbers/two_doubles.h"

namespace mes {

template <class Number>
struct BallOf {
  Number x, y, w;
};

/// Differences of `Number`, and everything computed from them, may have another type.
namespace ball_polynomials {

template <class Number>
auto orthogonal_radius(const BallOf<Number>& a, const BallOf<Number>& b, const BallOf<Number>& c) {
  const auto bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const auto pb = bx * bx + by * by + (a.w - b.w);
  const auto pc = cx * cx + cy * cy + (a.w - c.w);
  const auto det = bx * cy - by * cx;
  const auto nx = pb * cy - pc * by;
  const auto ny = pc * bx - pb * cx;
  return nx * nx + ny * ny - Number(4) * det * det * a.w;
}

template <class Number>
auto edge_radius(const BallOf<Number>& a, const BallOf<Number>& b) {
  const auto bx = b.x - a.x, by = b.y - a.y;
  const auto dd = bx * bx + by * by;
  const auto pb = dd + (a.w - b.w);
  return pb * pb - Number(4) * dd * a.w;
}

/// Squared distance of the centres less both weights: negative exactly if the circles meet under an obtuse angle.
template <class Number>
auto gap(const BallOf<Number>& a, const BallOf<Number>& b) {
  const auto bx = b.x - a.x, by = b.y - a.y;
  return bx * bx + by * by - a.w - b.w;
}

/// Power of b at the centre of a, less that of a.
template <class Number>
auto excess_of_neighbour(const BallOf<Number>& a, const BallOf<Number>& b) {
  const auto bx = b.x - a.x, by = b.y - a.y;
  return bx * bx + by * by + (a.w - b.w);
}

/// Twice the signed area of the triangle of the centres.
template <class Number>
auto turn_of_centers(const BallOf<Number>& a, const BallOf<Number>& b, const BallOf<Number>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Power of c at the foot of ab, less the power of a and b there.
template <class Number>
auto excess_at_foot(const BallOf<Number>& a, const BallOf<Number>& b, const BallOf<Number>& c) {
  const auto bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const auto dd = bx * bx + by * by;
  const auto pb = dd + (a.w - b.w);
  const auto pc = cx * cx + cy * cy + (a.w - c.w);
  return dd * pc - pb * (bx * cx + by * cy);
}

/// Power of d at the point of equal power of a, b, c less their power there, times 2 det(b - a, c - a).
template <class Number>
auto excess_at_center(const BallOf<Number>& a, const BallOf<Number>& b, const BallOf<Number>& c,
                      const BallOf<Number>& d) {
  const auto bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const auto dx = d.x - a.x, dy = d.y - a.y;
  const auto pb = bx * bx + by * by + (a.w - b.w);
  const auto pc = cx * cx + cy * cy + (a.w - c.w);
  const auto pd = dx * dx + dy * dy + (a.w - d.w);
  const auto det = bx * cy - by * cx;
  return det * pd - (pb * cy - pc * by) * dx - (pc * bx - pb * cx) * dy;
}

/// Sign of `excess_at_center` in doubles; 0 means not known.
inline int quick_excess_at_center(const BallOf<double>& a, const BallOf<double>& b, const BallOf<double>& c,
                                  const BallOf<double>& d) {
  struct Seen {
    double x, y, power;
    double size;  // the terms of the power without their signs
  };
  const auto seen = [&a](const BallOf<double>& ball) {
    const double x = ball.x - a.x, y = ball.y - a.y, w = a.w - ball.w;
    const double dd = x * x + y * y;
    return Seen{x, y, dd + w, dd + std::abs(w)};
  };
  const Seen p = seen(b), q = seen(c), r = seen(d);
  // No value overflows, and underflow loses less than 1e-182.
  if (!(p.size < 1e140 && q.size < 1e140 && r.size < 1e140)) return 0;
  const double value = (p.x * q.y - p.y * q.x) * r.power - (p.power * q.y - q.power * p.y) * r.x -
                       (q.power * p.x - p.power * q.x) * r.y;
  const double size = (std::abs(p.x * q.y) + std::abs(p.y * q.x)) * r.size +
                      (p.size * std::abs(q.y) + q.size * std::abs(p.y)) * std::abs(r.x) +
                      (q.size * std::abs(p.x) + p.size * std::abs(q.x)) * std::abs(r.y);
  if (!(size > 1e-160)) return 0;
  // Let u = 2^-53. Differences are off by u of themselves, powers by 5 u of their size, the determinant by 4 u, and
  // each of the three products by 10 u; adding them up rounds by 2 u. 16 leaves room for the rounding of the bound.
  const double bound = 16.0 * 0x1p-53 * size;
  return value > bound ? 1 : (-value > bound ? -1 : 0);
}

}  // namespace ball_polynomials

/// Signs in the arithmetic of a kernel: the polynomial is evaluated in the kernel's numbers.
template <class Kernel>
struct BallSigns {
  using Number = typename Kernel::FT;
  template <class Polynomial, class... Ball>
  static int sign(Polynomial polynomial, const Ball&... balls) {
    return static_cast<int>(CGAL::sign(polynomial(balls...)));
  }
};

/// Exact for the given doubles: tries intervals, then numbers of two doubles, then numbers of any length. Threads may
/// share it. For circles through a common sample the values are as small as the rounding errors of doubles; the second
/// step decides these.
template <>
struct BallSigns<FastKernel> {
  using Number = double;
  template <class Polynomial, class... Ball>
  static int sign(Polynomial polynomial, const Ball&... balls) {
    using Interval = CGAL::Interval_nt<false>;
    {
      CGAL::Protect_FPU_rounding<true> rounding;
      const Interval value = polynomial(BallOf<Interval>{Interval(balls.x), Interval(balls.y), Interval(balls.w)}...);
      if (value.inf() > 0.0) return 1;
      if (value.sup() < 0.0) return -1;
    }
    return sign_without_filter(polynomial, balls...);
  }
  template <class Polynomial, class... Ball>
  static int sign_without_filter(Polynomial polynomial, const Ball&... balls) {
    using Exact = CGAL::Mpzf;
    const auto given = [](const auto& ball) {
      return BallOf<GivenDouble>{GivenDouble(ball.x), GivenDouble(ball.y), GivenDouble(ball.w)};
    };
    const TwoDoubles longer = polynomial(given(balls)...);
    if (const int known = longer.sign(); known != 0) return known;
    return static_cast<int>(CGAL::sign(polynomial(BallOf<Exact>{Exact(balls.x), Exact(balls.y), Exact(balls.w)}...)));
  }
};

/// Exact: tries intervals of the coordinates, then rationals. Lazy numbers would build an expression for each sign.
template <>
struct BallSigns<ExactKernel> {
  using Number = ExactKernel::FT;
  template <class Polynomial, class... Ball>
  static int sign(Polynomial polynomial, const Ball&... balls) {
    using Interval = CGAL::Interval_nt<false>;
    using Exact = Number::ET;
    {
      CGAL::Protect_FPU_rounding<true> rounding;
      const Interval value = polynomial(BallOf<Interval>{balls.x.approx(), balls.y.approx(), balls.w.approx()}...);
      if (value.inf() > 0.0) return 1;
      if (value.sup() < 0.0) return -1;
    }
    const Exact value = polynomial(BallOf<Exact>{balls.x.exact(), balls.y.exact(), balls.w.exact()}...);
    return static_cast<int>(CGAL::sign(value));
  }
};

/// Sign of the squared radius of the circle orthogonal to the three.
template <class Kernel, class Ball>
int sign_of_orthogonal_radius(const Ball& a, const Ball& b, const Ball& c) {
  return BallSigns<Kernel>::sign([](const auto&... x) { return ball_polynomials::orthogonal_radius(x...); }, a, b, c);
}
/// Sign of the least common power of the two: 0 or negative exactly if the circles meet or one ball holds the other.
template <class Kernel, class Ball>
int sign_of_edge_radius(const Ball& a, const Ball& b) {
  return BallSigns<Kernel>::sign([](const auto&... x) { return ball_polynomials::edge_radius(x...); }, a, b);
}
/// Positive exactly if the centre of c lies to the left of the line from the centre of a to that of b.
template <class Kernel, class Ball>
int sign_of_turn(const Ball& a, const Ball& b, const Ball& c) {
  return BallSigns<Kernel>::sign([](const auto&... x) { return ball_polynomials::turn_of_centers(x...); }, a, b, c);
}
/// True if one ball lies in the other, given that their circles meet in one point.
template <class Kernel, class Ball>
bool touch_from_inside(const Ball& a, const Ball& b) {
  return BallSigns<Kernel>::sign([](const auto&... x) { return ball_polynomials::gap(x...); }, a, b) < 0;
}
/// True if the centre of a lies outside its own power cell, on the side of b.
template <class Kernel, class Ball>
bool loses_center_to(const Ball& a, const Ball& b) {
  return BallSigns<Kernel>::sign([](const auto&... x) { return ball_polynomials::excess_of_neighbour(x...); }, a, b) <
         0;
}
/// Sign of the power of c midway between the crossings of a and b, less the power of a and b there. If it is negative,
/// the edge ab is *attached* to the triangle abc.
template <class Kernel, class Ball>
int sign_of_excess_at_foot(const Ball& a, const Ball& b, const Ball& c) {
  return BallSigns<Kernel>::sign([](const auto&... x) { return ball_polynomials::excess_at_foot(x...); }, a, b, c);
}
/// Sign of the power of d at the point of equal power of a, b, c, less their power there, if abc runs
/// counter-clockwise. If all weights are 0: negative exactly if d lies inside the circle of a, b, c.
template <class Kernel, class Ball>
int sign_of_excess_at_center(const Ball& a, const Ball& b, const Ball& c, const Ball& d) {
  const auto polynomial = [](const auto&... x) { return ball_polynomials::excess_at_center(x...); };
  if constexpr (std::is_same_v<Kernel, FastKernel>) {
    if (const int known = ball_polynomials::quick_excess_at_center(a, b, c, d); known != 0) return known;
    // The same determinant from another origin: the bound is best when one of two nearly coincident balls is the origin.
    if (const int known = ball_polynomials::quick_excess_at_center(c, d, a, b); known != 0) return known;
    return BallSigns<Kernel>::sign_without_filter(polynomial, a, b, c, d);
  } else {
    return BallSigns<Kernel>::sign(polynomial, a, b, c, d);
  }
}
/// True if the four have a common point of equal power.
template <class Kernel, class Ball>
bool have_common_center(const Ball& a, const Ball& b, const Ball& c, const Ball& d) {
  return sign_of_excess_at_center<Kernel>(a, b, c, d) == 0;
}

}  // namespace mes
