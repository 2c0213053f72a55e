// SPDX-License-Identifier: GPL-3.0-or-later
// Balls in numbers with square roots.
#pragma once

#include <CGAL/CORE_BigRat.h>

#include "core/kernel/roots_kernel.h"
#include "core/structures/balls/internal/numbers/union_numbers.h"

namespace mes {

/// Finding a sign costs more the deeper the expression is, so expressions with roots start from plain numbers.
template <>
inline BallOf<RootsKernel::FT> ball_in(const PipelineBall& ball) {
  const BallOf<CORE::BigRat> exact = ball_in<CORE::BigRat>(ball);
  const auto number = [](const CORE::BigRat& x) { return RootsKernel::FT(CORE::Expr(x)); };
  return {number(exact.x), number(exact.y), number(exact.w)};
}

}  // namespace mes
