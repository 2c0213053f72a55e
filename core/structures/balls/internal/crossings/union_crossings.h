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
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/disjoint_sets.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/complex/union_complex.h"
#include "core/structures/balls/internal/complex/union_triangulation.h"
#include "core/structures/balls/internal/crossings/crossing_kernel.h"
#include "core/structures/balls/internal/crossings/crossing_triangulation.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/triangulation/point_triangulation.h"

namespace mes {

/// True if points are crossings instead of numbers.
template <class Points>
inline constexpr bool kAreCrossings = std::is_same_v<Points, CrossingKernel>;

/// The v-points, and the triangulation in which equal crossings were found.
template <class Points>
struct VPoints {
  using Point = typename Points::Point_2;
  static constexpr bool kIsDouble = std::is_same_v<typename Points::FT, double>;

  Table<VPointSlot, VPoint> rows;
  Table<VOriginSlot, VOrigin> origins;
  Table<VPointSlot, Vec2> local;                                ///< rounded, in the frame
  Table<VPointSlot, Point> exact;                               ///< in the frame; empty for doubles
  Table<InputSlot, Crossing> crossings;                         ///< crossings that points of `CrossingKernel` name
  Table<DualEdgeSlot, std::array<VPointSlot, 2>> of_dual_edge;  ///< left and right of it; kNoSlot = none
  Table<ZeroGroupSlot, VPointSlot> of_zero_group;  ///< the common centre of the group, if that is a v-point
  PointTriangulation triangulation;                ///< of the crossings
  Table<InputSlot, VPointSlot> row_of_crossing;    ///< for the crossings that represent others
  std::int64_t raw_v_points = 0;                   ///< see `UnionCounts`
  std::int64_t roots = 0;                          ///< see `UnionCounts`
  std::int64_t negative_radicands = 0;             ///< see `UnionCounts`

  Point point(VPointSlot v) const {
    if constexpr (kIsDouble) {
      return {local[v].x, local[v].y};
    } else {
      return exact[v];
    }
  }
};

/// Makes crossings of the circles of two balls in the numbers of `Points`, with a square root. For `CrossingKernel`, if
/// two circles share a sample, these are the sample and its mirror image.
template <class Balls, class Points>
class CrossingMaker {
 public:
  using Number = typename Points::FT;
  using Point = typename Points::Point_2;
  /// A point, or the data that define it.
  using Made = std::conditional_t<kAreCrossings<Points>, CrossingSource, Point>;
  struct Found {
    Made made;
    SiteSlot site{};
  };

  explicit CrossingMaker(const UnionBalls<Balls, Points>& balls) : balls_(balls) {}

  /// The crossing left or right of the line from a to b; nothing if the circles do not meet in these numbers.
  std::optional<Found> make(InputSlot a, InputSlot b, bool left) const {
    // Rounding must not depend on the order of the balls.
    const bool is_turned = balls_.comes_before(b, a);
    if (is_turned) std::swap(a, b);
    return in_order(a, b, left != is_turned);
  }

 private:
  std::optional<Found> in_order(InputSlot a, InputSlot b, bool left) const {
    if constexpr (kAreCrossings<Points>) {
      if (auto found = by_sample(a, b, left)) return found;
    }
    const BallOf<Number>& p = balls_.in_points[a];
    const BallOf<Number>& q = balls_.in_points[b];
    const Number dx = q.x - p.x, dy = q.y - p.y;
    const Number dd = dx * dx + dy * dy;
    const Number s = dd - q.w + p.w;
    const Number radicand = Number(4) * dd * p.w - s * s;
    const auto sign = CGAL::sign(radicand);
    if (sign == CGAL::NEGATIVE) return std::nullopt;
    if constexpr (kAreCrossings<Points>) {
      using Kind = CrossingSource::Kind;
      return Found{source(sign == CGAL::ZERO ? Kind::touch : Kind::root, a, b, left)};
    } else {
      return by_root(a, b, left, radicand);
    }
  }

