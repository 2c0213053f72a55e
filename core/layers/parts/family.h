// SPDX-License-Identifier: GPL-3.0-or-later
// Common code for the layers of a union of balls: each exists once for every family of balls.
//
// Such a layer is made by a function `Layer make_union_name_layer(const UnionFamily&)` in core/layers/union. The list in
// union_layers.cpp adds it once for each family, with the letter of the family before its id and the name of the family
// before its name.
#pragma once

#include <string>

#include "core/layers/parts/helpers.h"
#include "core/structures/balls/axis_ball_union.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/grown_complex.h"

namespace mes {

struct UnionFamily {
  char letter;  ///< 'A'
  const BallUnion& balls;
  const PowerDiagram& power_diagram;
  const VDiagram& v_diagram;
  const BallSampling& sampling;
  const GrownComplex& grown;
  const AxisBallUnion& scaled;
  const BallSampling& scaled_sampling;
  const AxisBallUnion& skeleton;
  LayerGroup group;
  bool in_paper;  ///< the paper has this family
};

/// A layer of the family: `id` "v-points" becomes "a-v-points", `name` "boundary" becomes "Inner balls: boundary".
template <class... Parts>
Layer union_layer_of(const UnionFamily& family, const Structure& read, LayerDescriptor descriptor, Parts... parts) {
  descriptor.of_any_family = descriptor.id;
  const char small = static_cast<char>(family.letter - 'A' + 'a');
  descriptor.id = std::string{small, '-'} + descriptor.id;
  descriptor.name = std::string(title_of(family.group)) + ": " + descriptor.name;
  descriptor.group = family.group;
  descriptor.in_paper = descriptor.in_paper && family.in_paper;
  return make_layer(std::move(descriptor), {&family.balls, &read}, std::move(parts)...);
}
/// A layer of the grown balls, which does not need the union.
template <class... Parts>
Layer grown_layer(const UnionFamily& family, LayerDescriptor descriptor, Parts... parts) {
  Layer layer = union_layer_of(family, family.grown.filtration(), std::move(descriptor), std::move(parts)...);
  layer.structures.front() = &family.grown;
  layer.descriptor.structures.front() = family.grown.id();
  return layer;
}
/// A layer of the grown balls along the axis.
template <class... Parts>
Layer scale_layer(const UnionFamily& family, const AxisBallUnion& grown, LayerDescriptor descriptor, Parts... parts) {
  Layer layer = union_layer_of(family, grown, std::move(descriptor), std::move(parts)...);
  layer.structures.erase(layer.structures.begin());
  layer.descriptor.structures.erase(layer.descriptor.structures.begin());
  return layer;
}
template <class... Parts>
Layer union_layer(const UnionFamily& family, LayerDescriptor descriptor, Parts... parts) {
  Layer layer = union_layer_of(family, family.balls, std::move(descriptor), std::move(parts)...);
  layer.structures.pop_back();
  layer.descriptor.structures.pop_back();
  return layer;
}

template <class Value>
constexpr ElementKind kElementOf = ElementKind::other;
template <>
inline constexpr ElementKind kElementOf<DualEdge> = ElementKind::dual_edge;
template <>
inline constexpr ElementKind kElementOf<DualFace> = ElementKind::dual_face;
template <>
inline constexpr ElementKind kElementOf<VPoint> = ElementKind::v_point;
template <>
inline constexpr ElementKind kElementOf<VOrigin> = ElementKind::v_origin;
template <>
inline constexpr ElementKind kElementOf<AxisPiece> = ElementKind::axis_piece;
template <>
inline constexpr ElementKind kElementOf<VFace> = ElementKind::v_face;
template <>
inline constexpr ElementKind kElementOf<VEdge> = ElementKind::v_edge;
template <>
inline constexpr ElementKind kElementOf<BoundaryArc> = ElementKind::boundary_arc;

/// Part over a table of the union: `emit(row of the table, instance)`. Its change set is that of the table, or of a
/// table with the same rows (`UnionChanges`).
template <class Row, class Value, class ChangedRow, class Emit>
auto union_part(std::vector<PrimitiveKind> kinds, const BallUnion& balls, Table<Row, Value> UnionTables::*table,
                const ChangeSet<ChangedRow>& changes, Emit emit) {
  return table_part(
      std::move(kinds), [&balls, table] { return (balls.tables().*table).size(); }, changes,
      [&balls, table, emit](ChangedRow row, Instance& out) {
        emit((balls.tables().*table)[same_row<Row>(row)], out);
      },
      ElementType{kElementOf<Value>, &balls});
}

/// Part over the balls of a union: `emit(state, disk, instance)`.
template <class Emit>
auto ball_part(PrimitiveKind kind, const BallUnion& balls, Emit emit) {
  return table_part(
      {kind}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
      [&balls, emit](FamilySlot row, Instance& out) {
        if (balls.tables().balls[row] != BallState::none)
          emit(balls.tables().balls[row], balls.family().disk(row), out);
      },
      ElementType{ElementKind::ball, &balls});
}

/// The axis of a union of grown balls, with radii divided by the factor: its pieces, and the balls without a piece.
inline auto scale_axis_pieces(const BallUnion& balls) {
  return union_part({PrimitiveKind::segment}, balls, &UnionTables::axis, balls.changes().dual_edges,
                    [&balls](const AxisPiece& piece, Instance& out) {
                      if (piece.is_alive())
                        out.segment(piece.a, piece.b,
                                    0.5 * (piece.radius_a + piece.radius_b) / balls.family().scale());
                    });
}
inline auto scale_axis_points(const BallUnion& balls) {
  return ball_part(PrimitiveKind::point, balls, [&balls](BallState state, const Disk& disk, Instance& out) {
    if (state == BallState::isolated) out.point(disk.center, disk.radius / balls.family().scale());
  });
}
inline auto scale_axis_arcs(const BallUnion& balls) {
  return union_part({PrimitiveKind::arc}, balls, &UnionTables::arcs, balls.changes().arcs,
                    [&balls](const BoundaryArc& arc, Instance& out) {
                      if (!arc.is_alive()) return;
                      if (const auto drawn = drawn_arc(arc, balls.family().disk(arc.ball))) out.arc(*drawn);
                    });
}

template <class Emit>
auto power_part(std::vector<PrimitiveKind> kinds, const PowerDiagram& diagram, Emit emit) {
  return table_part(
      std::move(kinds), [&diagram] { return diagram.edges().size(); }, diagram.changes(),
      [&diagram, emit](PowerEdgeSlot row, Instance& out) { emit(diagram.edges()[row], out); },
      ElementType{ElementKind::power_edge, &diagram});
}

/// Draws an edge of the power diagram.
inline void emit_power_edge(const PowerEdge& edge, Instance& out) {
  switch (edge.kind) {
    case PowerEdge::Kind::segment: out.segment(edge.from, edge.to); break;
    case PowerEdge::Kind::ray: out.ray(edge.from, edge.to); break;
    case PowerEdge::Kind::line: out.line(edge.from, edge.to); break;
  }
}
/// Draws its dual edge of the regular triangulation.
inline void emit_centers(const PowerDiagram& diagram, const PowerEdge& edge, Instance& out) {
  out.segment(diagram.family().disk(edge.ball[0]).center, diagram.family().disk(edge.ball[1]).center);
}

template <class Row, class Value, class Emit>
auto v_part(std::vector<PrimitiveKind> kinds, const VDiagram& diagram, Table<Row, Value> UnionTables::*table,
            Emit emit) {
  return table_part(
      std::move(kinds), [&diagram, table] { return (diagram.tables().*table).size(); }, no_changes<Row>(),
      [&diagram, table, emit](Row row, Instance& out) { emit((diagram.tables().*table)[row], out); },
      ElementType{kElementOf<Value>, &diagram});
}

/// Part over sampled balls: `emit(disk, instance)`. `owner` explains the balls.
template <class Emit>
auto sampled_part(std::vector<PrimitiveKind> kinds, const SampledBalls& balls, Emit emit,
                  const Structure* owner = nullptr) {
  return table_part(
      std::move(kinds), [&balls] { return balls.rows(); }, balls.changes(),
      [&balls, emit](SampledSlot row, Instance& out) {
        if (balls.is_alive(row)) emit(balls.disk(row), out);
      },
      owner == nullptr ? ElementType{} : ElementType{ElementKind::sampled_ball, owner});
}

/// Draws the Voronoi edge between two v-points.
inline void emit_v_dual(const UnionTables& t, const VEdge& edge, Instance& out) {
  const Vec2 a = t.v_points[edge.v[0]].position;
  const Vec2 b = t.v_points[edge.v[1]].position;
  if (edge.f[0] != kNoSlot && edge.f[1] != kNoSlot) {
    const VFace& left = t.v_faces[edge.f[0]];
    const VFace& right = t.v_faces[edge.f[1]];
    const bool same_circle = left.ball != kNoSlot && left.ball == right.ball;
    const bool is_turned = same_circle && lexicographically_less(right.center, left.center);
    out.segment(is_turned ? right.center : left.center, same_circle && !is_turned ? left.center : right.center);
  } else if (edge.f[0] != kNoSlot) {
    out.ray(t.v_faces[edge.f[0]].center, -perpendicular(b - a));
  } else if (edge.f[1] != kNoSlot) {
    out.ray(t.v_faces[edge.f[1]].center, perpendicular(b - a));
  } else {
    out.line({0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y}, perpendicular(b - a));
  }
}

}  // namespace mes
