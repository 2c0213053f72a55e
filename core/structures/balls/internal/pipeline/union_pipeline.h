// SPDX-License-Identifier: GPL-3.0-or-later
// The general way from balls to the medial axis of their union, in any number type. Each stage is a header that has its
// input and its output as types:
//
//   UnionBalls          the balls in the numbers of both kernels            numbers/union_balls.h
//   UnionTriangulation  their regular triangulation                         complex/union_triangulation.h
//   DualComplex         which of its triangles and edges are dual           complex/union_complex.h
//   VPoints             crossings of circles on the boundary of the union   crossings/union_crossings.h
//   VTriangulation      the Delaunay triangulation of these                 crossings/union_v_triangulation.h
//   UnionCircles        v-points and free arcs around each ball             axis/union_circles.h, union_centers.h
//   EdgeCuts            Voronoi edges of the v-points, cut and labelled     axis/edge_cuts.h
//   UnionFaces          circumcentres, where something is drawn             axis/union_axis.h
//   UnionAxis           the medial axis                                     axis/union_axis.h
//   UnionMeasures       area, perimeter, length of the axis                 axis/union_measures.h
//
// The axis consists of the singular dual edges and of the part of the Voronoi diagram of the v-points that lies in the
// union |R| of the dual triangles (Attali and Montanvert 1997). No point is located for that. The circle of a ball c
// holds v-points; none lies inside it, so c lies on the Voronoi edge of any two that are neighbours on the circle, and
// this edge leaves c towards the arc between them. The boundary of |R| is met at such centres only. The edge goes into
// |R| if the arc is covered by dual triangles at c, runs along a singular dual edge if that covers the arc, and leaves
// |R| if the arc is free. Parts between are labelled from their ends, since every part of the axis reaches a centre.
//
// `Balls` is the kernel of triangulation and dual complex, `Points` that of the v-points. For doubles (`fast`) each
// decision is exact for the doubles at hand, and the v-points are rounded; for `naive` nothing is exact.
#pragma once

#include <utility>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/axis/edge_cuts.h"
#include "core/structures/balls/internal/axis/union_axis.h"
#include "core/structures/balls/internal/axis/union_centers.h"
#include "core/structures/balls/internal/axis/union_circles.h"
#include "core/structures/balls/internal/axis/union_measures.h"
#include "core/structures/balls/internal/complex/union_complex.h"
#include "core/structures/balls/internal/complex/union_triangulation.h"
#include "core/structures/balls/internal/crossings/union_crossings.h"
#include "core/structures/balls/internal/crossings/union_v_triangulation.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/balls/internal/union_tables.h"

