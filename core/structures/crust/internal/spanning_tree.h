// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the minimum spanning tree of the triangulation in the order of certainty.
#pragma once

#include <cstdint>

#include "core/base/jobs/job_control.h"
#include "core/structures/crust/internal/certainty_order.h"

namespace mes {

/// Returns 1 for each edge in the tree, which depends on the positions of the sites alone; 0 for the others and for
/// dead rows.
///
/// Cost: O(n log n), of which little is sequential. How: a grid cuts the sites into blocks of about `sites_per_block`.
/// An edge inside a block is not in the tree if less sure edges of the block join its ends. It is in the tree if it
/// joins two components even if everything outside the block counts as one. Both are found within the block, on some
/// thread and in its cache. The edges that are left, along the rims of the blocks, are decided by Kruskal's algorithm
/// over all blocks. Clusters that are small against the extent share a block, which costs time and changes nothing.
/// Threads: borrows other cores. The keys of `order` must be known (`CertaintyOrder::find_keys`).
Table<EdgeSlot, std::uint8_t> spanning_tree(const Delaunay& delaunay, const CertaintyOrder& order, JobControl& job,
                                            std::size_t sites_per_block = 8192);

}  // namespace mes