  std::optional<Found> by_sample(InputSlot a, InputSlot b, bool left) const {
    const BallOf<Number>& p = balls_.in_points[a];
    const BallOf<Number>& q = balls_.in_points[b];
    const Number dx = q.x - p.x, dy = q.y - p.y;
    std::optional<Found> mirrored;
    for (const TouchedSample& sample : balls_.input[a].samples) {
      if (balls_.input[b].find(sample.site) == nullptr) continue;
      const Number x(sample.position.x), y(sample.position.y);
      const Number side = dx * (y - p.y) - dy * (x - p.x);
      const int sign = static_cast<int>(CGAL::sign(side));
      const bool is_this = sign == 0 || (sign > 0) == left;
      using Kind = CrossingSource::Kind;
      CrossingSource out = source(is_this ? Kind::sample : Kind::mirrored, a, b, left);
      out.sample = sample.position;
      if (is_this) return Found{out, sample.site};
      mirrored = Found{out};
    }
    return mirrored;
  }

  CrossingSource source(CrossingSource::Kind kind, InputSlot a, InputSlot b, bool left) const {
    return {kind, left, {&balls_.input[a], &balls_.input[b]}, {}};
  }

  Found by_root(InputSlot a, InputSlot b, bool left, const Number& radicand) const {
    const BallOf<Number>& p = balls_.in_points[a];
    const BallOf<Number>& q = balls_.in_points[b];
    const Number dx = q.x - p.x, dy = q.y - p.y;
    const Number dd = dx * dx + dy * dy;
    const Number s = dd - q.w + p.w;
    const Number root = left ? Number(CGAL::sqrt(radicand)) : Number(-CGAL::sqrt(radicand));
    const Number twice = Number(2) * dd;
    Found out{Point(p.x + (s * dx - root * dy) / twice, p.y + (s * dy + root * dx) / twice)};
    for (const TouchedSample& sample : balls_.input[a].samples) {
      if (balls_.input[b].find(sample.site) == nullptr) continue;
      const Vec2 p_of = sample.position;
      if (out.made == Point(Number(p_of.x), Number(p_of.y))) out.site = sample.site;
    }
    return out;
  }

  const UnionBalls<Balls, Points>& balls_;
};

/// Crossings made from dual edges; equal ones are not joined yet.
template <class Balls, class Points>
struct RawCrossings {
  struct Origin {
    RegularEdgeSlot edge;
    std::uint8_t side;  ///< 0 = left
    SiteSlot site;
  };
  Table<InputSlot, Origin> origin;
  Table<InputSlot, typename CrossingMaker<Balls, Points>::Made> made;
  std::int64_t negative_radicands = 0;

