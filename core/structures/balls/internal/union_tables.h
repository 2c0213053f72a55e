// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a union of balls, as plain tables: dual complex, v-points, Voronoi diagram of the v-points, medial
// axis. Rows of balls are those of the ball family.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/arc.h"
#include "core/base/slot.h"
#include "core/base/vec2.h"
#include "core/structures/triangulation/ball_state.h"

namespace mes {

/// By the number of dual triangles at an edge: none, one, two.
enum class DualClass : std::uint8_t { singular, regular, interior };

struct DualEdge {
  Slot ball[2] = {kNoSlot, kNoSlot};
  DualClass kind = DualClass::singular;
  std::uint8_t shares_sample = 1;  ///< its v-points are samples of both balls
  bool is_alive() const { return ball[0] != kNoSlot; }
};

/// Counter-clockwise.
struct DualFace {
  Slot ball[3] = {kNoSlot, kNoSlot, kNoSlot};
  std::int8_t sign = 0;  ///< of the squared radius of the orthogonal circle as the number type has it: -1 or 0
  std::uint8_t is_exactly_zero = 0;  ///< the three balls touch a common sample, so the radius is zero
  bool is_alive() const { return ball[0] != kNoSlot; }
};

/// A crossing of two circles on the boundary of the union.
struct VPoint {
  Vec2 position{};
  Slot site = kNoSlot;             ///< the sample site it is; kNoSlot = none (foreign)
  std::uint32_t multiplicity = 0;  ///< balls that touch it (shortcut), dual edges that gave it (pipeline); 0 = dead
  bool is_alive() const { return multiplicity != 0; }
};

/// A dual edge gave a v-point.
struct VOrigin {
  Slot v = kNoSlot;
  Slot edge = kNoSlot;
  bool is_alive() const { return v != kNoSlot; }
};

/// A straight piece of the medial axis. At a point x of it the radius is the distance to the v-points `v`; along a
/// singular dual edge `v` are its crossings.
struct AxisPiece {
  Vec2 a{}, b{};
  double radius_a = 0.0, radius_b = 0.0;
  Slot node[2] = {kNoSlot, kNoSlot};  ///< ball rows, then after them rows of `v_faces`; kNoSlot = dead piece
  Slot v[2] = {kNoSlot, kNoSlot};     ///< rows of `v_points`
  std::uint8_t is_singular = 0;       ///< a singular dual edge
  std::uint8_t is_zero = 0;           ///< of length exactly zero
  bool is_alive() const { return node[0] != kNoSlot; }
};

/// Triangle of the Delaunay triangulation of the v-points.
struct VFace {
  Slot v[3] = {kNoSlot, kNoSlot, kNoSlot};
  Slot ball = kNoSlot;  ///< its circumcircle is this ball's circle
  Vec2 center{};
  double radius = 0.0;
  std::uint8_t is_inside = 0;  ///< its circumcentre lies in the closed dual complex
};

enum class VEdgeKind : std::uint8_t { plain, crossing, alpha };

/// Edge of that triangulation and its dual: a segment, a ray when one face is missing, a line when both are.
struct VEdge {
  Slot v[2] = {kNoSlot, kNoSlot};
  Slot f[2] = {kNoSlot, kNoSlot};  ///< left and right of v[0] -> v[1]
  VEdgeKind kind = VEdgeKind::plain;
};

/// A free arc of a circle on the boundary of the union, counter-clockwise. Its length is not zero.
struct BoundaryArc {
  static constexpr double kAsDrawn = -1.0;
  Slot ball = kNoSlot;
  std::uint8_t is_whole = 0;  ///< the whole circle, but for at most one point
  Vec2 from{}, to{};
  /// The angle it turns through, whatever became of its ends by rounding; or `kAsDrawn`, from end to end.
  double turn = kAsDrawn;
  bool is_alive() const { return ball != kNoSlot; }
};

/// As it is drawn; `disk` is its ball. Rounded ends may be equal, or have changed places: then a short arc is
/// nothing, and one that lacks as little of the circle is the circle.
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
  std::int64_t negative_radicands = 0;
  std::int64_t near_duplicates = 0;  ///< distinct v-points closer than 1e-7 of the diameter
  std::int64_t lost_crossings = 0;   ///< arcs whose two v-points are not joined in the triangulation of the v-points
  std::int64_t contradictions = 0;   ///< pieces that one end has inside and the other outside
};

/// Lengths and areas, summed up where numbers have the most digits. The tables are rounded to the coordinates of the
/// document, which far from the origin have few.
struct UnionMeasures {
  double area = 0.0;
  double perimeter = 0.0;
  double axis_length = 0.0;
  std::int64_t left_out = 0;  ///< terms that are not finite
};

struct UnionTables {
  std::vector<BallState> balls;
  std::vector<DualEdge> dual_edges;
  std::vector<DualFace> dual_faces;
  std::vector<VPoint> v_points;
  std::vector<VOrigin> v_origins;
  std::vector<AxisPiece> axis;
  std::vector<VFace> v_faces;
  std::vector<VEdge> v_edges;
  std::vector<BoundaryArc> arcs;
  UnionCounts counts;
  UnionMeasures measures;
};

}  // namespace mes
