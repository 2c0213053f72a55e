// SPDX-License-Identifier: GPL-3.0-or-later
// Seventh stage of the union pipeline: edge cuts -> the medial axis, and the positions of its nodes. The axis consists
// of the cuts that lie in |R|, and of the singular dual edges.
#pragma once

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/base/sum.h"
#include "core/kernel/circumcircle.h"
#include "core/structures/balls/internal/axis/edge_cuts.h"
#include "core/structures/balls/internal/complex/union_complex.h"
#include "core/structures/balls/internal/complex/union_triangulation.h"
#include "core/structures/balls/internal/crossings/union_crossings.h"
#include "core/structures/balls/internal/crossings/union_v_triangulation.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// The faces of the triangulation of the v-points, with their circumcircles.
struct UnionFaces {
  Table<VFaceSlot, VFace> rows;
  Table<VFaceSlot, Vec2> local_center;  ///< rounded, in the frame
};

struct PlacedCircle {
  Circle local;
  Vec2 center;  ///< in the document
};

template <class Balls, class Points>
PlacedCircle placed_circumcircle(const UnionBalls<Balls, Points>& balls, const VPoints<Points>& points,
                                 const std::array<VPointSlot, 3>& v) {
  // Rounding must not depend on which corner comes first.
  std::array<VPointSlot, 3> first = v;
  std::ranges::rotate(first, std::ranges::min_element(first, lexicographically_less,
                                                      [&](VPointSlot corner) { return points.local[corner]; }));
  if constexpr (VPoints<Points>::kIsDouble) {
    const Circle circle = circumcircle(points.local[first[0]], points.local[first[1]], points.local[first[2]]);
    return {circle, balls.frame.to_document(circle.center)};
  } else {
    const PlacedPoint at =
        place_of_circumcenter(points.exact[v[0]], points.exact[v[1]], points.exact[v[2]], balls.frame);
    return {{at.local, distance(at.local, points.local[first[0]])}, at.document};
  }
}

template <class Balls, class Points>
UnionFaces place_faces(const UnionBalls<Balls, Points>& balls, const VPoints<Points>& points, const VTriangulation& v,
                       const Table<VFaceSlot, InputSlot>& ball_of_face, const EdgeCuts& cuts, JobControl& job) {
  UnionFaces out;
  out.rows.resize(v.faces.size());
  out.local_center.resize(v.faces.size());
  balls.in_parts(v.faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const VFaceSlot slot : slots_between<VFaceSlot>(begin, end)) {
      if ((slot.index() & 0xffU) == 0) job.checkpoint(slot.index() - begin, end - begin);
      VFace& face = out.rows[slot];
      std::ranges::copy(v.faces[slot], face.v);
      face.is_inside = cuts.is_inside[slot];
      if (ball_of_face[slot] != kNoSlot) {
        const PipelineBall& ball = balls.input[ball_of_face[slot]];
        out.local_center[slot] = ball.disk.center;
        face.center = ball.drawn.center;
        face.radius = ball.drawn.radius;
        face.ball = ball.row;
      } else {
        const PlacedCircle circle = placed_circumcircle(balls, points, v.faces[slot]);
        out.local_center[slot] = circle.local.center;
        face.center = circle.center;
        face.radius = balls.frame.to_document_length(circle.local.radius);
      }
    }
  });
  return out;
}

/// Interprets cuts as pieces of the axis.
template <class Balls, class Points>
class AxisReader {
 public:
  AxisReader(const UnionBalls<Balls, Points>& balls, const VTriangulation& v, const UnionFaces& faces)
      : balls_(balls), v_(v), faces_(faces) {}

  bool is_unbounded(const EdgeCut& cut) const { return node_at(cut, 0) == kNoSlot || node_at(cut, 1) == kNoSlot; }
  /// Cuts between two triangles of one circle have no length and are not part of the axis.
  bool is_axis(const EdgeCut& cut) const {
    if (cut.label != CutLabel::in) return false;
    const AxisNodeSlot a = node_at(cut, 0);
    const AxisNodeSlot b = node_at(cut, 1);
    return a != kNoSlot && b != kNoSlot && a != b;
  }
  /// Computed from the positions in the frame, which have the most digits.
  double length_of(const EdgeCut& cut) const { return local_length(local_at(cut, 1) - local_at(cut, 0)); }
  AxisPiece piece_of(const EdgeCut& cut) const {
    const VEdge& edge = v_.edges[cut.edge];
    const Disk a = disk_at(cut, 0);
    const Disk b = disk_at(cut, 1);
    AxisPiece piece{
        a.center, b.center, a.radius, b.radius, {node_at(cut, 0), node_at(cut, 1)}, {edge.v[0], edge.v[1]}};
    if (ends_at_plain_face(cut, 0) && ends_at_plain_face(cut, 1))
      piece.is_zero = local_at(cut, 0) == local_at(cut, 1) ? 1 : 0;
    return piece;
  }

