// SPDX-License-Identifier: GPL-3.0-or-later
// From exact numbers to the nearest double.
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>

#include "core/base/infinity.h"
#include "core/kernel/kernels.h"

namespace mes {

/// Of a rational number. What is too large for doubles becomes infinite.
template <class Rational>
double nearest_double(const Rational& x) {
  if (x == Rational(0)) return 0.0;
  // Conversions of libraries cut off, or are a few places off; the steps from there to the nearest are few.
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

/// The nearest double. The conversions of CGAL promise five digits of a lazy number. roots_kernel.h has one for roots.
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
