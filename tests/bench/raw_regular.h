// SPDX-License-Identifier: GPL-3.0-or-later
// The peer of the union pipeline: CGAL's regular triangulation with nothing around it.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/geometry/disk.h"

namespace mes::bench {

/// `Regular_triangulation_2::insert(begin, end)` over the kernel with exact predicates. Gives the visible vertices,
/// so that the work cannot be left out.
std::size_t raw_regular_insert_range(std::span<const Disk> disks);

}  // namespace mes::bench
