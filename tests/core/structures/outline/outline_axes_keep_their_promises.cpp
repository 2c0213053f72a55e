// SPDX-License-Identifier: GPL-3.0-or-later
// The axis of the outline: known shapes, distances in a plain loop over all sides, the segment Voronoi diagram of
// Boost.Polygon, and images of an outline.
#include <algorithm>
#include <array>
#include <boost/polygon/polygon.hpp>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

#include "core/base/geometry/parabola_arc.h"
#include "core/base/rng.h"
#include "core/document/commands.h"
#include "core/draw/primitive_values.h"
#include "core/graph/size_refusal.h"
#include "core/structures/outline/axis_deviation.h"
#include "core/structures/outline/internal/segment_voronoi.h"
#include "core/structures/outline/outline_axis.h"
#include "core/structures/outline/outline_sides.h"
#include "tests/core/structures/outline/outline_bench.h"
#include "tests/support/parcels.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

double distance_to_side(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  return distance(p, a + std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) * d);
}

std::vector<Ring> polygon_with_hole(Rng& rng) {
  const std::size_t count = 7 + rng.below(25);
  std::vector<Ring> out{star_polygon(rng, count, 2.0e6, 5.0e6)};
  // Sides of the outer ring keep a distance of two thirds of its least radius.
  out.push_back(star_polygon(rng, 3 + rng.below(9), 2.0e5, 9.0e5));
  return out;
}

}  // namespace

TEST_CASE("known shapes have their known axis") {
  {
    const AxisBench square(data_of_rings({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}));
    CHECK(square.count("outline-axis", "edges") == 4);
    CHECK(square.count("outline-axis", "nodes") == 5);
    CHECK(square.has_node({1, 1}, 1));
    CHECK(square.length() == Approx(4.0 * std::numbers::sqrt2));
  }
  {
    const AxisBench corner(data_of_rings({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}));
    CHECK(corner.count("outline-axis", "edges") == 9);
    CHECK(corner.count("outline-axis", "parabolas") == 2);
    const double at = 2.0 - std::numbers::sqrt2;
    CHECK(corner.has_node({at, at}, at));
    CHECK(corner.has_node({0.5, 1.0}, 0.5));
  }
  {
    const AxisBench ring(data_of_rings({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}));
    CHECK(ring.count("outline-axis", "edges") == 16);
    CHECK(ring.count("outline-axis", "nodes") == 16);
    CHECK(ring.count("outline-axis", "regions") == 1);
  }
  {
    // A common side in two contours, with a T.
    const AxisBench parcels(data_of_rings(
        {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{2, 0}, {4, 0}, {4, 1}, {2, 1}}, {{2, 1}, {4, 1}, {4, 2}, {2, 2}}}));
    CHECK(parcels.count("outline-axis", "regions") == 3);
    CHECK(parcels.count("outline-axis", "edges") == 4 + 5 + 5);
    CHECK(parcels.has_node({1, 1}, 1));
  }
  {
    const AxisBench eight(data_of_rings({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}));
    CHECK(eight.count("outline-axis", "regions") == 2);
    CHECK(eight.count("outline-axis", "crossings") == 1);
    CHECK(eight.count("outline-axis", "edges") == 6);
  }
  for (const std::vector<Ring>& nothing : {std::vector<Ring>{},
                                           {{{0, 0}}},
                                           {{{0, 0}, {1, 0}}},
                                           {{{0, 0}, {1, 0}, {2, 0}}},
                                           {{{0, 0}, {2, 0}, {1, 0}}},
                                           {{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1, 0}, {0, 1}}}}) {
    const AxisBench bench(data_of_rings(nothing));
    CHECK(bench.count("outline-axis", "edges") == 0);
    CHECK(bench.count("outline-axis", "regions") == 0);
  }
}

