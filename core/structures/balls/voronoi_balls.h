// SPDX-License-Identifier: GPL-3.0-or-later
// Families of Voronoi balls: circumdisks of Delaunay faces. Rows: the faces; of those with one circle, the one that
// `VoronoiVertices` names.
#pragma once

#include "core/structures/balls/ball_family.h"
#include "core/structures/crust/voronoi_vertices.h"

namespace mes {

/// All Voronoi balls; subclasses choose. Rows of the family are rows of faces.
class VoronoiBalls : public BallFamily {
 public:
  VoronoiBalls(const Delaunay& delaunay, const VoronoiVertices& vertices)
      : delaunay_(delaunay), vertices_(vertices) {}
  static FaceSlot face_of(FamilySlot row) { return same_row<FaceSlot>(row); }

  std::size_t rows() const override { return delaunay_.face_rows(); }
  std::string_view rows_of() const override { return "delaunay/faces"; }
  bool is_ball(FamilySlot row) const override { return vertices_.is_vertex(face_of(row)); }
  Disk plain_disk(FamilySlot row) const override {
    return {delaunay_.circumcenter(face_of(row)), delaunay_.circumradius(face_of(row))};
  }
  bool is_from_samples() const override { return true; }
  std::array<Vec2, 3> corners(FamilySlot row) const override {
    const FaceRow& face = delaunay_.face(face_of(row));
    return {delaunay_.site_position(face.v[0]), delaunay_.site_position(face.v[1]),
            delaunay_.site_position(face.v[2])};
  }
  void touched_samples(FamilySlot row, std::vector<TouchedSample>& out) const override {
    thread_local std::vector<SiteSlot> sites;  // kept for its memory
    sites.clear();
    vertices_.append_sites(face_of(row), sites);
    for (const SiteSlot site : sites) out.push_back({site, delaunay_.site_position(site)});
  }
  bool has_changed() const override { return !vertices_.changes().is_empty(); }

 protected:
  const Delaunay& delaunay_;
  const VoronoiVertices& vertices_;
};

}  // namespace mes
