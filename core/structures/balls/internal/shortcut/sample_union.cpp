// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/shortcut/sample_union.h"

#include <cmath>

#include "core/base/sum.h"

namespace mes {
namespace {

// Rows of the union that belong to rows of the triangulation.
FamilySlot ball_at(FaceSlot face) {
  return same_row<FamilySlot>(face);
}
VPointSlot v_point_at(SiteSlot site) {
  return same_row<VPointSlot>(site);
}
VOriginSlot origin_at(SiteSlot site) {
  return same_row<VOriginSlot>(site);
}
ArcSlot arc_at(EdgeSlot edge) {
  return same_row<ArcSlot>(edge);
}
AxisPieceSlot piece_at(DualEdgeSlot edge) {
  return same_row<AxisPieceSlot>(edge);
}

}  // namespace

void SampleUnion::grow(UnionTables& t) const {
  t.balls.resize(delaunay_.face_rows(), BallState::none);
  t.v_points.resize(delaunay_.site_rows());
  t.v_origins.resize(delaunay_.site_rows());
  t.arcs.resize(delaunay_.edge_rows());
}

void SampleUnion::count_balls(SiteSlot site) {
  balls_at_[site] = 0;
  if (!delaunay_.is_site(site)) return;
  collect_sector(delaunay_, labels_, balls_, site, sector_);
  balls_at_[site] = static_cast<std::uint32_t>(sector_.size());
}

void SampleUnion::remake_ball(UnionTables& t, FaceSlot face) const {
  t.balls[ball_at(face)] = BallState::none;
  if (!delaunay_.face(face).is_alive() || !axis_.is_node(face)) return;
  t.balls[ball_at(face)] = axis_.node_degree(face) == 0 ? BallState::isolated : BallState::visible;
}

DualEdgeSlot SampleUnion::new_edge(UnionTables& t, FaceSlot a, FaceSlot b, DualClass kind) {
  DualEdgeSlot row = t.dual_edges.next();
  if (free_edges_.empty()) {
    t.dual_edges.emplace_back();
    t.axis.emplace_back();
    next_edge_.push_back(kNoSlot);
  } else {
    row = free_edges_.back();
    free_edges_.pop_back();
  }
  note_edge(t, row);
  t.dual_edges[row] = DualEdge{{ball_at(a), ball_at(b)}, kind};
  t.axis[piece_at(row)] = AxisPiece{};
  return row;
}

void SampleUnion::free_edge(UnionTables& t, DualEdgeSlot row) {
  note_edge(t, row);
  t.dual_edges[row] = DualEdge{};
  t.axis[piece_at(row)] = AxisPiece{};
  free_edges_.push_back(row);
}

// Two balls that share a Voronoi edge give a dual edge and a piece of the axis at once. At each of its two samples the
// edge bounds a dual triangle if a third ball touches the sample.
void SampleUnion::remake_chain(UnionTables& t, EdgeSlot edge) {
  const EdgeRow& row = delaunay_.edge(edge);
  const bool is_chain =
      row.is_alive() && row.f[0] != kNoSlot && axis_.is_axis_edge(edge) && !crust_.is_cocircular(edge);
  if (!is_chain) {
    if (chain_row_[edge] != kNoSlot) free_edge(t, chain_row_[edge]);
    chain_row_[edge] = kNoSlot;
    return;
  }
  const FaceSlot a = balls_.ball(row.f[0]);
  const FaceSlot b = balls_.ball(row.f[1]);
  const int triangles = (balls_at_[row.v[0]] >= 3 ? 1 : 0) + (balls_at_[row.v[1]] >= 3 ? 1 : 0);
  if (chain_row_[edge] == kNoSlot) chain_row_[edge] = new_edge(t, a, b, DualClass::singular);
  const DualEdgeSlot own = chain_row_[edge];
  note_edge(t, own);
  t.dual_edges[own] = DualEdge{{ball_at(a), ball_at(b)}, static_cast<DualClass>(triangles)};
  t.axis[piece_at(own)] = AxisPiece{delaunay_.circumcenter(a),
                                    delaunay_.circumcenter(b),
                                    delaunay_.circumradius(a),
                                    delaunay_.circumradius(b),
                                    {node_of(ball_at(a)), node_of(ball_at(b))},
                                    {v_point_at(row.v[0]), v_point_at(row.v[1])},
                                    static_cast<std::uint8_t>(triangles == 0 ? 1 : 0)};
}

// The polygon of the balls around the sample: its closing edge, and a fan from the first ball.
void SampleUnion::remake_site(UnionTables& t, SiteSlot site) {
  for (DualEdgeSlot row = first_edge_[site]; row != kNoSlot;) {
    const DualEdgeSlot next = next_edge_[row];
    free_edge(t, row);
    row = next;
  }
  first_edge_[site] = kNoSlot;
  for (DualFaceSlot row = first_face_[site]; row != kNoSlot;) {
    const DualFaceSlot next = next_face_[row];
    note_face(t, row);
    t.dual_faces[row] = DualFace{};
    free_faces_.push_back(row);
    row = next;
  }
  first_face_[site] = kNoSlot;
  if (is_recording_) v_recorder_.note(v_point_at(site), t.v_points[v_point_at(site)].is_alive());
  t.v_points[v_point_at(site)] = VPoint{};
  t.v_origins[origin_at(site)] = VOrigin{};
  const std::uint32_t count = balls_at_[site];
  if (count < 2) return;

  collect_sector(delaunay_, labels_, balls_, site, sector_);
  t.v_points[v_point_at(site)] = VPoint{delaunay_.site_position(site), site, count};
  if (count == 2) {
    t.v_origins[origin_at(site)] = VOrigin{v_point_at(site), chain_row_[sector_[1].edge]};
    return;
  }
  const auto own_edge = [&](FaceSlot a, FaceSlot b, DualClass kind) {
    const DualEdgeSlot row = new_edge(t, a, b, kind);
    next_edge_[row] = first_edge_[site];
    first_edge_[site] = row;
    return row;
  };
  const FaceSlot first = sector_.front().ball;
  t.v_origins[origin_at(site)] = VOrigin{v_point_at(site), own_edge(sector_.back().ball, first, DualClass::regular)};
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    if (i >= 2) own_edge(first, sector_[i].ball, DualClass::interior);
    DualFaceSlot row = t.dual_faces.next();
    if (free_faces_.empty()) {
      t.dual_faces.emplace_back();
      next_face_.push_back(kNoSlot);
    } else {
      row = free_faces_.back();
      free_faces_.pop_back();
    }
    note_face(t, row);
    t.dual_faces[row] = DualFace{{ball_at(first), ball_at(sector_[i].ball), ball_at(sector_[i + 1].ball)}, 0, 1};
    next_face_[row] = first_face_[site];
    first_face_[site] = row;
  }
}