TEST_CASE("every point of the axis is as far from two features as its radius says, and no side is nearer") {
  Rng rng(5);
  for (int round = 0; round < 20; ++round) {
    const std::vector<Ring> rings = polygon_with_hole(rng);
    const AxisBench bench(data_of_rings(rings));
    const OutlineGraph& graph = bench.axis().graph();
    // Any polygon with one hole has an axis with one cycle, in one piece.
    REQUIRE(graph.edges.size() == graph.nodes.size());
    const auto nearest = [&](Vec2 p) {
      double out = std::numeric_limits<double>::infinity();
      for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
          out = std::min(out, distance_to_side(p, ring[i], ring[(i + 1) % ring.size()]));
      return out;
    };
    for (const OutlinePiece& piece : bench.axis().pieces()) {
      CHECK(nearest(piece.from) == Approx(piece.radius_from).margin(1e-6));
      CHECK(nearest(piece.to) == Approx(piece.radius_to).margin(1e-6));
      const OutlineEdge& edge = graph.edges[piece.edge];
      for (const OutlineFeatureSlot slot : edge.features) {
        const OutlineFeature& feature = graph.features[slot];
        const double apart = feature.is_point() ? distance(piece.from, feature.from)
                                                : distance_to_side(piece.from, feature.from, feature.to);
        CHECK(apart == Approx(piece.radius_from).margin(1e-6));
      }
    }
    // All of the arc with this control point is equally far from both.
    for (const OutlineEdgeSlot slot : graph.edges.rows()) {
      const auto control = bench.axis().control(slot);
      if (!control) continue;
      const OutlineEdge& edge = graph.edges[slot];
      const OutlineFeature* point = &graph.features[edge.features[0]];
      const OutlineFeature* side = &graph.features[edge.features[1]];
      if (!point->is_point()) std::swap(point, side);
      for (int i = 0; i <= 8; ++i) {
        const Vec2 at =
            point_at({graph.nodes[edge.nodes[0]].center, *control, graph.nodes[edge.nodes[1]].center}, i / 8.0);
        CHECK(distance(at, point->from) == Approx(distance_to_side(at, side->from, side->to)).margin(1e-5));
      }
    }
  }
}

TEST_CASE("the layer draws an arc around a reflex corner as one parabola, whose focus is the corner") {
  // Around the corner at (1, 1), one arc for each of the two outer sides.
  AxisBench bench(data_of_rings({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}));
  const auto arcs = bench.instances("outline-axis", PrimitiveKind::parabola);
  constexpr std::size_t kStride = stride_of(PrimitiveKind::parabola);
  REQUIRE(arcs.size() == 2 * kStride);
  std::size_t of_lower_side = 0;
  double length = 0.0;
  for (std::size_t at = 0; at < arcs.size(); at += kStride) {
    const ParabolaArc arc = parabola_of(&arcs[at]);
    const bool is_of_lower = std::max(arc.from.x, arc.to.x) > std::max(arc.from.y, arc.to.y);
    of_lower_side += is_of_lower ? 1U : 0U;
    length += length_of(arc);
    for (int i = 0; i <= 16; ++i) {
      const Vec2 p = point_at(arc, i / 16.0);
      CHECK(distance(p, {1, 1}) == Approx(is_of_lower ? p.y : p.x).epsilon(1e-14));
    }
  }
  CHECK(of_lower_side == 1);
  const auto straight = bench.instances("outline-axis", PrimitiveKind::segment);
  CHECK(straight.size() == 7 * stride_of(PrimitiveKind::segment));
  for (std::size_t at = 0; at < straight.size(); at += stride_of(PrimitiveKind::segment))
    length += distance({straight[at], straight[at + 1]}, {straight[at + 2], straight[at + 3]});
  CHECK(length == Approx(bench.length()).epsilon(1e-3));
}

TEST_CASE("the axis is that of the segment Voronoi diagram of Boost.Polygon") {
  namespace bp = boost::polygon;
  Rng rng(11);
  for (int round = 0; round < 200; ++round) {
    const std::vector<Ring> rings = polygon_with_hole(rng);
    const AxisBench bench(data_of_rings(rings));
    std::vector<bp::segment_data<int>> sides;
    for (const Ring& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i];
        const Vec2 b = ring[(i + 1) % ring.size()];
        sides.emplace_back(bp::point_data<int>(static_cast<int>(a.x), static_cast<int>(a.y)),
                           bp::point_data<int>(static_cast<int>(b.x), static_cast<int>(b.y)));
      }
    bp::voronoi_diagram<double> diagram;
    bp::construct_voronoi(sides.begin(), sides.end(), &diagram);
    const auto is_inside = [&](Vec2 p) {
      bool inside = false;
      for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Vec2 a = ring[i];
          const Vec2 b = ring[(i + 1) % ring.size()];
          if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
      return inside;
    };
    std::size_t edges = 0;
    std::size_t curved = 0;
    for (const auto& edge : diagram.edges()) {
      if (!edge.is_primary() || !edge.is_finite() || &edge > edge.twin()) continue;
      const Vec2 a{edge.vertex0()->x(), edge.vertex0()->y()};
      const Vec2 b{edge.vertex1()->x(), edge.vertex1()->y()};
      if (!is_inside(0.5 * (a + b))) continue;
      ++edges;
      if (edge.is_curved()) ++curved;
      for (const Vec2 end : {a, b})
        CHECK(std::ranges::any_of(bench.axis().graph().nodes,
                                  [&](const OutlineNode& node) { return distance(node.center, end) < 1e-3; }));
    }
    CHECK(bench.axis().graph().edges.size() == edges);
    CHECK(bench.count("outline-axis", "parabolas") == static_cast<std::int64_t>(curved));
  }
}

