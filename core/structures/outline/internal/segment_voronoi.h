// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Voronoi diagram of an outline that is its medial axis, inside.
#pragma once

#include <span>

#include "core/base/jobs/job_control.h"
#include "core/structures/outline/outline_graph.h"

namespace mes {

/// `sides` are those of `OutlineSides::take`. Arcs and what they nearly touch, up to `tolerance` away as in drawings with
/// few decimals, count as touching.
///
/// The Voronoi edges of the features of an outline, except those between a side and its own end, in regions that an odd
/// number of closed contours surrounds. Edges of zero length are contracted, and edges between neighbouring chords of a
/// smooth curve are left out. An empty circle on which an arc lies and which touches another feature contracts their
/// edges near its centre. A region without edges, a disk, has a node.
///
/// Guarantees:
///  1. Which edges there are, where they end, and what lies inside is decided exactly for the given doubles.
///  2. Centres of nodes are rounded: the distances from their three features, circles of round sides among them, differ
///     by a few units in the last place of the largest coordinate. Nodes beside round sides that Newton's method does not
///     find are those of the chords.
///  3. Edges between sides from one end with an angle below 2^-40 are left out.
///
/// Cost: O(n log n) typically, some 50 us a side. Throws `Cancelled`. `shows_progress`: the progress of the job is
/// that of this computation. Threads: any, also several at a time.
/// Source: Karavelas, "A robust and efficient implementation for the segment Voronoi diagram", 2004, in CGAL.
OutlineGraph inner_voronoi(std::span<const OutlineSide> sides, double tolerance, JobControl& job,
                           bool shows_progress = true);

}  // namespace mes