namespace mes::union_pipeline {

/// States by row of the family.
template <class Balls, class Points>
Table<FamilySlot, BallState> by_row(const UnionBalls<Balls, Points>& balls,
                                    const Table<InputSlot, BallState>& state) {
  Table<FamilySlot, BallState> out(balls.rows, BallState::none);
  for (const InputSlot i : state.rows()) out[balls.input[i].row] = state[i];
  return out;
}

/// Converts indices in the input to rows of the family.
template <class Balls, class Points>
Table<ArcSlot, BoundaryArc> by_row(const UnionBalls<Balls, Points>& balls, const std::vector<InputArc>& arcs) {
  Table<ArcSlot, BoundaryArc> out;
  out.reserve(arcs.size());
  for (const InputArc& arc : arcs)
    out.push_back({balls.input[arc.ball].row, arc.is_whole, arc.from, arc.to, arc.turn});
  return out;
}

inline Table<VEdgeSlot, VEdge> with_kinds(Table<VEdgeSlot, VEdge> edges, const Table<VEdgeSlot, VEdgeKind>& kind) {
  for (const VEdgeSlot e : edges.rows()) edges[e].kind = kind[e];
  return edges;
}

/// Moves the dual complex into tables.
inline void publish(const UnionTriangulation& triangulation, DualComplex& complex, UnionTables& out) {
  out.counts.triangulation_edges = static_cast<std::int64_t>(triangulation.tables.edges.size());
  out.counts.triangulation_faces = complex.finite_faces;
  out.counts.sign_flips = complex.sign_flips;
  out.counts.negative_faces = complex.negative_faces;
  out.counts.edges_without_sample = complex.edges_without_sample;
  out.dual_edges = std::move(complex.edges);
  out.dual_faces = std::move(complex.faces);
}

/// Moves the v-points and their Voronoi diagram into tables.
template <class Points>
void publish(VPoints<Points>& points, VTriangulation& v, const EdgeCuts& cuts, UnionFaces& faces, UnionTables& out) {
  out.counts.raw_v_points = points.raw_v_points;
  out.counts.roots = points.roots;
  out.counts.negative_radicands = points.negative_radicands;
  out.counts.near_duplicates = v.near_duplicates;
  out.v_points = std::move(points.rows);
  out.v_origins = std::move(points.origins);
  out.v_edges = with_kinds(std::move(v.edges), cuts.kind);
  out.v_faces = std::move(faces.rows);
}

template <class Balls, class Points>
UnionTables run(const PipelineInput& input, JobControl& job) {
  const UnionBalls<Balls, Points> balls(input);
  const UnionTriangulation triangulation = in_share(job, 0.25, [&] { return union_triangulation(balls, job); });
  const RegularTables& tables = triangulation.tables;
  DualComplex complex = in_share(job, 0.3, [&] { return dual_complex(balls, triangulation, job); });
  VPoints<Points> points = in_share(job, 0.7, [&] { return v_points(balls, tables, complex, job); });
  VTriangulation v = v_triangulation(points);
  UnionCircles circles =
      in_share(job, 0.9, [&] { return union_circles(balls, triangulation, complex, points, v, job); });
  CenterTables& centers = circles.centers;
  const EdgeCuts cuts = cut_edges(balls, points, v, std::move(centers.events), centers.ball_of_face);
  UnionFaces faces = place_faces(balls, points, v, centers.ball_of_face, cuts, job);
  UnionAxis axis = union_axis(balls, tables, complex, points, v, faces, cuts.cuts);
  UnionMeter meter(balls);
  meter.add_arcs(centers.arcs);
  meter.add_dual_edges(tables, complex, points);
  meter.add_dual_faces(tables, complex);
  meter.add_axis(axis);

  UnionTables out;
  out.measures = meter.measures();
  out.balls = by_row(balls, circles.state);
  out.arcs = by_row(balls, centers.arcs);
  out.axis = std::move(axis.pieces);
  publish(triangulation, complex, out);
  publish(points, v, cuts, faces, out);
  out.counts.lost_crossings = centers.lost_crossings;
  out.counts.contradictions = cuts.contradictions + axis.contradictions;
  return out;
}

/// Runs only the stages of the balls and the dual complex.
template <class Balls, class Points>
UnionTables run_dual_complex(const PipelineInput& input, JobControl& job) {
  const UnionBalls<Balls, Points> balls(input);
  const UnionTriangulation triangulation = in_share(job, 0.8, [&] { return union_triangulation(balls, job); });
  DualComplex complex = dual_complex(balls, triangulation, job);
  UnionTables out;
  out.balls = by_row(balls, triangulation.tables.state);
  publish(triangulation, complex, out);
  return out;
}

/// Runs only the Voronoi diagram, from v-points that are known.
template <class Balls, class Points>
UnionTables run_v_diagram(const PipelineInput& input, const KnownVPoints& known, JobControl& job) {
  const UnionBalls<Balls, Points> balls(input);
  VPoints<Points> points = in_share(job, 0.5, [&] { return known_v_points(balls, known, job); });
  VTriangulation v = v_triangulation(points);
  CenterTables centers = in_share(job, 0.9, [&] { return known_centers(balls, v, known, job); });
  const EdgeCuts cuts = cut_edges(balls, points, v, std::move(centers.events), centers.ball_of_face);
  UnionFaces faces = place_faces(balls, points, v, centers.ball_of_face, cuts, job);
  UnionTables out;
  publish(points, v, cuts, faces, out);
  return out;
}

}  // namespace mes::union_pipeline