TEST_CASE("sides may cross many times, but not by the hundred thousand") {
  const auto spokes = [](int count) {
    OutlineSides out;
    for (int i = 0; i < count; ++i) {
      const double angle = std::numbers::pi * i / count;
      const Vec2 end{std::cos(angle), std::sin(angle)};
      out.add(-1.0 * end, end, false);
    }
    return out;
  };
  JobControl job;
  OutlineSides some = spokes(40);
  CHECK(some.take(job).size() == 80);
  CHECK(some.crossings() == 40 * 39 / 2);
  CHECK_THROWS_AS(spokes(1000).take(job), SizeRefusal);
}

TEST_CASE("an outline that is there several times, or goes around several times, counts once") {
  const Ring triangle{{0.0, 0.0}, {8.0, 1.0}, {3.0, 6.0}};
  const Ring turned{triangle[1], triangle[2], triangle[0]};
  Ring twice = triangle;
  twice.insert(twice.end(), triangle.begin(), triangle.end());
  const auto curves_of = [](const std::vector<Ring>& rings) {
    std::vector<PlaneCurve> out;
    for (const Ring& ring : rings) {
      PlaneCurve& curve = out.emplace_back(ring.front());
      curve.lines_to(std::span(ring).subspan(1));
      curve.close();
    }
    return out;
  };
  const auto axis_of = [&](const std::vector<Ring>& rings) {
    return pieces_of(AxisBench(data_of_curves(curves_of(rings))).axis(), 1.0);
  };
  const auto faults_of = [&](const std::vector<Ring>& rings) {
    JobControl job;
    return faults_of_outlines(curves_of(rings), job);
  };
  const std::vector<PlainPiece> once = axis_of({triangle});
  REQUIRE(!once.empty());
  CHECK(axis_of({triangle, turned, triangle}) == once);
  CHECK(faults_of({triangle, turned, triangle}).same == 2);
  CHECK(axis_of({twice}) == once);
  CHECK(faults_of({twice}).repeated == 0);
  // In the other direction the second outline is that of a shape beyond the border.
  const Ring back(triangle.rbegin(), triangle.rend());
  CHECK(axis_of({triangle, back}).empty());
  // A circle of two arcs, from either end.
  PlaneCurve circle({2.0, 0.0});
  PlaneCurve other({-2.0, 0.0});
  const EllipticArc upper{{}, {2.0, 0.0}, {0.0, 2.0}, 0.0, std::numbers::pi};
  const EllipticArc lower{{}, {2.0, 0.0}, {0.0, 2.0}, std::numbers::pi, std::numbers::pi};
  circle.arc_to(upper, {-2.0, 0.0});
  circle.arc_to(lower, {2.0, 0.0});
  circle.close();
  other.arc_to(lower, {2.0, 0.0});
  other.arc_to(upper, {-2.0, 0.0});
  other.close();
  OutlineSides sides;
  OutlineSides sides_of_both;
  JobControl job;
  sides.add(std::vector{circle}, 0.01, job);
  sides_of_both.add(std::vector{circle, other}, 0.01, job);
  const std::vector<OutlineSide> wanted = sides.take(job);
  const std::vector<OutlineSide> both = sides_of_both.take(job);
  REQUIRE(both.size() == wanted.size());
  CHECK(std::ranges::all_of(both, &OutlineSide::separates));
}

