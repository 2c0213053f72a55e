// SPDX-License-Identifier: GPL-3.0-or-later
// Third stage of the union pipeline: dual complex -> v-points, the crossings of two circles on the boundary of the
// union.
#pragma once

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/job_control.h"
#include "core/structures/balls/internal/union_balls.h"
#include "core/structures/balls/internal/union_complex.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/balls/internal/union_triangulation.h"
#include "core/structures/triangulation/point_triangulation.h"

namespace mes {

/// Where crossings come from.
enum class CrossingRule : std::uint8_t {
  root,    ///< of a square root
  sample,  ///< where two circles share a sample, that and its mirror image, both rational; else of a root
};

/// The v-points, and the triangulation in which equal crossings were found.
template <class Points>
struct VPoints {
  using Point = typename Points::Point_2;
  static constexpr bool kIsDouble = std::is_same_v<typename Points::FT, double>;

  Table<VPointSlot, VPoint> rows;
  Table<VOriginSlot, VOrigin> origins;
  Table<VPointSlot, Vec2> local;                                ///< rounded, in the frame
  Table<VPointSlot, Point> exact;                               ///< in the frame; empty for doubles
  Table<DualEdgeSlot, std::array<VPointSlot, 2>> of_dual_edge;  ///< left and right of it; kNoSlot = none
  Table<ZeroGroupSlot, VPointSlot> of_zero_group;  ///< the common centre of the group, if that is a v-point
  PointTriangulation triangulation;                ///< of the crossings
  Table<InputSlot, VPointSlot> row_of_crossing;    ///< for the crossings that stand for others
  std::int64_t raw_v_points = 0;                   ///< see `UnionCounts`
  std::int64_t negative_radicands = 0;             ///< see `UnionCounts`

  Point point(VPointSlot v) const {
    if constexpr (kIsDouble) {
      return {local[v].x, local[v].y};
    } else {
      return exact[v];
    }
  }
};

/// Makes crossings of the circles of two balls in the numbers of `Points`.
template <class Balls, class Points>
class CrossingMaker {
 public:
  using Number = typename Points::FT;
  using Point = typename Points::Point_2;
  struct Crossing {
    Point point;
    SiteSlot site{};
  };

  CrossingMaker(const UnionBalls<Balls, Points>& balls, CrossingRule rule) : balls_(balls), rule_(rule) {}

  /// To the left or right of the way from a to b; nothing where the circles do not meet as the numbers have it.
  std::optional<Crossing> make(InputSlot a, InputSlot b, bool left) const {
    // Where rounding matters it must not depend on the order in which the balls came.
    const bool is_turned = balls_.comes_before(b, a);
    if (is_turned) std::swap(a, b);
    return in_order(a, b, left != is_turned);
  }

 private:
  static constexpr bool kHasRoots =
      !std::is_same_v<typename CGAL::Algebraic_structure_traits<Number>::Sqrt, CGAL::Null_functor>;

  std::optional<Crossing> in_order(InputSlot a, InputSlot b, bool left) const {
    if (rule_ == CrossingRule::sample) {
      if (auto found = by_sample(a, b, left)) return found;
    }
    const BallOf<Number>& p = balls_.in_points[a];
    const BallOf<Number>& q = balls_.in_points[b];
    const Number dx = q.x - p.x, dy = q.y - p.y;
    const Number dd = dx * dx + dy * dy;
    const Number s = dd - q.w + p.w;
    const Number radicand = Number(4) * dd * p.w - s * s;
    if (CGAL::sign(radicand) == CGAL::NEGATIVE) return std::nullopt;
    return by_root(a, b, left, radicand);
  }

  std::optional<Crossing> by_sample(InputSlot a, InputSlot b, bool left) const {
    const BallOf<Number>& p = balls_.in_points[a];
    const BallOf<Number>& q = balls_.in_points[b];
    const Number dx = q.x - p.x, dy = q.y - p.y;
    std::optional<Crossing> mirrored;
    for (const TouchedSample& sample : balls_.input[a].samples) {
      if (balls_.input[b].find(sample.site) == nullptr) continue;
      const Number x(sample.position.x), y(sample.position.y);
      const Number side = dx * (y - p.y) - dy * (x - p.x);
      const int sign = static_cast<int>(CGAL::sign(side));
      if (sign == 0 || (sign > 0) == left) return Crossing{Point(x, y), sample.site};
      const Number twice = Number(2) * side / (dx * dx + dy * dy);
      mirrored = Crossing{Point(x + twice * dy, y - twice * dx), SiteSlot()};
    }
    return mirrored;
  }

