// SPDX-License-Identifier: GPL-3.0-or-later
// Common code for several layers: parts over the common tables, and the duals of edges.
#pragma once

#include <initializer_list>
#include <utility>

#include "core/graph/layer.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

template <class... Parts>
Layer make_layer(LayerDescriptor descriptor, std::vector<const Structure*> structures, Parts... parts) {
  Layer layer{std::move(descriptor), std::move(structures), {}};
  for (const Structure* structure : layer.structures) layer.descriptor.structures.emplace_back(structure->id());
  (layer.parts.push_back(std::move(parts)), ...);
  return layer;
}

/// Calls `emit(edge, instance)` for live Delaunay edges.
template <class Emit>
struct EdgeEmit {
  const Delaunay& delaunay;
  Emit emit;
  void operator()(EdgeSlot edge, Instance& out) const {
    if (delaunay.edge(edge).is_alive()) emit(edge, out);
  }
  void expect(EdgeSlot edge) const { prefetch(delaunay.edges().address(edge)); }
  void expect_more(EdgeSlot edge) const {
    for (const FaceSlot face : delaunay.edge(edge).f)
      if (face != kNoSlot) prefetch(delaunay.faces().address(face));
    for (const SiteSlot site : delaunay.edge(edge).v)
      if (site != kNoSlot) prefetch(delaunay.site_positions().address(site));
  }
};

/// Part over live Delaunay edges.
template <class Emit>
auto edges_part(std::vector<PrimitiveKind> kinds, const Delaunay& delaunay, const ChangeSet<EdgeSlot>& changes,
                Emit emit) {
  return table_part(
      std::move(kinds), [&delaunay] { return delaunay.edge_rows(); }, changes, EdgeEmit<Emit>{delaunay, emit},
      ElementType{ElementKind::delaunay_edge});
}

/// Calls `emit(face, instance)` for live finite faces.
template <class Emit>
struct FaceEmit {
  const Delaunay& delaunay;
  Emit emit;
  void operator()(FaceSlot face, Instance& out) const {
    if (delaunay.is_finite_face(face)) emit(face, out);
  }
  void expect(FaceSlot face) const { prefetch(delaunay.faces().address(face)); }
  void expect_more(FaceSlot /*face*/) const {}
};

/// Part over live finite faces, which are the Voronoi vertices.
template <class Emit>
auto faces_part(std::vector<PrimitiveKind> kinds, const Delaunay& delaunay, const ChangeSet<FaceSlot>& changes,
                Emit emit) {
  return table_part(
      std::move(kinds), [&delaunay] { return delaunay.face_rows(); }, changes, FaceEmit<Emit>{delaunay, emit},
      ElementType{ElementKind::voronoi_vertex});
}

/// Part over live sites.
template <class Emit>
auto sites_part(std::vector<PrimitiveKind> kinds, const Delaunay& delaunay, const ChangeSet<SiteSlot>& changes,
                Emit emit) {
  return table_part(
      std::move(kinds), [&delaunay] { return delaunay.site_rows(); }, changes,
      [&delaunay, emit](SiteSlot site, Instance& out) {
        if (delaunay.is_site(site)) emit(site, out);
      },
      ElementType{ElementKind::site});
}

/// Draws the Delaunay edge.
inline void emit_edge(const Delaunay& delaunay, EdgeSlot edge, Instance& out, double scalar = 0.0) {
  const EdgeRow& row = delaunay.edge(edge);
  out.segment(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1]), scalar);
}

/// Draws the Voronoi edge dual to a Delaunay edge: a segment, a ray for a hull edge, a line when all sites are
/// collinear. A dual of length exactly zero has equal ends.
inline void emit_dual(const Delaunay& delaunay, const OneStepCrust& crust, EdgeSlot edge, Instance& out,
                      double scalar = 0.0) {
  const EdgeRow& row = delaunay.edge(edge);
  const Vec2 a = delaunay.site_position(row.v[0]);
  const Vec2 b = delaunay.site_position(row.v[1]);
  if (row.f[0] == kNoSlot) {
    out.line({0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y}, perpendicular(b - a), scalar);
    return;
  }
  const bool left_finite = !delaunay.face(row.f[0]).is_infinite();
  const bool right_finite = !delaunay.face(row.f[1]).is_infinite();
  const Vec2 left = delaunay.circumcenter(row.f[0]);
  const Vec2 right = delaunay.circumcenter(row.f[1]);
  if (left_finite && right_finite) {
    if (crust.is_cocircular(edge)) {
      // Both faces have the same point, rounded differently; which face is the left one depends on history.
      const Vec2 middle = lexicographically_less(right, left) ? right : left;
      out.segment(middle, middle, scalar);
    } else {
      out.segment(left, right, scalar);
    }
  } else if (left_finite) {
    out.ray(left, -perpendicular(b - a), scalar);
  } else {
    out.ray(right, perpendicular(b - a), scalar);
  }
}

/// Radius of the Voronoi balls along the dual: half the edge, the contact spread of the axis there.
inline double contact_spread(const Delaunay& delaunay, EdgeSlot edge) {
  const EdgeRow& row = delaunay.edge(edge);
  return 0.5 * distance(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1]));
}

/// Draws a ball as a disk, a circle or its centre, with the radius as scalar.
inline void draw_ball(PrimitiveKind kind, const Disk& ball, Instance& out) {
  if (kind == PrimitiveKind::disk) out.disk(ball.center, ball.radius, ball.radius);
  if (kind == PrimitiveKind::circle) out.circle(ball.center, ball.radius, ball.radius);
  if (kind == PrimitiveKind::point) out.point(ball.center, ball.radius);
}

}  // namespace mes
