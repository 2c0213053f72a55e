// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of the Voronoi diagram of the samples as polygons.
#pragma once

#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/table.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// The Voronoi vertices of a triangulation, which must outlive this and stay as it is, and the cells between them.
///
/// Guarantee: corners of cells are Voronoi vertices, corners of the box, and points where Voronoi edges leave the box.
/// Cells that meet at one of them have it to the last bit, so the cells of all sites cover the box without gaps.
///
/// Smallest use:
///     const VoronoiCells cells(delaunay);
///     std::vector<Vec2> corners = cells.cell(site, box);
///
/// Cost: O(faces) to make, with one exact test an edge.
class VoronoiCells {
 public:
  explicit VoronoiCells(const Delaunay& delaunay);

  /// The part of a site's cell within a box: a convex polygon, counter-clockwise, without its first corner repeated.
  /// The box has all sites in its inside. O(edges at the site).
  std::vector<Vec2> cell(SiteSlot site, const Box2& box) const;

 private:
  const Delaunay& delaunay_;
  Table<FaceSlot, Vec2> vertex_;  // one place for all faces on one circle; infinite for faces without
};

}  // namespace mes
