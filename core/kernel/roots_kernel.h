// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel with square roots, apart from the others: its numbers are a library in headers, three seconds of compiling.
#pragma once

#include <CGAL/CORE_Expr.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Simple_cartesian.h>

#include "core/kernel/rounding.h"

namespace mes {

/// As `ExactKernel`, with square roots. The sign of a number that is zero costs a separation bound, milliseconds and more.
using RootsKernel = CGAL::Simple_cartesian<CGAL::Lazy_exact_nt<CORE::Expr>>;

/// The nearest double; of a number that lies in the middle between two doubles, up to 2^-120 of itself, either. CORE
/// itself promises an absolute precision.
template <>
inline double rounded(const RootsKernel::FT& x) {
  if (x.approx().is_point()) return x.approx().inf() + 0.0;
  const CORE::Expr& exact = x.exact();
  if (exact.sign() == 0) return 0.0;
  constexpr long kBits = 120;
  return nearest_double(exact.approx(CORE::extLong(kBits), CORE::extLong::getPosInfty()).BigRatValue());
}

}  // namespace mes