  Crossing by_root(InputSlot a, InputSlot b, bool left, const Number& radicand) const {
    if constexpr (kHasRoots) {
      const BallOf<Number>& p = balls_.in_points[a];
      const BallOf<Number>& q = balls_.in_points[b];
      const Number dx = q.x - p.x, dy = q.y - p.y;
      const Number dd = dx * dx + dy * dy;
      const Number s = dd - q.w + p.w;
      const Number root = left ? Number(CGAL::sqrt(radicand)) : Number(-CGAL::sqrt(radicand));
      const Number twice = Number(2) * dd;
      Crossing out{Point(p.x + (s * dx - root * dy) / twice, p.y + (s * dy + root * dx) / twice)};
      for (const TouchedSample& sample : balls_.input[a].samples) {
        if (balls_.input[b].find(sample.site) == nullptr) continue;
        const Vec2 p_of = sample.position;
        if (out.point == Point(Number(p_of.x), Number(p_of.y))) out.site = sample.site;
      }
      return out;
    } else {
      throw NeedsRoots{};
    }
  }

  const UnionBalls<Balls, Points>& balls_;
  CrossingRule rule_;
};

/// Crossings as dual edges give them; equal ones are not yet joined.
template <class Points>
struct RawCrossings {
  struct Origin {
    RegularEdgeSlot edge;
    std::uint8_t side;  ///< 0 = left
    SiteSlot site;
  };
  Table<InputSlot, Origin> origin;
  Table<InputSlot, typename Points::Point_2> point;
  std::int64_t negative_radicands = 0;

