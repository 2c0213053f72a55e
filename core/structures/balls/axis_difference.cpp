// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/axis_difference.h"

#include <algorithm>
#include <set>
#include <utility>

namespace mes {

AxisDifference::AxisDifference(Delaunay& delaunay, OneStepCrust& crust, InnerBalls& balls, MedialAxis& axis,
                               AUnion& a_union)
    : Structure("axis-difference", {&delaunay, &crust, &balls, &axis, &a_union}),
      delaunay_(delaunay),
      crust_(crust),
      balls_(balls),
      axis_(axis),
      union_(a_union) {}

void AxisDifference::rebuild(JobControl& job) {
  pieces_.clear();
  if (union_.rung() == UnionRung::shortcut || delaunay_.dimension() < 2) return;
  const auto key = [](FaceSlot a, FaceSlot b) { return std::pair(std::min(a, b), std::max(a, b)); };
  std::set<std::pair<FaceSlot, FaceSlot>> one_step;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (!row.is_alive() || !axis_.is_axis_edge(edge) || crust_.is_cocircular(edge)) continue;
    one_step.insert(key(balls_.ball(row.f[0]), balls_.ball(row.f[1])));
  }
  job.checkpoint();
  std::set<std::pair<FaceSlot, FaceSlot>> common;
  for (const AxisPiece& piece : union_.tables().axis) {
    if (!piece.is_alive() || piece.is_zero != 0) continue;
    // Nodes that are not balls come after all faces, so no pair of the one-step axis contains them.
    const auto pair = key(same_row<FaceSlot>(piece.node[0]), same_row<FaceSlot>(piece.node[1]));
    if (one_step.contains(pair)) {
      common.insert(pair);
    } else {
      pieces_.push_back({piece.a, piece.b, false});
    }
  }
  for (const auto& pair : one_step)
    if (!common.contains(pair))
      pieces_.push_back({delaunay_.circumcenter(pair.first), delaunay_.circumcenter(pair.second), true});
}

bool AxisDifference::update(JobControl&) {
  return union_.rung() == UnionRung::shortcut && pieces_.empty();
}

StatList AxisDifference::statistics() const {
  const auto only = std::ranges::count(pieces_, true, &Piece::only_one_step);
  return {{"only_one_step", static_cast<std::int64_t>(only)},
          {"only_union", static_cast<std::int64_t>(pieces_.size()) - static_cast<std::int64_t>(only)}};
}

}  // namespace mes
