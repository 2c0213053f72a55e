// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/axis/medial_axis.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/sum.h"

namespace mes {

MedialAxis::MedialAxis(Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls)
    : Structure("medial-axis", {&delaunay, &crust, &labels, &balls}),
      delaunay_(delaunay),
      crust_(crust),
      labels_(labels),
      balls_(balls) {}

int MedialAxis::axis_edges_at(FaceSlot face) const {
  int count = 0;
  const FaceRow& row = delaunay_.face(face);
  for (int i = 0; i < 3; ++i) {
    if (row.e[i] == kNoSlot || crust_.is_cocircular(row.e[i])) continue;
    count += labels_.is_inside(row.n[i]) && !crust_.is_shared(row.e[i]) ? 1 : 0;
  }
  return count;
}

int MedialAxis::node_degree(FaceSlot face) const {
  const std::vector<FaceSlot>* group = balls_.group(face);
  if (group == nullptr) return axis_edges_at(face);
  int degree = 0;
  for (const FaceSlot member : *group) degree += axis_edges_at(member);
  return degree;
}

StatList MedialAxis::statistics() const {
  DisjointSets<FaceSlot> joined(delaunay_.face_rows());
  std::int64_t nodes = 0;
  std::int64_t leaves = 0;
  std::int64_t branch_points = 0;
  std::int64_t isolated = 0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.face(face).is_alive() || !is_node(face)) continue;
    ++nodes;
    const int degree = node_degree(face);
    leaves += degree == 1 ? 1 : 0;
    branch_points += degree >= 3 ? 1 : 0;
    isolated += degree == 0 ? 1 : 0;
    smallest = std::min(smallest, delaunay_.circumradius(face));
    largest = std::max(largest, delaunay_.circumradius(face));
  }
  std::int64_t edges = 0;
  std::int64_t components = nodes;
  Sum length_sum;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    delaunay_.expect_faces_after(edge);
    if (!delaunay_.edge(edge).is_alive() || !is_axis_edge(edge) || is_zero_length(edge)) continue;
    const EdgeRow& row = delaunay_.edge(edge);
    ++edges;
    length_sum.add(delaunay_.dual_length(edge));
    const FaceSlot a = joined.root(balls_.ball(row.f[0]));
    const FaceSlot b = joined.root(balls_.ball(row.f[1]));
    if (a == b) continue;
    joined.join(b, a);
    --components;
  }
  return {{"nodes", nodes},
          {"edges", edges},
          {"components", components},
          {"cycles", edges - nodes + components},
          {"chi", nodes - edges},
          {"leaves", leaves},
          {"branch_points", branch_points},
          {"isolated", isolated},
          {"length", length_sum.value()},
          {"radius_min", smallest},
          {"radius_max", largest}};
}

}  // namespace mes
