// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of rows of `Delaunay`, for the explanations of the structures that share its rows.
#pragma once

#include "core/graph/explain.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Adds the Voronoi edge dual to a Delaunay edge: a ray if it leads to infinity, a line between collinear sites.
void add_dual(ProvenanceShapes& shapes, const Delaunay& delaunay, EdgeSlot edge);
/// Adds a finite face.
void add_triangle(ProvenanceShapes& shapes, const Delaunay& delaunay, FaceSlot face);

/// The position of a site, attached to its first sample.
ShapePlace place_of(const Delaunay& delaunay, SiteSlot site);
/// The corners of a finite face, whose circle has the Voronoi vertex as its centre.
Followed corners_of(const Delaunay& delaunay, FaceSlot face);
inline ShapePlace place_of(const Delaunay& delaunay, FaceSlot face) {
  return {delaunay.circumcenter(face), corners_of(delaunay, face)};
}

inline Disk circumdisk(const Delaunay& delaunay, FaceSlot face) {
  return {delaunay.circumcenter(face), delaunay.circumradius(face)};
}

// Lines of text to which several structures add.
void say_samples_on_circle(Explanation& out, ProvenanceShapes& samples);
void say_triangles_on_circle(Explanation& out, ProvenanceShapes& triangles);

}  // namespace mes
