// SPDX-License-Identifier: GPL-3.0-or-later
// Families of Voronoi balls: circumdisks of Delaunay faces. Rows: the faces, of those with one circle the one that
// `VoronoiVertices` names.
#pragma once

#include "core/structures/balls/ball_family.h"
#include "core/structures/crust/voronoi_vertices.h"

namespace mes {

/// All of them; subclasses choose.
class VoronoiBalls : public BallFamily {
 public:
  VoronoiBalls(const Delaunay& delaunay, const VoronoiVertices& vertices)
      : delaunay_(delaunay), vertices_(vertices) {}
  std::size_t rows() const override { return delaunay_.face_rows(); }
  bool is_ball(Slot row) const override { return vertices_.is_vertex(row); }
  Disk plain_disk(Slot row) const override { return {delaunay_.circumcenter(row), delaunay_.circumradius(row)}; }
  bool is_from_samples() const override { return true; }
  std::array<Vec2, 3> corners(Slot row) const override {
    const FaceRow& face = delaunay_.face(row);
    return {delaunay_.site_position(face.v[0]), delaunay_.site_position(face.v[1]),
            delaunay_.site_position(face.v[2])};
  }
  void touched_samples(Slot row, std::vector<TouchedSample>& out) const override {
    thread_local std::vector<Slot> sites;  // kept for its memory
    sites.clear();
    vertices_.append_sites(row, sites);
    for (const Slot site : sites) out.push_back({site, delaunay_.site_position(site)});
  }
  const ChangeSet& changes() const override { return vertices_.changes(); }

 protected:
  const Delaunay& delaunay_;
  const VoronoiVertices& vertices_;
};

}  // namespace mes
