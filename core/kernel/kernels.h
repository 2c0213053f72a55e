// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels from CGAL; roots_kernel.h has one more, with square roots.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

namespace mes {

/// Plain doubles, even in predicates. No decision can be relied on; CGAL's algorithms may not even terminate.
using NaiveKernel = CGAL::Simple_cartesian<double>;

/// Exact predicates on the given doubles through filters: the default for everything combinatorial on samples.
using FastKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Rational constructions, evaluated where an interval does not decide. Objects belong to one thread.
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

}  // namespace mes
