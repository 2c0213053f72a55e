// SPDX-License-Identifier: GPL-3.0-or-later
// Which Voronoi vertices of a sample are its poles: exact signs.
//
// The Voronoi vertices of sample p are the circumcentres of the triangles p, q, r around it. With u = q - p, v = r -
// p and D = det(u, v) > 0, the circumcentre lies at p + N / 2D where
//     N = (v_y |u|^2 - u_y |v|^2,  u_x |v|^2 - v_x |u|^2)
// and its distance from p is the circumradius, R^2 = |u|^2 |v|^2 |r - q|^2 / 4 D^2. So everything asked here is the
// sign of a polynomial in differences of coordinates:
//     distances of f and g     |u_f|^2 |v_f|^2 |w_f|^2 D_g^2  against the same with f and g exchanged   (degree 10)
//     which is left of which   N_f D_g  against  N_g D_f, first in x, then in y                         (degree 5)
//     same side                N_f . N_g                                                                (degree 6)
//     side of a hull sample    N . n_1 / |n_1| + N . n_2 / |n_2|, by squares where the terms differ in sign
//                                                                                                       (degree 10)
// Each is evaluated in doubles with a running error bound; then, for samples on a coarse grid, where ties are the rule,
// in 128-bit integers; then in rationals. Source: Amenta, Bern and Eppstein 1998; the polynomials are ours.
#pragma once

#include "core/base/geometry/vec2.h"

namespace mes {

/// A Delaunay triangle seen from its corner `p`; p, q, r counter-clockwise. Stars compared with each other share `p`.
struct StarTriangle {
  Vec2 p, q, r;
};

/// Circumradius in doubles with its error: |value - R^2| <= error, unless `error` is not finite.
struct RadiusKey {
  double value = 0.0;
  double error = 0.0;
};
RadiusKey radius_key(const StarTriangle& f);

/// Order of the distances of two circumcentres from p: -1, 0 or 1. Keys are those of the triangles.
int compare_pole_distance(const StarTriangle& f, const RadiusKey& key_f, const StarTriangle& g,
                          const RadiusKey& key_g);

/// Lexicographic order of the circumcentres: -1, 0 or 1; 0 exactly if the circumcircles are the same.
int compare_circumcenters(const StarTriangle& f, const StarTriangle& g);

/// Sign of (c_f - p) . (c_g - p): negative if the centres lie on different sides of p.
int sign_of_side(const StarTriangle& f, const StarTriangle& g);

/// Sign of (c_f - p) . d for a hull sample p, whose hull neighbours are `before` and `after`, counter-clockwise:
/// d is the sum of the unit outward normals of the two hull edges.
int sign_of_hull_side(const StarTriangle& f, Vec2 before, Vec2 after);

/// The direction d as a unit vector in doubles; for display and for the balls that stand for poles at infinity.
Vec2 hull_direction(Vec2 p, Vec2 before, Vec2 after);

}  // namespace mes
