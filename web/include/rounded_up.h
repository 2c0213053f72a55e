// SPDX-License-Identifier: GPL-3.0-or-later
// Sums, products, quotients and roots of doubles that are rounded upward, where the processor rounds to nearest only.
#pragma once

#include <cmath>
#include <limits>

/// Guarantees: each function returns the least double that is not less than the exact result, as a processor does that
/// rounds upward; what is not a number stays so. The error of the nearest double is computed exactly, by arithmetic
/// that rounds to nearest.
///
/// Cost: ten to twenty operations; more where numbers are near the ends of the range. Threads: any.
namespace mes::rounded_up {

namespace detail {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline double above(double nearest, bool is_below) {
  return is_below ? std::nextafter(nearest, kInfinity) : nearest;
}

/// Products of such numbers and their errors are doubles.
inline bool is_moderate(double a) {
  const double size = std::abs(a);
  return size > 0x1p-400 && size < 0x1p400;
}

/// The exact a * b - p, where p is the nearest double; all of them are moderate.
inline double product_error(double a, double b, double p) {
  // The upper half of the digits of a number.
  const auto upper = [](double x) {
    const double scaled = 0x1.0000002p27 * x;
    return scaled - (scaled - x);
  };
  const double a1 = upper(a);
  const double b1 = upper(b);
  const double a2 = a - a1;
  const double b2 = b - b1;
  return a2 * b2 - (((p - a1 * b1) - a2 * b1) - a1 * b2);
}

/// A number as its digits, of size between 1/2 and 1, and a power of two.
struct Scaled {
  int power = 0;  // stands first, because the initialiser of the other writes it
  double digits;
  explicit Scaled(double x) : digits(std::frexp(x, &power)) {}
};

/// True if p is less than a * b; all of them are finite, and neither factor is zero.
inline bool is_below_product(double p, double a, double b) {
  if (p == 0.0) return std::signbit(a) == std::signbit(b);
  const Scaled x(a);
  const Scaled y(b);
  const Scaled z(p);
  return std::fma(x.digits, y.digits, -std::ldexp(z.digits, z.power - x.power - y.power)) > 0.0;
}

/// The result of finite operands whose nearest double is infinite. Above all doubles it is +infinity; below all doubles
/// it is the lowest double, which is the least one that is not less.
inline double overflown(double nearest) {
  return nearest < 0.0 ? std::numeric_limits<double>::lowest() : nearest;
}

}  // namespace detail

inline double sum(double a, double b) {
  const double s = a + b;
  if (!std::isfinite(s)) return std::isfinite(a) && std::isfinite(b) ? detail::overflown(s) : s;
  const bool is_first_larger = std::abs(a) >= std::abs(b);
  const double large = is_first_larger ? a : b;
  const double small = is_first_larger ? b : a;
  return detail::above(s, small - (s - large) > 0.0);
}

inline double difference(double a, double b) {
  return sum(a, -b);
}

inline double product(double a, double b) {
  const double p = a * b;
  if (detail::is_moderate(a) && detail::is_moderate(b) && detail::is_moderate(p))
    return detail::above(p, detail::product_error(a, b, p) > 0.0);
  if (a == 0.0 || b == 0.0 || !std::isfinite(a) || !std::isfinite(b)) return p;
  if (!std::isfinite(p)) return detail::overflown(p);
  return detail::above(p, detail::is_below_product(p, a, b));
}

inline double quotient(double a, double b) {
  const double q = a / b;
  if (detail::is_moderate(a) && detail::is_moderate(b) && detail::is_moderate(q)) {
    const double p = q * b;
    const double left = (a - p) - detail::product_error(q, b, p);
    return detail::above(q, b > 0.0 ? left > 0.0 : left < 0.0);
  }
  if (a == 0.0 || b == 0.0 || !std::isfinite(a) || !std::isfinite(b)) return q;
  if (!std::isfinite(q)) return detail::overflown(q);
  if (q == 0.0) return detail::above(q, std::signbit(a) == std::signbit(b));
  const detail::Scaled x(a);
  const detail::Scaled y(b);
  const detail::Scaled z(q);
  const double left = std::fma(-z.digits, y.digits, std::ldexp(x.digits, x.power - y.power - z.power));
  return detail::above(q, b > 0.0 ? left > 0.0 : left < 0.0);
}

inline double square_root(double a) {
  const double s = std::sqrt(a);
  if (!(a > 0.0) || !std::isfinite(a)) return s;
  if (detail::is_moderate(a)) return detail::above(s, (a - s * s) - detail::product_error(s, s, s * s) > 0.0);
  // The square of the root, which is far from the ends of the range, may be near one of them.
  const int even = 2 * (std::ilogb(a) / 2);
  const double scaled = std::ldexp(a, -even);
  const double root = std::ldexp(s, -even / 2);
  return detail::above(s, std::fma(-root, root, scaled) > 0.0);
}

/// The greatest double that is not above the root; a is not negative.
inline double square_root_down(double a) {
  const double up = square_root(a);
  const double s = std::sqrt(a);
  if (s < up || !(a > 0.0) || !std::isfinite(a)) return s;
  return detail::is_below_product(a, up, up) ? std::nextafter(up, 0.0) : up;
}

}  // namespace mes::rounded_up
