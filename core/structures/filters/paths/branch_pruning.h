// SPDX-License-Identifier: GPL-3.0-or-later
// Prunes whole branches of an axis that show little of the shape.
//
// An *arm* runs from a free end to the first node with three or more edges, its junction. It reaches from the junction
// to the boundary behind the free end: its length and the radius there, or the reach of a pruned arm if that is more.
// Its *salience* is the part of this reach beyond the ball of the junction, over the radius of that ball. A strip of
// the width of the ball has its length over the radius; a corner of angle a has 1 / sin(a / 2) - 1, so 0.41 at a right
// angle and 1 at 60 degrees. Noise on a boundary has little.
//
// Guarantees:
//  1. Only arms are pruned, so each shape keeps its cycles and stays in one piece, if only as a point.
//  2. The arm of the least salience goes first, and with it all arms at its junction below the limit: a corner is not
//     kept because its twin went. Then the arms that are left are measured again.
//  3. An axis without junctions stays whole. A limit of 0 prunes nothing.
//  4. Salience does not depend on the unit of length.
//
// Cost: O(e log e) for e edges, as far as chains between junctions stay short.
//
// Smallest use:
//     const std::vector<std::uint8_t> is_kept = salient_branches(graph, radii, 0.5);
//     const MergedBranches lines = merge_branches(graph, is_kept);
//
// Source: Shaked and Bruckstein, "Pruning medial axes", 1998; Liu, Chambers, Letscher and Ju, "Extended grassfire
// transform on medial axes of 2D shapes", 2011 (the reach beyond the ball is their erosion thickness). Ours: the ratio
// to the ball, and twins at a junction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/structures/filters/paths/path_graph.h"

namespace mes {

/// For each edge 1 if it is kept, else 0. `radii` are those of the balls at the nodes.
std::vector<std::uint8_t> salient_branches(const PathGraph& graph, std::span<const double> radii, double limit);

struct MergedBranches {
  std::vector<PathEdge> edges;                ///< between nodes that do not have exactly two kept edges
  std::vector<std::vector<PathStep>> chains;  ///< the kept edges in each of them, from `PathEdge::from` on
};
/// The kept edges without the nodes between two of them. A closed chain is a loop at its node of the least number.
MergedBranches merge_branches(const PathGraph& graph, std::span<const std::uint8_t> is_kept);

}  // namespace mes
