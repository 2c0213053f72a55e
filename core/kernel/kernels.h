// SPDX-License-Identifier: GPL-3.0-or-later
// The one header that names CGAL kernels.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace mes {

/// Exact predicates on the given doubles through filters: the default for everything combinatorial on samples.
using FastKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

}  // namespace mes
