// SPDX-License-Identifier: GPL-3.0-or-later
// The results for a union of balls as plain tables: dual complex, v-points, Voronoi diagram of the v-points, medial
// axis. Rows of balls are those of the ball family.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/geometry/arc.h"
#include "core/base/geometry/vec2.h"
#include "core/base/table.h"
#include "core/structures/balls/ball_family.h"
#include "core/structures/triangulation/ball_state.h"

namespace mes {

using DualEdgeSlot = Slot<struct DualEdgeTag>;
using DualFaceSlot = Slot<struct DualFaceTag>;
using VPointSlot = Slot<struct VPointTag>;
using VOriginSlot = Slot<struct VOriginTag>;
using AxisPieceSlot = Slot<struct AxisPieceTag>;
using VFaceSlot = Slot<struct VFaceTag>;
using VEdgeSlot = Slot<struct VEdgeTag>;
using ArcSlot = Slot<struct ArcTag>;
/// A node of the axis: a ball, by its row in the family, or, after all of these, a face of the v-points.
using AxisNodeSlot = Slot<struct AxisNodeTag>;

/// Class of an edge by its number of dual triangles: none, one, two.
enum class DualClass : std::uint8_t { singular, regular, interior };

struct DualEdge {
  FamilySlot ball[2]{};
  DualClass kind = DualClass::singular;
  std::uint8_t shares_sample = 1;  ///< its v-points are samples of both balls
  bool is_alive() const { return ball[0] != kNoSlot; }
};

/// Corners run counter-clockwise.
struct DualFace {
  FamilySlot ball[3]{};
  std::int8_t sign = 0;  ///< of the squared radius of the orthogonal circle, in the given number type: -1 or 0
  std::uint8_t is_exactly_zero = 0;  ///< the three balls touch a common sample, so the radius is zero
  bool is_alive() const { return ball[0] != kNoSlot; }
};

/// A crossing of two circles on the boundary of the union.
struct VPoint {
  Vec2 position{};
  SiteSlot site;                   ///< the site whose sample it is; kNoSlot = none (foreign)
  std::uint32_t multiplicity = 0;  ///< balls that touch it (shortcut), dual edges that made it (pipeline); 0 = dead
  bool is_alive() const { return multiplicity != 0; }
};

/// Records that a dual edge made a v-point.
struct VOrigin {
  VPointSlot v;
  DualEdgeSlot edge;
  bool is_alive() const { return v != kNoSlot; }
};

/// A straight piece of the medial axis. At a point x of it the radius is the distance to the v-points `v`; along a
/// singular dual edge `v` are its crossings.
struct AxisPiece {
  Vec2 a{}, b{};
  double radius_a = 0.0, radius_b = 0.0;
  AxisNodeSlot node[2]{};  ///< kNoSlot = dead piece
  VPointSlot v[2]{};
  std::uint8_t is_singular = 0;  ///< a singular dual edge
  std::uint8_t is_zero = 0;      ///< of length exactly zero
  bool is_alive() const { return node[0] != kNoSlot; }
};

/// Triangle of the Delaunay triangulation of the v-points.
struct VFace {
  VPointSlot v[3]{};
  FamilySlot ball;  ///< its circumcircle is this ball's circle
  Vec2 center{};
  double radius = 0.0;
  std::uint8_t is_inside = 0;  ///< its circumcentre lies in the closed dual complex
};

enum class VEdgeKind : std::uint8_t { plain, crossing, alpha };

/// Edge of that triangulation and its dual: a segment, a ray when one face is missing, a line when both are.
struct VEdge {
  VPointSlot v[2]{};
  VFaceSlot f[2]{};  ///< left and right of v[0] -> v[1]
  VEdgeKind kind = VEdgeKind::plain;
};

/// A free arc of a circle on the boundary of the union, counter-clockwise. Its length is not zero.
template <class Ball>
struct ArcOf {
  static constexpr double kAsDrawn = -1.0;
  Ball ball;
  std::uint8_t is_whole = 0;  ///< the whole circle, but for at most one point
  Vec2 from{}, to{};
  /// The angle it turns through, free of the rounding of its ends; or `kAsDrawn`, which means from end to end.
  double turn = kAsDrawn;
  bool is_alive() const { return ball != kNoSlot; }
};
using BoundaryArc = ArcOf<FamilySlot>;

/// The arc as it is drawn; `disk` is its ball. Rounding may make the ends equal or exchange them: then a short arc is
/// nothing, and one that lacks only as little of the circle is the whole circle.
inline std::optional<Arc> drawn_arc(const BoundaryArc& arc, const Disk& disk) {
  constexpr double kHalf = std::numbers::pi;
  const Vec2 rightmost{disk.center.x + disk.radius, disk.center.y};
  const Arc whole{disk.center, disk.radius, rightmost, rightmost};
  if (arc.is_whole != 0) return whole;
  const Arc drawn{disk.center, disk.radius, arc.from, arc.to};
  const double turn = arc.turn == BoundaryArc::kAsDrawn ? 0.0 : arc.turn;
  if (arc.from == arc.to) return turn > kHalf ? std::optional(whole) : std::nullopt;
  if (arc.turn == BoundaryArc::kAsDrawn || std::abs(sweep_of(drawn) - turn) < kHalf) return drawn;
  return turn > kHalf ? std::optional(whole) : std::nullopt;
}

/// Counters of one computation; -1 = not applicable.
struct UnionCounts {
  std::int64_t triangulation_edges = -1, triangulation_faces = -1;
  std::int64_t sign_flips = 0;      ///< dual triangles whose three balls share a sample, judged not to be zero
  std::int64_t negative_faces = 0;  ///< orthogonal radius < 0 as judged
  std::int64_t edges_without_sample = 0;
  std::int64_t raw_v_points = 0;
  std::int64_t roots = 0;  ///< raw v-points that take a square root; `exact` only
  std::int64_t negative_radicands = 0;
  std::int64_t near_duplicates = 0;  ///< distinct v-points closer than 1e-7 of the diameter
  std::int64_t lost_crossings = 0;   ///< arcs whose two v-points are not joined in the triangulation of the v-points
  std::int64_t contradictions = 0;   ///< pieces that one end puts inside and the other outside
};

/// Lengths and areas, summed up where numbers have the most digits. The tables are rounded to the coordinates of the
/// document, which have few digits far from the origin.
struct UnionMeasures {
  double area = 0.0;
  double perimeter = 0.0;
  double axis_length = 0.0;
  std::int64_t left_out = 0;  ///< terms that are not finite
};

struct UnionTables {
  Table<FamilySlot, BallState> balls;
  Table<DualEdgeSlot, DualEdge> dual_edges;
  Table<DualFaceSlot, DualFace> dual_faces;
  Table<VPointSlot, VPoint> v_points;
  Table<VOriginSlot, VOrigin> v_origins;
  Table<AxisPieceSlot, AxisPiece> axis;
  Table<VFaceSlot, VFace> v_faces;
  Table<VEdgeSlot, VEdge> v_edges;
  Table<ArcSlot, BoundaryArc> arcs;
  UnionCounts counts;
  UnionMeasures measures;

  std::size_t node_count() const { return balls.size() + v_faces.size(); }
  AxisNodeSlot node_of(VFaceSlot face) const { return AxisNodeSlot(balls.size() + face.index()); }
  bool is_ball(AxisNodeSlot node) const { return node.index() < balls.size(); }
};

/// Node of the ball's centre.
constexpr AxisNodeSlot node_of(FamilySlot ball) {
  return same_row<AxisNodeSlot>(ball);
}
/// Ball whose centre is the node.
constexpr FamilySlot ball_of(AxisNodeSlot node) {
  return same_row<FamilySlot>(node);
}

}  // namespace mes