TEST_CASE("crossings and repeated sides of outlines are those of all pairs") {
  constexpr int kPlaces = 12;
  Rng random(42);
  const auto place = [&] { return static_cast<double>(random.below(kPlaces)); };
  std::size_t crossings = 0;
  std::size_t repeated = 0;
  std::size_t overlaps = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<PlaneCurve> curves;
    using Side = std::pair<Vec2, Vec2>;
    std::vector<Side> all;
    std::vector<std::pair<std::size_t, bool>> uses;  // the ring of each side, and whether it lies above it
    std::size_t again = 0;
    std::size_t shared = 0;
    for (std::uint64_t rings = 1 + random.below(4); rings > 0; --rings) {
      PlaneCurve& curve = curves.emplace_back(Vec2{place(), place()});
      for (std::uint64_t corners = 2 + random.below(8); corners > 0; --corners) curve.line_to({place(), place()});
      curve.close();
      std::vector<Side> own;
      std::vector<bool> forward;
      double area = 0.0;
      for (std::size_t i = 0; i + 1 < curve.points().size(); ++i) {
        area += cross(curve.points()[i], curve.points()[i + 1]);
        Side side{curve.points()[i], curve.points()[i + 1]};
        if (side.first == side.second) continue;
        const bool is_forward = lexicographically_less(side.first, side.second);
        if (!is_forward) std::swap(side.first, side.second);
        if (std::ranges::find(own, side) == own.end()) {
          own.push_back(side);
          forward.push_back(is_forward);
        } else {
          ++again;
        }
      }
      all.insert(all.end(), own.begin(), own.end());
      for (const bool is_forward : forward) uses.emplace_back(rings, is_forward == (area > 0.0));
    }
    // Coordinates are small integers, so that plain arithmetic is exact.
    const auto turn = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); };
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto& [a, b] = all[i];
        const auto& [c, d] = all[j];
        if (turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0) ++pairs;
        const double shared_length =
            dot(b - a, std::min(b, d, lexicographically_less) - std::max(a, c, lexicographically_less));
        if (turn(a, b, c) != 0.0 || turn(a, b, d) != 0.0 || shared_length <= 0.0) continue;
        if (uses[i].first == uses[j].first) ++again;
        if (uses[i].first != uses[j].first && uses[i].second == uses[j].second) ++shared;
      }
    JobControl job;
    const OutlineFaults faults = faults_of_outlines(curves, job);
    CHECK(faults.crossings == pairs);
    CHECK(faults.repeated == again);
    // A ring that runs along a side twice counts for the side at which it does so first.
    if (again == 0) CHECK(faults.overlaps == shared);
    if (again == 0) overlaps += shared;
    crossings += pairs;
    repeated += again;
  }
  CHECK(overlaps > 10);
  CHECK(crossings > 1000);
  CHECK(repeated > 10);
}

TEST_CASE("the axis depends on the outline as a set") {
  Rng rng(17);
  for (int round = 0; round < 20; ++round) {
    std::vector<Ring> rings = polygon_with_hole(rng);
    const std::vector<PlainPiece> pieces = pieces_of(AxisBench(data_of_rings(rings)).axis(), 1.0);
    std::vector<Ring> other = rings;
    std::swap(other[0], other[1]);
    for (Ring& ring : other) {
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(rng.below(ring.size())), ring.end());
      if (rng.below(2) == 0) std::ranges::reverse(ring);
    }
    CHECK(pieces_of(AxisBench(data_of_rings(other)).axis(), 1.0) == pieces);
    for (Ring& ring : other)
      for (Vec2& p : ring) p = 0x1p-300 * p;
    CHECK(pieces_of(AxisBench(data_of_rings(other)).axis(), 0x1p300) == pieces);
  }
}

TEST_CASE("further samples on the sides change nothing") {
  const Ring polygon{{0, 0}, {64, 0}, {64, 32}, {32, 16}, {0, 64}};
  Ring refined;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    for (int k = 0; k < 8; ++k) refined.push_back(a + k / 8.0 * (b - a));
  }
  const AxisBench few(data_of_rings({polygon}));
  const AxisBench many(data_of_rings({refined}));
  CHECK(many.length() == Approx(few.length()));
  for (const OutlineNode& node : few.axis().graph().nodes) CHECK(many.has_node(node.center, node.radius));
}

