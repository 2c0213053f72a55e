// SPDX-License-Identifier: GPL-3.0-or-later
// The minimum spanning tree of the triangulation in the order of certainty, from nothing.
#pragma once

#include <cstdint>

#include "core/base/job_control.h"
#include "core/structures/crust/internal/certainty_order.h"

namespace mes {

/// For each edge 1 if it is in the tree, which depends on the positions of the sites alone; 0 for the others and for
/// rows that are not alive.
///
/// Cost: O(n log n), of which little is sequential. How: the sites are cut into blocks of about `sites_per_block` by a
/// grid. An edge inside a block whose ends less sure edges of the block join is not in the tree; one that joins two
/// components even if all that lies outside the block counts as one is in it. Both are found in the block alone, on
/// some thread and in its cache. What is left, along the rims of the blocks, is decided by Kruskal's algorithm over all
/// of them. Clusters that are small against the extent share a block; that costs time and changes nothing.
/// Threads: borrows other cores. The keys of `order` must be there (`CertaintyOrder::find_keys`).
Table<EdgeSlot, std::uint8_t> spanning_tree(const Delaunay& delaunay, const CertaintyOrder& order, JobControl& job,
                                            std::size_t sites_per_block = 8192);

}  // namespace mes
