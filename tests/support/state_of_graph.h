// SPDX-License-Identifier: GPL-3.0-or-later
// The whole state of the geometry as values independent of row numbers, for comparing two ways to the same samples.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/engine/graph.h"

namespace mes::test {

/// An edge that is not a cocircular diagonal: ends in lexicographic order, then crust, conflict, inside on the left,
/// inside on the right.
struct EdgeState {
  Vec2 a, b;
  bool crust = false, conflict = false, inside_left = false, inside_right = false;
  friend bool operator==(const EdgeState&, const EdgeState&) = default;
  friend bool operator<(const EdgeState& x, const EdgeState& y);
};

/// A group of faces with one circumcircle: the sorted corners, whether it is a ball, and its degree as an axis node.
struct NodeStateOf {
  std::vector<Vec2> corners;
  bool inside = false;
  int degree = 0;
  friend bool operator==(const NodeStateOf&, const NodeStateOf&) = default;
};

/// The sorted results of all structures.
struct GeometryState {
  int dimension = -1;
  std::vector<Vec2> sites;
  std::vector<EdgeState> edges;
  std::vector<NodeStateOf> nodes;
  std::vector<std::vector<Vec2>> chains;  ///< in their own order; closed ones repeat the first site
  std::vector<std::array<double, 4>> normals;
  std::vector<std::array<double, 3>> balls;  ///< user balls of the document: centre and radius
  std::vector<std::vector<Vec2>> poles;      ///< a sample, then all samples on its polar circles
  std::size_t odd = 0;
  std::size_t lone = 0;
  std::size_t conflicts = 0;
};

GeometryState state_of(const Graph& graph);

/// Empty if equal, otherwise the first difference.
std::string difference(const GeometryState& a, const GeometryState& b);

/// Empty if all references between rows are consistent, otherwise the first broken one.
std::string broken_row(const Graph& graph);

}  // namespace mes::test
