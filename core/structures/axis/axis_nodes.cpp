// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/axis/axis_nodes.h"

#include <algorithm>
#include <vector>

namespace mes {

AxisNodes::AxisNodes(Delaunay& delaunay, InnerBalls& balls, MedialAxis& axis)
    : Structure("axis-nodes", {&delaunay, &balls, &axis}), delaunay_(delaunay), balls_(balls), axis_(axis) {}

void AxisNodes::rebuild(JobControl&) {
  clear_changes();
}

bool AxisNodes::update(JobControl&) {
  recorder_.begin(delaunay_.face_rows());
  for (const FaceSlot face : balls_.changes().removed) recorder_.note(face, true);
  for (const FaceSlot face : balls_.changes().touched) {
    recorder_.note(face, true);
    for (const FaceSlot other : delaunay_.face(face).n) recorder_.note(balls_.ball(other), true);
  }
  recorder_.finish(changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  return true;
}

StatList AxisNodes::statistics() const {
  std::vector<std::int64_t> histogram(4, 0);
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.face(face).is_alive() || !axis_.is_node(face)) continue;
    ++histogram[static_cast<std::size_t>(std::min(axis_.node_degree(face), 3))];
  }
  return {{"degree", histogram}};
}

}  // namespace mes
