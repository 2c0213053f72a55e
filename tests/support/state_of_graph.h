// SPDX-License-Identifier: GPL-3.0-or-later
// The whole state of the geometry as values that do not depend on row numbers, for comparing two ways to the same
// samples.
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

/// A group of faces with one circumcircle: the sorted corners, whether it is a ball, and the degree as an axis node.
struct NodeStateOf {
  std::vector<Vec2> corners;
  bool inside = false;
  int degree = 0;
  friend bool operator==(const NodeStateOf&, const NodeStateOf&) = default;
};

/// Everything the structures say, sorted.
struct GeometryState {
  int dimension = -1;
  std::vector<Vec2> sites;
  std::vector<EdgeState> edges;
  std::vector<NodeStateOf> nodes;
  std::vector<std::vector<Vec2>> chains;  ///< in their own order; closed ones repeat the first site
  std::vector<std::array<double, 4>> normals;
  std::vector<std::array<double, 3>> balls;  ///< the document's own: centre and radius
  std::vector<std::vector<Vec2>> poles;      ///< a sample, then all samples on its polar circles
  std::size_t odd = 0;
  std::size_t conflicts = 0;
};

GeometryState state_of(const Graph& graph);

/// Empty when equal, otherwise what differs first.
std::string difference(const GeometryState& a, const GeometryState& b);

/// Empty when all rows refer to each other as they should, otherwise what does not.
std::string broken_row(const Graph& graph);

}  // namespace mes::test