void SampleUnion::remake_arc(UnionTables& t, EdgeSlot edge) const {
  t.arcs[arc_at(edge)] = BoundaryArc{};
  const EdgeRow& row = delaunay_.edge(edge);
  if (!row.is_alive() || !certificate_.is_border(edge)) return;
  // The arc runs counter-clockwise around the ball, in the direction of the edge if the ball is to the edge's left.
  const bool is_left = labels_.is_inside(row.f[0]);
  t.arcs[arc_at(edge)] =
      BoundaryArc{ball_at(balls_.ball(row.f[is_left ? 0 : 1])), 0, delaunay_.site_position(row.v[is_left ? 0 : 1]),
                  delaunay_.site_position(row.v[is_left ? 1 : 0])};
}

void SampleUnion::rebuild(UnionTables& t, JobControl& job) {
  is_recording_ = false;
  t = UnionTables{};
  next_edge_.clear();
  next_face_.clear();
  free_edges_.clear();
  free_faces_.clear();
  balls_at_.assign(delaunay_.site_rows(), 0);
  chain_row_.assign(delaunay_.edge_rows(), kNoSlot);
  first_edge_.assign(delaunay_.site_rows(), kNoSlot);
  first_face_.assign(delaunay_.site_rows(), kNoSlot);
  grow(t);
  if (delaunay_.dimension() < 2) return;
  for (const FaceSlot face : delaunay_.face_slots()) remake_ball(t, face);
  for (const SiteSlot site : delaunay_.site_slots()) count_balls(site);
  job.checkpoint();
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    remake_chain(t, edge);
    remake_arc(t, edge);
  }
  job.checkpoint();
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site)) remake_site(t, site);
}

