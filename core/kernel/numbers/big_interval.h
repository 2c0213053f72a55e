// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals of growing precision: a step between intervals of doubles and exact numbers.
#pragma once

#include <boost/multiprecision/mpfi.hpp>

#include <cmath>
#include <optional>

namespace mes {

/// Interval between two binary numbers of `kDigits` decimal digits; results are rounded outward (MPFI). The
/// range of exponents is that of MPFR, which the accepted coordinates never leave.
template <unsigned kDigits>
using BigInterval =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<kDigits>, boost::multiprecision::et_off>;

/// -1 or 1, or 0 exactly if the interval holds 0.
template <unsigned kDigits>
int known_sign(const BigInterval<kDigits>& x) {
  const auto& ends = x.backend().data();
  return mpfi_is_strictly_pos(ends) > 0 ? 1 : (mpfi_is_strictly_neg(ends) > 0 ? -1 : 0);
}

/// Square root of a number that is not negative.
template <unsigned kDigits>
BigInterval<kDigits> root_of(BigInterval<kDigits> x) {
  if (known_sign(x) == 0) x = BigInterval<kDigits>(0, boost::multiprecision::upper(x));
  return boost::multiprecision::sqrt(x);
}

/// The two ends, rounded outward; infinite or NaN where the interval is not bounded.
struct DoubleEnds {
  double low;
  double high;
};
template <unsigned kDigits>
DoubleEnds ends_of(const BigInterval<kDigits>& x) {
  const auto& ends = x.backend().data();
  return {mpfr_get_d(&ends->left, MPFR_RNDD), mpfr_get_d(&ends->right, MPFR_RNDU)};
}

/// The double nearest to every number of the interval, if they share one; numbers beyond the doubles round to infinity.
template <unsigned kDigits>
std::optional<double> nearest_double(const BigInterval<kDigits>& x) {
  const auto& ends = x.backend().data();
  const double low = mpfr_get_d(&ends->left, MPFR_RNDN);
  const double high = mpfr_get_d(&ends->right, MPFR_RNDN);
  if (low != high) return std::nullopt;  // true for NaN, too
  return low + 0.0;
}

}  // namespace mes