TEST_CASE("parcels have an axis each, one tree in every rectangle") {
  for (const double angle : {0.0, 0.3}) {
    const Parcels map = parcels(40, angle, 2, 3);
    const AxisBench bench(data_of_curves(map.outlines));
    // Turned and rounded, corners no longer lie exactly on the sides that they meet: slivers are outside or apart.
    CHECK(bench.count("outline-axis", "regions") >= static_cast<std::int64_t>(map.boxes.size()));
    if (angle == 0.0) {
      CHECK(bench.count("outline-axis", "regions") == static_cast<std::int64_t>(map.boxes.size()));
      double length = 0.0;
      for (const Box2& box : map.boxes) {
        const double low = std::min(box.width(), box.height());
        length += 2.0 * std::numbers::sqrt2 * low + std::max(box.width(), box.height()) - low;
      }
      CHECK(bench.length() == Approx(length).epsilon(1e-3));
    }
  }
}

TEST_CASE("the axis follows vertices that are moved, and stays where samples of curves are") {
  TestBench bench;
  bench.show({"outline-axis"});
  bench.load(data_of_rings({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}));
  bench.move(bench.ids()[1], {4, 0});
  bench.move(bench.ids()[2], {4, 2});
  const auto has = [&](Vec2 at) {
    return std::ranges::any_of(bench.get<OutlineAxis>().graph().nodes,
                               [&](const OutlineNode& node) { return distance(node.center, at) < 1e-12; });
  };
  const std::vector<PlainPiece> moved = pieces_of(bench.get<OutlineAxis>(), 1.0);
  CHECK(moved == pieces_of(AxisBench(data_of_rings({{{0, 0}, {4, 0}, {4, 2}, {0, 2}}})).axis(), 1.0));
  bench.insert({{1, 1}});  // on no contour
  CHECK(moved == pieces_of(bench.get<OutlineAxis>(), 1.0));
  bench.undo();
  bench.undo();
  bench.undo();
  CHECK(has({1, 1}));
}

TEST_CASE("the deviation of the axis is the largest distance of its points, and falls with denser samples") {
  std::array<double, 2> before{1.0, 4.0};
  for (const int count : {8, 32, 128}) {
    // The sides of a rectangle. The axis of the samples ends before the corners, by less for denser samples.
    SampleData data;
    auto set = std::make_shared<CurveSet>();
    set->curves = {closed_polygon({{0, 0}, {4, 0}, {4, 2}, {0, 2}})};
    data.source = std::make_shared<const CurveSource>(CurveSource{.curves = set});
    for (int i = 0; i < count; ++i) {
      const double at = static_cast<double>(i) / count;
      for (const Vec2 p : {Vec2{4 * at, 0}, Vec2{4, 2 * at}, Vec2{4 - 4 * at, 2}, Vec2{0, 2 - 2 * at}})
        data.positions.push_back(p);
    }
    TestBench bench;
    bench.show({"axis-deviation", "medial-axis"});
    bench.load(data);
    const auto& deviation = bench.get<AxisDeviation>();
    const auto from_all = [&](Vec2 p, bool is_of_outline) {
      double out = std::numeric_limits<double>::infinity();
      for (const AxisDeviation::Piece& other : deviation.pieces())
        if (other.is_of_outline == is_of_outline) {
          const Vec2 along = other.to - other.from;
          const double t =
              dot(along, along) > 0.0 ? std::clamp(dot(p - other.from, along) / dot(along, along), 0.0, 1.0) : 0.0;
          out = std::min(out, distance(p, other.from + t * along));
        }
      return out;
    };
    for (const AxisDeviation::Piece& piece : deviation.pieces()) {
      double seen = 0.0;
      constexpr int kSteps = 200;
      for (int k = 0; k <= kSteps; ++k)
        seen = std::max(seen, from_all(piece.from + static_cast<double>(k) / kSteps * (piece.to - piece.from),
                                       !piece.is_of_outline));
      CHECK(piece.distance >= seen / (1.0 + 0x1p-10) - 1e-12);
      CHECK(piece.distance <= seen + distance(piece.from, piece.to) / kSteps + 1e-12);
    }
    CHECK(bench.measure("axis-deviation", "hausdorff_distance") ==
          std::max(deviation.largest(false), deviation.largest(true)));
    CHECK(deviation.largest(false) < 0.3 * before[0]);
    CHECK(deviation.largest(true) < 0.3 * before[1]);
    before = {deviation.largest(false), deviation.largest(true)};
  }
}