void SampleUnion::update(UnionTables& t, UnionChanges& changes) {
  is_recording_ = true;
  balls_at_.resize(delaunay_.site_rows(), 0);
  chain_row_.resize(delaunay_.edge_rows(), kNoSlot);
  first_edge_.resize(delaunay_.site_rows(), kNoSlot);
  first_face_.resize(delaunay_.site_rows(), kNoSlot);
  grow(t);
  ball_recorder_.begin(delaunay_.face_rows());
  edge_recorder_.begin(t.dual_edges.size());
  face_recorder_.begin(t.dual_faces.size());
  v_recorder_.begin(delaunay_.site_rows());
  arc_recorder_.begin(delaunay_.edge_rows());
  site_marks_.begin(delaunay_.site_rows());
  edge_marks_.begin(delaunay_.edge_rows());
  sites_.clear();
  edges_.clear();

  const auto touch_edge = [&](EdgeSlot edge) {
    if (edge_marks_.insert(edge)) edges_.push_back(edge);
  };
  const auto touch_site = [&](SiteSlot site) {
    if (site == kInfiniteSite || !site_marks_.insert(site)) return;
    sites_.push_back(site);
    if (delaunay_.is_site(site) && delaunay_.dimension() == 2)
      delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) { touch_edge(edge); });
  };
  const auto touch_ball = [&](FaceSlot face) {
    ball_recorder_.note(ball_at(face), t.balls[ball_at(face)] != BallState::none);
    remake_ball(t, face);
  };
  // A ball's state depends on the faces next to its own.
  for (const ChangeSet<FaceSlot>* faces : {&labels_.face_changes(), &balls_.changes()}) {
    for (const FaceSlot face : faces->removed) touch_ball(face);
    for (const FaceSlot face : faces->touched) {
      if (!delaunay_.face(face).is_alive()) continue;
      for (const SiteSlot site : delaunay_.face(face).v) touch_site(site);
      touch_ball(face);
      touch_ball(balls_.ball(face));
      for (const FaceSlot other : delaunay_.face(face).n) {
        touch_ball(other);
        touch_ball(balls_.ball(other));
      }
    }
  }
  for (const SiteSlot site : delaunay_.site_changes().removed) touch_site(site);
  for (const SiteSlot site : delaunay_.site_changes().touched) touch_site(site);
  for (const EdgeSlot edge : labels_.edge_changes().removed) touch_edge(edge);
  for (const EdgeSlot edge : labels_.edge_changes().touched) touch_edge(edge);

  for (const SiteSlot site : sites_) count_balls(site);
  for (const EdgeSlot edge : edges_) {
    remake_chain(t, edge);
    arc_recorder_.note(arc_at(edge), t.arcs[arc_at(edge)].is_alive());
    remake_arc(t, edge);
  }
  for (const SiteSlot site : sites_) remake_site(t, site);

  ball_recorder_.finish(changes.balls, [&](FamilySlot ball) { return t.balls[ball] != BallState::none; });
  edge_recorder_.finish(changes.dual_edges, [&](DualEdgeSlot row) { return t.dual_edges[row].is_alive(); });
  face_recorder_.finish(changes.dual_faces, [&](DualFaceSlot row) { return t.dual_faces[row].is_alive(); });
  v_recorder_.finish(changes.v_points, [&](VPointSlot row) { return t.v_points[row].is_alive(); });
  arc_recorder_.finish(changes.arcs, [&](ArcSlot row) { return t.arcs[row].is_alive(); });
}

// The union consists of the inside triangles and of the circular segments beyond the border edges.
UnionMeasures SampleUnion::measures() const {
  Sum area, perimeter, axis_length;
  const auto at = [this](SiteSlot site) { return delaunay_.site_position(site); };
  for (const FaceSlot face : delaunay_.face_slots()) {
    const FaceRow& row = delaunay_.face(face);
    if (!row.is_alive() || !labels_.is_inside(face)) continue;
    const Vec2 corner = at(row.v[0]);
    area.add(0.5 * cross(at(row.v[1]) - corner, at(row.v[2]) - corner));
  }
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    const EdgeRow& row = delaunay_.edge(edge);
    if (!row.is_alive()) continue;
    if (chain_row_[edge] != kNoSlot) axis_length.add(delaunay_.dual_length(edge));
    if (!certificate_.is_border(edge)) continue;
    // The arc turns through twice the angle at the third corner of its triangle.
    const FaceSlot inner = row.f[labels_.is_inside(row.f[0]) ? 0 : 1];
    const FaceRow& face = delaunay_.face(inner);
    const Vec2 apex = at(face.v[face.index_of_edge(edge)]);
    const Vec2 p = at(row.v[0]) - apex;
    const Vec2 q = at(row.v[1]) - apex;
    const double angle = std::atan2(std::abs(cross(p, q)), dot(p, q));
    const double radius = 0.5 * distance(at(row.v[0]), at(row.v[1])) / std::sin(angle);
    perimeter.add(2.0 * radius * angle);
    area.add(radius * radius * (angle - std::sin(angle) * std::cos(angle)));
  }
  return {area.value(), perimeter.value(), axis_length.value(),
          area.left_out() + perimeter.left_out() + axis_length.left_out()};
}

}  // namespace mes
