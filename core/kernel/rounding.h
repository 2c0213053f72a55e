// SPDX-License-Identifier: GPL-3.0-or-later
// Rounds exact numbers to the nearest double.
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>

#include "core/base/geometry/infinity.h"
#include "core/kernel/kernels.h"

namespace mes {

/// Double nearest to a rational number; infinite beyond the range of doubles.
template <class Rational>
double nearest_double(const Rational& x) {
  if (x == Rational(0)) return 0.0;
  // Library conversions truncate, or are off by a few units in the last place; the nearest double is a few steps away.
  double out = CGAL::to_double(x);
  if (!std::isfinite(out)) return out;
  const auto is_beyond_middle = [&x](double near, double far) {
    return std::isfinite(far) && CGAL::abs(x - Rational(far)) < CGAL::abs(x - Rational(near));
  };
  for (const double end : {kInfinity, -kInfinity})
    for (double next = std::nextafter(out, end); is_beyond_middle(out, next); next = std::nextafter(out, end))
      out = next;
  return out;
}

/// The nearest double. CGAL's conversions promise only five digits of a lazy number. roots_kernel.h has one for roots.
template <class Number>
double rounded(const Number& x) {
  if constexpr (std::is_same_v<Number, double>) {
    return x;
  } else if constexpr (std::is_same_v<Number, CGAL::Exact_rational>) {
    return nearest_double(x);
  } else {
    static_assert(std::is_same_v<Number, typename ExactKernel::FT>);
    if (x.approx().is_point()) return x.approx().inf() + 0.0;
    return nearest_double(x.exact());
  }
}

}  // namespace mes
