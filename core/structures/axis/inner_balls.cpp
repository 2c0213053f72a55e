// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/axis/inner_balls.h"

#include <algorithm>
#include <limits>

namespace mes {

InnerBalls::InnerBalls(Delaunay& delaunay, VoronoiVertices& vertices, Labels& labels)
    : Structure("inner-balls", {&delaunay, &vertices, &labels}),
      delaunay_(delaunay),
      vertices_(vertices),
      labels_(labels) {}

void InnerBalls::rebuild(JobControl&) {
  clear_changes();
}

bool InnerBalls::update(JobControl&) {
  const ChangeSet<FaceSlot>& faces = labels_.face_changes();
  const ChangeSet<FaceSlot>& vertices = vertices_.changes();
  if (vertices_.follows_faces()) {
    changes_ = faces;
    return true;
  }
  recorder_.begin(delaunay_.face_rows());
  for (const ChangeSet<FaceSlot>* changes : {&faces, &vertices}) {
    for (const FaceSlot face : changes->removed) recorder_.note(face, true);
    for (const FaceSlot face : changes->touched) recorder_.note(face, true);
  }
  recorder_.finish(changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  return true;
}

StatList InnerBalls::statistics() const {
  std::int64_t balls = 0;
  std::int64_t distinct = 0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.face(face).is_alive() || !is_ball(face)) continue;
    ++balls;
    distinct += ball(face) == face ? 1 : 0;
    smallest = std::min(smallest, delaunay_.circumradius(face));
    largest = std::max(largest, delaunay_.circumradius(face));
  }
  return {{"balls", balls}, {"distinct", distinct}, {"radius_min", smallest}, {"radius_max", largest}};
}

}  // namespace mes