  void append(const RawCrossings& other) {
    origin.values().insert(origin.end(), other.origin.begin(), other.origin.end());
    made.values().insert(made.end(), other.made.begin(), other.made.end());
    negative_radicands += other.negative_radicands;
  }
};

template <class Balls, class Points>
RawCrossings<Balls, Points> raw_crossings(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                                          const DualComplex& complex, JobControl& job) {
  const CrossingMaker<Balls, Points> maker(balls);
  const std::size_t edges = tables.edges.size();
  std::vector<RawCrossings<Balls, Points>> parts(balls.part_count(edges));
  balls.in_parts(edges, [&](std::size_t begin, std::size_t end, std::size_t part) {
    RawCrossings<Balls, Points> found;
    for (const RegularEdgeSlot e : slots_between<RegularEdgeSlot>(begin, end)) {
      if ((e.index() & 0x3fU) == 0) job.checkpoint(e.index() - begin, end - begin);
      if (complex.row_of_edge[e] == kNoSlot) continue;
      const auto& edge = tables.edges[e];
      for (std::uint8_t side = 0; side < 2; ++side) {
        if (complex.has(edge.f[side])) continue;
        if (auto crossing = maker.make(edge.v[0], edge.v[1], side == 0)) {
          found.origin.push_back({e, side, crossing->site});
          found.made.push_back(std::move(crossing->made));
        } else {
          ++found.negative_radicands;
        }
      }
    }
    parts[part] = std::move(found);
  });
  RawCrossings<Balls, Points> out = std::move(parts.front());
  for (std::size_t part = 1; part < parts.size(); ++part) out.append(parts[part]);
  return out;
}

/// Three circles meet in the centre of a triangle of radius zero, at one of the two crossings of each pair: the one
/// away from the third ball exactly if that ball has no more power than the two midway between the crossings.
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

/// The group of triangles of radius zero whose common centre is the crossing; kNoSlot = none.
template <class Balls, class Points>
ZeroGroupSlot zero_group_at(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                            const DualComplex& complex, const typename RawCrossings<Balls, Points>::Origin& origin) {
  const TriangleSlot inner = tables.edges[origin.edge].f[1 - origin.side];
  const bool is_regular = complex.edges[complex.row_of_edge[origin.edge]].kind == DualClass::regular;
  if (!is_regular || complex.zero_group[inner] == kNoSlot) return kNoSlot;
  return is_center_away(balls, tables, origin.edge, inner) ? complex.zero_group[inner] : ZeroGroupSlot();
}

/// Makes the crossings with their intervals, but does not join equal ones. Intervals of each ball are computed once.
template <class Balls, class Points>
Table<InputSlot, Crossing> intervals_of(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                                        const RawCrossings<Balls, Points>& raw, JobControl& job) {
  Table<InputSlot, std::optional<BallOf<Crossing::First>>> known(balls.size());
  const auto ball_at = [&](InputSlot i) -> const BallOf<Crossing::First>& {
    if (!known[i]) known[i] = ball_in<Crossing::First>(balls.input[i]);
    return *known[i];
  };
  const BallOf<Crossing::First> none;
  Table<InputSlot, Crossing> out;
  out.reserve(raw.made.size());
  for (const InputSlot i : raw.made.rows()) {
    if ((i.index() & 0xffU) == 0) job.checkpoint();
    const CrossingSource& source = raw.made[i];
    if (source.kind == CrossingSource::Kind::sample) {
      out.push_back(crossing_of(source, none, none));
      continue;
    }
    const auto& [a, b] = tables.edges[raw.origin[i].edge].v;
    const bool is_turned = source.ball[0] != &balls.input[a];
    out.push_back(crossing_of(source, ball_at(is_turned ? b : a), ball_at(is_turned ? a : b)));
  }
  return out;
}

/// Joins crossings that are known to be equal: in one sample, of circles that touch, or in the common centre of
/// triangles of radius zero. Notes all circles that are known to pass there.
template <class Balls, class Points>
void join_equal_crossings(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                          const DualComplex& complex, const RawCrossings<Balls, Points>& raw,
                          const Table<InputSlot, ZeroGroupSlot>& group, Table<InputSlot, Crossing>& crossings) {
  DisjointSets<InputSlot> sets(crossings.size());
  const auto join = [&sets](InputSlot& first, InputSlot i) {
    if (first == kNoSlot) {
      first = i;
    } else {
      sets.join(sets.root(first), sets.root(i));
    }
  };
  Table<ZeroGroupSlot, InputSlot> first_of_group(complex.zero_groups);
  std::unordered_map<SiteSlot, InputSlot> first_at_site;
  for (const InputSlot i : crossings.rows()) {
    if (group[i] != kNoSlot) join(first_of_group[group[i]], i);
    if (raw.origin[i].site != kNoSlot) join(first_at_site[raw.origin[i].site], i);
    // The two sides of an edge are consecutive.
    if (i.index() == 0 || crossings[i].source.kind != CrossingSource::Kind::touch) continue;
    if (const InputSlot before(i.index() - 1); raw.origin[before].edge == raw.origin[i].edge)
      sets.join(sets.root(before), sets.root(i));
  }
  for (const InputSlot i : crossings.rows()) {
    Crossing& same = crossings[sets.root(i)];
    crossings[i].same = &same;
    for (const InputSlot ball : tables.edges[raw.origin[i].edge].v) same.circles.push_back(ball);
  }
  for (const TriangleSlot f : tables.faces.rows()) {
    const ZeroGroupSlot of_face = complex.zero_group[f];
    if (of_face == kNoSlot || first_of_group[of_face] == kNoSlot) continue;
    for (const InputSlot ball : tables.faces[f].v)
      crossings[sets.root(first_of_group[of_face])].circles.push_back(ball);
  }
  for (const InputSlot ball : balls.in_balls.rows())
    for (const TouchedSample& sample : balls.input[ball].samples)
      if (const auto first = first_at_site.find(sample.site); first != first_at_site.end())
        crossings[sets.root(first->second)].circles.push_back(ball);
  for (Crossing& crossing : crossings) {
    std::ranges::sort(crossing.circles);
    const auto repeated = std::ranges::unique(crossing.circles);
    crossing.circles.erase(repeated.begin(), repeated.end());
  }
}

template <class Balls, class Points>
VPoints<Points> v_points(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                         const DualComplex& complex, JobControl& job) {
  VPoints<Points> out;
  RawCrossings<Balls, Points> raw = in_share(job, 0.5, [&] { return raw_crossings(balls, tables, complex, job); });
  const std::size_t count = raw.made.size();
  out.negative_radicands = raw.negative_radicands;
  out.raw_v_points = static_cast<std::int64_t>(count);
  Table<InputSlot, ZeroGroupSlot> group;
  group.reserve(count);
  for (const auto& origin : raw.origin) group.push_back(zero_group_at(balls, tables, complex, origin));
  Table<InputSlot, typename Points::Point_2> point;
  if constexpr (kAreCrossings<Points>) {
    out.crossings = intervals_of(balls, tables, raw, job);
    out.roots = std::ranges::count(raw.made, CrossingSource::Kind::root, &CrossingSource::kind);
    join_equal_crossings(balls, tables, complex, raw, group, out.crossings);
    point.reserve(count);
    for (const Crossing& crossing : out.crossings) point.push_back({&crossing});
  } else {
    point = std::move(raw.made);
  }
  out.triangulation = point_triangulation<Points>(point, job);
  out.of_dual_edge.assign(complex.edges.size(), {});
  out.of_zero_group.assign(complex.zero_groups, kNoSlot);
  out.row_of_crossing.assign(count, kNoSlot);
  out.rows.reserve(count);
  out.origins.reserve(count);
  const auto row_for = [&](InputSlot i) {
    VPointSlot& row = out.row_of_crossing[out.triangulation.same_as[i]];
    if (row != kNoSlot) return row;
    row = out.rows.next();
    const auto& p = point[i];
    const PlacedPoint place = place_of(p, balls.frame);
    out.rows.push_back({place.document, SiteSlot(), 0});
    out.local.push_back(place.local);
    if constexpr (!VPoints<Points>::kIsDouble) out.exact.push_back(p);
    return row;
  };
  for (const InputSlot i : point.rows()) {
    if ((i.index() & 0xffU) == 0) job.checkpoint();
    const auto& origin = raw.origin[i];
    const DualEdgeSlot dual = complex.row_of_edge[origin.edge];
    const VPointSlot v = row_for(i);
    if (origin.site != kNoSlot) out.rows[v].site = origin.site;
    ++out.rows[v].multiplicity;
    out.origins.push_back({v, dual});
    out.of_dual_edge[dual][origin.side] = v;
    if (group[i] != kNoSlot) out.of_zero_group[group[i]] = v;
  }
  return out;
}

/// Makes the v-points that are known beforehand.
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
/// right of the line from there to the centre of the other. Rounded positions have few digits for a ball that is small
/// compared with its distance from the origin of the frame.
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
  } else if constexpr (kAreCrossings<Points>) {
    return rounded_vector(balls.input[ball], points.exact[v]);
  } else {
    const BallOf<Number>& own = balls.in_points[ball];
    return {rounded(Number(points.exact[v].x() - own.x)), rounded(Number(points.exact[v].y() - own.y))};
  }
}

}  // namespace mes
