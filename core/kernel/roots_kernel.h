// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel with square roots, in a file of its own because its number library takes three seconds to compile.
#pragma once

#include <CGAL/CORE_Expr.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Simple_cartesian.h>

#include "core/kernel/rounding.h"

namespace mes {

/// `ExactKernel` with square roots. Finding that a number is zero costs a separation bound: milliseconds and more.
using RootsKernel = CGAL::Simple_cartesian<CGAL::Lazy_exact_nt<CORE::Expr>>;

/// The nearest double. A number whose distance to the middle of two doubles is at most 2^-120 of itself may round to
/// either. CORE itself promises an absolute precision.
template <>
inline double rounded(const RootsKernel::FT& x) {
  if (x.approx().is_point()) return x.approx().inf() + 0.0;
  const CORE::Expr& exact = x.exact();
  if (exact.sign() == 0) return 0.0;
  constexpr long kBits = 120;
  return nearest_double(exact.approx(CORE::extLong(kBits), CORE::extLong::getPosInfty()).BigRatValue());
}

}  // namespace mes