 private:
  // Returns kNoSlot if the cut is unbounded at this end.
  AxisNodeSlot node_at(const EdgeCut& cut, std::size_t i) const {
    if (cut.end[i] != kNoSlot) return node_of(balls_.input[cut.end[i]].row);
    const VFaceSlot face = cut.face_at(v_, i);
    if (face == kNoSlot) return kNoSlot;
    const FamilySlot ball = faces_.rows[face].ball;
    return ball != kNoSlot ? node_of(ball) : AxisNodeSlot(balls_.rows + face.index());
  }
  bool ends_at_plain_face(const EdgeCut& cut, std::size_t i) const {
    const VFaceSlot face = cut.face_at(v_, i);
    return face != kNoSlot && faces_.rows[face].ball == kNoSlot;
  }
  Vec2 local_at(const EdgeCut& cut, std::size_t i) const {
    return cut.end[i] != kNoSlot ? balls_.center(cut.end[i]) : faces_.local_center[cut.face_at(v_, i)];
  }
  Disk disk_at(const EdgeCut& cut, std::size_t i) const {
    if (cut.end[i] != kNoSlot) return balls_.input[cut.end[i]].drawn;
    const VFace& face = faces_.rows[cut.face_at(v_, i)];
    return {face.center, face.radius};
  }

  const UnionBalls<Balls, Points>& balls_;
  const VTriangulation& v_;
  const UnionFaces& faces_;
};

struct UnionAxis {
  Table<AxisPieceSlot, AxisPiece> pieces;
  std::int64_t contradictions = 0;  ///< unbounded cuts in |R|
  Sum length;                       ///< in the frame, of the cuts; singular dual edges are added separately
};

/// Appends the singular dual edges.
template <class Balls, class Points>
void add_singular_edges(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                        const DualComplex& complex, const VPoints<Points>& points,
                        Table<AxisPieceSlot, AxisPiece>& out) {
  for (const RegularEdgeSlot e : tables.edges.rows()) {
    const DualEdgeSlot row = complex.row_of_edge[e];
    if (row == kNoSlot || complex.edges[row].kind != DualClass::singular) continue;
    const PipelineBall& a = balls.input[tables.edges[e].v[0]];
    const PipelineBall& b = balls.input[tables.edges[e].v[1]];
    out.push_back({a.drawn.center,
                   b.drawn.center,
                   a.drawn.radius,
                   b.drawn.radius,
                   {node_of(a.row), node_of(b.row)},
                   {points.of_dual_edge[row][0], points.of_dual_edge[row][1]},
                   1});
  }
}

template <class Balls, class Points>
UnionAxis union_axis(const UnionBalls<Balls, Points>& balls, const RegularTables& tables, const DualComplex& complex,
                     const VPoints<Points>& points, const VTriangulation& v, const UnionFaces& faces,
                     const std::vector<EdgeCut>& cuts) {
  UnionAxis out;
  const AxisReader reader(balls, v, faces);
  struct Part {
    std::vector<std::uint32_t> cuts;  // those that are pieces of the axis
    std::size_t begin = 0;            // index of the first of their pieces
    std::int64_t unbounded = 0;
    Sum length;
  };
  std::vector<Part> parts(balls.part_count(cuts.size()));
  balls.in_parts(cuts.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
    Part found;
    for (std::size_t c = begin; c < end; ++c) {
      if (cuts[c].label != CutLabel::in) continue;
      if (reader.is_axis(cuts[c])) {
        found.cuts.push_back(static_cast<std::uint32_t>(c));
      } else if (reader.is_unbounded(cuts[c])) {
        ++found.unbounded;
      }
    }
    parts[part] = std::move(found);
  });
  std::size_t pieces = 0;
  for (Part& part : parts) {
    part.begin = pieces;
    pieces += part.cuts.size();
    out.contradictions += part.unbounded;
  }
  const auto singular = std::ranges::count(complex.edges, DualClass::singular, &DualEdge::kind);
  out.pieces.reserve(pieces + static_cast<std::size_t>(singular));
  out.pieces.resize(pieces);
  balls.in_parts(cuts.size(), [&](std::size_t, std::size_t, std::size_t part) {
    AxisPieceSlot at(parts[part].begin);
    Sum length;
    for (const std::uint32_t c : parts[part].cuts) {
      out.pieces[at] = reader.piece_of(cuts[c]);
      length.add(reader.length_of(cuts[c]));
      ++at;
    }
    parts[part].length = length;
  });
  for (const Part& part : parts) out.length.add(part.length);
  add_singular_edges(balls, tables, complex, points, out.pieces);
  return out;
}

}  // namespace mes
