// SPDX-License-Identifier: GPL-3.0-or-later
// The inner balls that touch a sample, in their order around it.
#pragma once

#include <vector>

#include "core/structures/axis/inner_balls.h"

namespace mes {

struct SectorBall {
  FaceSlot ball;  ///< the face that stands for the ball
  FaceSlot face;  ///< one of its faces at the site
  EdgeSlot edge;  ///< Delaunay edge between it and the ball before; kNoSlot for the first
};

/// Writes the distinct inner balls around the site, counter-clockwise from its border edge. For sites with two border
/// edges; for others it finds only some of the balls.
inline void collect_sector(const Delaunay& delaunay, const Labels& labels, const InnerBalls& balls, SiteSlot site,
                           std::vector<SectorBall>& out) {
  out.clear();
  if (delaunay.dimension() < 2) return;
  const auto next_face = [&](FaceSlot face) {
    const FaceRow& row = delaunay.face(face);
    return row.n[next3(row.index_of_site(site))];
  };
  const FaceSlot start = delaunay.site_face(site);
  FaceSlot first = start;
  bool found = false;
  do {
    const FaceSlot next = next_face(first);
    found = !labels.is_inside(first) && labels.is_inside(next);
    first = next;
  } while (!found && first != start);
  if (!found) return;
  FaceSlot face = first;
  EdgeSlot edge;
  while (labels.is_inside(face)) {
    const FaceSlot ball = balls.ball(face);
    if (out.empty() || out.back().ball != ball) out.push_back({ball, face, edge});
    const FaceRow& row = delaunay.face(face);
    edge = row.e[next3(row.index_of_site(site))];
    face = next_face(face);
  }
}

}  // namespace mes