  void append(const RawCrossings& other) {
    origin.values().insert(origin.end(), other.origin.begin(), other.origin.end());
    point.values().insert(point.end(), other.point.begin(), other.point.end());
    negative_radicands += other.negative_radicands;
  }
};

template <class Balls, class Points>
RawCrossings<Points> raw_crossings(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                                   const DualComplex& complex, CrossingRule rule, JobControl& job) {
  const CrossingMaker<Balls, Points> maker(balls, rule);
  const std::size_t edges = tables.edges.size();
  std::vector<RawCrossings<Points>> parts(balls.part_count(edges));
  balls.in_parts(edges, [&](std::size_t begin, std::size_t end, std::size_t part) {
    RawCrossings<Points> found;
    for (const RegularEdgeSlot e : slots_between<RegularEdgeSlot>(begin, end)) {
      if ((e.index() & 0x3fU) == 0) job.checkpoint(edges + e.index(), 4 * edges);
      if (complex.row_of_edge[e] == kNoSlot) continue;
      const auto& edge = tables.edges[e];
      for (std::uint8_t side = 0; side < 2; ++side) {
        if (complex.has(edge.f[side])) continue;
        if (auto crossing = maker.make(edge.v[0], edge.v[1], side == 0)) {
          found.origin.push_back({e, side, crossing->site});
          found.point.push_back(std::move(crossing->point));
        } else {
          ++found.negative_radicands;
        }
      }
    }
    parts[part] = std::move(found);
  });
  RawCrossings<Points> out = std::move(parts.front());
  for (std::size_t part = 1; part < parts.size(); ++part) out.append(parts[part]);
  return out;
}

/// Three circles meet in the centre of a triangle of radius zero: in one of the two crossings of each pair, that away
/// from the third ball exactly if the third one has no more power than the two in the middle between the crossings.
template <class Balls, class Points>
bool is_center_away(const UnionBalls<Balls, Points>& balls, const RegularTables& tables, RegularEdgeSlot edge,
                    TriangleSlot inner_face) {
  const auto& ball = balls.in_balls;
  const auto& ends = tables.edges[edge].v;
  for (const InputSlot c : tables.faces[inner_face].v)
    if (c != ends[0] && c != ends[1])
      return sign_of_excess_at_foot<Balls>(ball[ends[0]], ball[ends[1]], ball[c]) <= 0;
  return false;
}

/// Progress of the job: the second quarter.
template <class Balls, class Points>
VPoints<Points> v_points(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                         const DualComplex& complex, CrossingRule rule, JobControl& job) {
  VPoints<Points> out;
  const RawCrossings<Points> raw = raw_crossings(balls, tables, complex, rule, job);
  const std::size_t count = raw.point.size();
  out.negative_radicands = raw.negative_radicands;
  out.raw_v_points = static_cast<std::int64_t>(count);
  out.triangulation = point_triangulation<Points>(raw.point, job);
  out.of_dual_edge.assign(complex.edges.size(), {});
  out.of_zero_group.assign(complex.zero_groups, kNoSlot);
  out.row_of_crossing.assign(count, kNoSlot);
  out.rows.reserve(count);
  out.origins.reserve(count);
  const auto row_for = [&](InputSlot i) {
    VPointSlot& row = out.row_of_crossing[out.triangulation.same_as[i]];
    if (row != kNoSlot) return row;
    row = out.rows.next();
    const auto& p = raw.point[i];
    const PlacedPoint place = placed(p.x(), p.y(), balls.frame);
    out.rows.push_back({place.document, SiteSlot(), 0});
    out.local.push_back(place.local);
    if constexpr (!VPoints<Points>::kIsDouble) out.exact.push_back(p);
    return row;
  };
  for (const InputSlot i : raw.point.rows()) {
    const auto& origin = raw.origin[i];
    const DualEdgeSlot dual = complex.row_of_edge[origin.edge];
    const VPointSlot v = row_for(i);
    if (origin.site != kNoSlot) out.rows[v].site = origin.site;
    ++out.rows[v].multiplicity;
    out.origins.push_back({v, dual});
    out.of_dual_edge[dual][origin.side] = v;
    // A group of triangles of radius zero ends here: its common centre is this crossing.
    const TriangleSlot inner = tables.edges[origin.edge].f[1 - origin.side];
    if (complex.edges[dual].kind == DualClass::regular && complex.zero_group[inner] != kNoSlot &&
        is_center_away(balls, tables, origin.edge, inner))
      out.of_zero_group[complex.zero_group[inner]] = v;
  }
  return out;
}

/// V-points that are known beforehand.
template <class Balls, class Points>
VPoints<Points> known_v_points(const UnionBalls<Balls, Points>& balls, const KnownVPoints& known, JobControl& job) {
  using Number = typename Points::FT;
  VPoints<Points> out;
  Table<InputSlot, typename Points::Point_2> points;
  for (const VPointSlot i : known.points.rows()) {
    const Vec2 p = balls.frame.to_local(known.points[i]);
    points.emplace_back(Number(p.x), Number(p.y));
    out.row_of_crossing.push_back(i);
    out.rows.push_back({known.points[i], known.sites[i], 1});
    out.local.push_back(p);
    if constexpr (!VPoints<Points>::kIsDouble) out.exact.push_back(points.back());
  }
  out.triangulation = point_triangulation<Points>(points, job);
  for (const InputSlot i : points.rows()) MES_ASSERT(out.triangulation.same_as[i] == i);
  return out;
}

/// The crossing `v` of the circles of two balls, as the vector from the centre of the first; it lies to the left or
/// right of the way from there to the centre of the other. Rounded positions have few digits for a ball that is small
/// beside its distance from the origin of the frame.
template <class Balls, class Points>
Vec2 seen_from_center(const UnionBalls<Balls, Points>& balls, const VPoints<Points>& points, InputSlot ball,
                      InputSlot other, bool left, VPointSlot v) {
  using Number = typename Points::FT;
  constexpr double kSmall = 0x1p-10;
  const Vec2 center = balls.center(ball);
  const double r = balls.input[ball].radius();
  if (r > kSmall * std::max(std::abs(center.x), std::abs(center.y))) return points.local[v] - center;
  if constexpr (VPoints<Points>::kIsDouble) {
    const Vec2 way = balls.center(other) - center;
    const double dd = dot(way, way);
    const double w = balls.in_points[ball].w;
    const double s = dd - balls.in_points[other].w + w;
    const double root = std::sqrt(std::max(4.0 * dd * w - s * s, 0.0));
    return (0.5 / dd) * (s * way + (left ? root : -root) * perpendicular(way));
  } else {
    const BallOf<Number>& own = balls.in_points[ball];
    return {rounded(Number(points.exact[v].x() - own.x)), rounded(Number(points.exact[v].y() - own.y))};
  }
}

}  // namespace mes
