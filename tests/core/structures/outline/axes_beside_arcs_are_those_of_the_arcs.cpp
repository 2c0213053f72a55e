// SPDX-License-Identifier: GPL-3.0-or-later
// The axis of outlines with arcs: formulas, distances from the curves themselves, and images of an outline.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/curves/affine.h"
#include "core/structures/filters/paths/center_line.h"
#include "core/structures/outline/outline_center_lines.h"
#include "core/structures/outline/outline_sides.h"
#include "tests/core/structures/outline/outline_bench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr double kFlatAngle = std::numbers::pi;

/// Goes on along a circle, counter-clockwise for a positive sweep.
void turn(PlaneCurve& curve, Vec2 center, double radius, double start, double sweep) {
  curve.arc_to({center, {radius, 0}, {0, radius}, start, sweep},
               center + radius * Vec2{std::cos(start + sweep), std::sin(start + sweep)});
}

PlaneCurve circle(Vec2 center, double radius, int arcs = 1) {
  PlaneCurve out(center + Vec2{radius, 0});
  for (int i = 0; i < arcs; ++i) turn(out, center, radius, 2 * kFlatAngle * i / arcs, 2 * kFlatAngle / arcs);
  out.close();
  return out;
}

/// A stadium, 14 by 4.
PlaneCurve slot() {
  PlaneCurve out({-5, -2});
  out.line_to({5, -2});
  turn(out, {5, 0}, 2, -0.5 * kFlatAngle, kFlatAngle);
  out.line_to({-5, 2});
  turn(out, {-5, 0}, 2, 0.5 * kFlatAngle, kFlatAngle);
  out.close();
  return out;
}

/// The upper half of a disk of radius 7.
PlaneCurve half_disk() {
  PlaneCurve out({-7, 0});
  out.line_to({7, 0});
  turn(out, {0, 0}, 7, 0, kFlatAngle);
  out.close();
  return out;
}

double error_of(const OutlineAxis& axis, auto distance_from_curve) {
  double out = 0.0;
  for (const OutlineNode& node : axis.graph().nodes)
    out = std::max(out, std::abs(distance_from_curve(node.center) - node.radius));
  for (const OutlinePiece& piece : axis.pieces())
    out = std::max(out, std::abs(distance_from_curve(piece.to) - piece.radius_to));
  return out;
}

}  // namespace

TEST_CASE(
    "a disk has its centre, a slot its middle line, and a rounded rectangle ends at the centres of its corners") {
  for (const int arcs : {1, 2, 4, 7}) {
    const AxisBench disk(data_of_curves({circle({10, 20}, 7, arcs)}));
    CHECK(disk.count("outline-axis", "edges") == 0);
    CHECK(disk.count("outline-axis", "nodes") == 1);
    CHECK(disk.count("outline-axis", "regions") == 1);
    CHECK(disk.has_node({10, 20}, 7));
  }
  const AxisBench middle(data_of_curves({slot()}));
  CHECK(middle.count("outline-axis", "edges") == 1);
  CHECK(middle.has_node({-5, 0}, 2));
  CHECK(middle.has_node({5, 0}, 2));
  CHECK(middle.length() == Approx(10));

  PlaneCurve rounded({-6, -5});
  for (int i = 0; i < 4; ++i) {
    const std::array<Vec2, 4> corners{Vec2{6, -3}, {6, 3}, {-6, 3}, {-6, -3}};
    const std::array<Vec2, 4> sides{Vec2{6, -5}, {8, 3}, {-6, 5}, {-8, -3}};
    rounded.line_to(sides[static_cast<std::size_t>(i)]);
    turn(rounded, corners[static_cast<std::size_t>(i)], 2, kFlatAngle * (0.5 * i - 0.5), 0.5 * kFlatAngle);
  }
  rounded.close();
  const AxisBench corners(data_of_curves({rounded}));
  CHECK(corners.count("outline-axis", "edges") == 5);
  CHECK(corners.count("outline-axis", "nodes") == 6);
  for (const Vec2 corner : {Vec2{6, -3}, {6, 3}, {-6, 3}, {-6, -3}}) CHECK(corners.has_node(corner, 2));
  CHECK(corners.has_node({3, 0}, 5));
}

TEST_CASE("between a circle and a circle, a line, or a point the axis is their bisector") {
  const Vec2 far{512'000, 5'400'000};  // as on a map
  for (const Vec2 origin : {Vec2{}, far}) {
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * (10 + length(origin));
    const auto moved = [&](PlaneCurve curve) {
      curve.transform(Affine::translation(origin.x, origin.y));
      return curve;
    };
    // Two circles about one point, then about two.
    for (const Vec2 hole : {Vec2{}, Vec2{1.5, 0.5}}) {
      const AxisBench ring(data_of_curves({moved(circle({}, 7)), moved(circle(hole, 3))}));
      REQUIRE(ring.count("outline-axis", "edges") > 100);
      for (const OutlineNode& node : ring.axis().graph().nodes) {
        const Vec2 at = node.center - origin;
        CHECK(std::abs(7 - length(at) - node.radius) <= rounding);
        CHECK(std::abs(distance(at, hole) - 3 - node.radius) <= rounding);
      }
    }
    // The parabola of a half disk: y = 7 - |(x, y)|.
    const AxisBench half(data_of_curves({moved(half_disk())}));
    REQUIRE(half.count("outline-axis", "edges") > 30);
    for (const OutlineNode& node : half.axis().graph().nodes) {
      const Vec2 at = node.center - origin;
      CHECK(std::abs(at.y - (49 - at.x * at.x) / 14) <= rounding);
      CHECK(std::abs(at.y - node.radius) <= rounding);
    }
  }
}

TEST_CASE("arcs that are rounded, or end at corners, have no branches that their shapes lack") {
  // A slot whose arcs and sides meet up to a thousandth, with short lines between.
  const double turned = 0.7;
  const auto placed = [&](Vec2 p) {
    const Vec2 at = std::cos(turned) * p + std::sin(turned) * perpendicular(p);
    return Vec2{std::round(1e3 * at.x) / 1e3, std::round(1e3 * at.y) / 1e3};
  };
  PlaneCurve rounded(placed({-5, -2}));
  for (const double side : {1.0, -1.0}) {
    rounded.line_to(placed({side * 5, side * -2}));
    const Vec2 center = placed({side * 5, 0});
    const double start = turned + (side > 0 ? -0.5 : 0.5) * kFlatAngle;
    rounded.line_to(center + 2.0 * Vec2{std::cos(start), std::sin(start)});
    turn(rounded, center, 2, start, kFlatAngle);
  }
  rounded.close();
  const AxisBench middle(data_of_curves({rounded}));
  CHECK(middle.length() == Approx(10).margin(1e-2));
  CHECK(middle.count("outline-axis", "edges") <= 3);

  // Three teeth on one circle: the arcs are parts of it, and their ends are corners.
  PlaneCurve teeth({10, 0});
  for (int i = 0; i < 3; ++i) {
    turn(teeth, {}, 10, 2 * kFlatAngle * i / 3, 0.5 * kFlatAngle);
    teeth.line_to(11.0 *
                  Vec2{std::cos(kFlatAngle * (2.0 * i / 3 + 0.58)), std::sin(kFlatAngle * (2.0 * i / 3 + 0.58))});
    teeth.line_to(10.0 * Vec2{std::cos(2 * kFlatAngle * (i + 1) / 3), std::sin(2 * kFlatAngle * (i + 1) / 3)});
  }
  teeth.close();
  const AxisBench gear(data_of_curves({teeth}));
  CHECK(gear.has_node({}, 10));
  CHECK(gear.count("outline-axis", "edges") < 40);

  // A box with an arc that bulges out of its upper side: below the centre of the arc its ends are nearest.
  PlaneCurve box({-50, 0});
  for (const Vec2 p : {Vec2{50, 0}, {50, 40}, {10, 40}}) box.line_to(p);
  const double height = 10 / std::tan(0.3 * kFlatAngle);
  turn(box, {0, 40 - height}, std::hypot(10, height), 0.2 * kFlatAngle, 0.6 * kFlatAngle);
  box.line_to({-50, 40});
  box.close();
  const AxisBench dome(data_of_curves({box}));
  const auto to_side = [](Vec2 p, Vec2 from, Vec2 to) {
    const Vec2 along = to - from;
    return distance(p, from + std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0) * along);
  };
  const auto from_box = [&](Vec2 p) {
    const Vec2 center{0, 40 - height};
    double out =
        std::min({to_side(p, {-50, 0}, {50, 0}), to_side(p, {50, 0}, {50, 40}), to_side(p, {50, 40}, {10, 40}),
                  to_side(p, {-10, 40}, {-50, 40}), to_side(p, {-50, 40}, {-50, 0})});
    if (p.y - center.y > std::abs(p.x) * height / 10)
      out = std::min(out, std::hypot(10, height) - distance(p, center));
    return out;
  };
  REQUIRE(dome.count("outline-axis", "nodes") >= 10);
  for (const OutlineNode& node : dome.axis().graph().nodes)
    CHECK(from_box(node.center) == Approx(node.radius).margin(1e-9));
}

TEST_CASE("curved edges leave the bisector by a thousandth of the radius at most") {
  const AxisBench half(data_of_curves({half_disk()}));
  const auto from_half_disk = [](Vec2 p) { return std::min(p.y, 7 - length(p)); };
  CHECK(error_of(half.axis(), from_half_disk) <= 7.0 / 1024);
  double controls = 0;
  for (const OutlineEdgeSlot edge : half.axis().graph().edges.rows()) {
    const auto control = half.axis().control(edge);
    if (!control) continue;
    ++controls;
    const auto& [from, to] = half.axis().graph().edges[edge].nodes;
    const Vec2 middle =
        0.25 * half.axis().graph().nodes[from].center + 0.5 * *control + 0.25 * half.axis().graph().nodes[to].center;
    CHECK(middle.y == Approx((49 - middle.x * middle.x) / 14).margin(1e-6));
  }
  CHECK(controls > 30);
}

TEST_CASE("the width of a ring is the difference of its radii") {
  const AxisBench ring(data_of_curves({circle({}, 7, 2), circle({}, 3, 2)}));
  JobControl job;
  CenterLines lines = center_lines_of(ring.axis(), {}, job);
  REQUIRE(lines.lines.size() == 1);
  CenterLine& line = lines.lines.front();
  CHECK(line.is_closed);
  take_axis(line);
  for (const Station& station : stations_of(line, 0.1)) {
    CHECK(station.width == Approx(4).epsilon(1e-12));
    CHECK(std::abs(length(station.left) + length(station.right) - 10) < 1e-9);
  }
}

TEST_CASE("the axis of an ellipse ends at its centres of curvature") {
  for (const double turned : {0.0, 0.3}) {
    const Vec2 u = 8.0 * Vec2{std::cos(turned), std::sin(turned)};
    const Vec2 v = 0.5 * perpendicular(u);
    PlaneCurve ellipse(u);
    ellipse.arc_to({{}, u, v, 0, 2 * kFlatAngle}, u);
    ellipse.close();
    const AxisBench bench(data_of_curves({ellipse}));
    // a - b^2 / a from the middle, with radius b^2 / a
    for (const double sign : {-1.0, 1.0}) {
      const Vec2 end = (sign * 6.0 / 8.0) * u;
      const auto is_end = [&](const OutlineNode& node) {
        return distance(node.center, end) < 1e-3 && std::abs(node.radius - 2.0) < 1e-3;
      };
      CHECK(std::ranges::count_if(bench.axis().graph().nodes, is_end) == 1);
    }
    CHECK(bench.length() == Approx(12).margin(2e-3));
    double off = 0.0;
    for (const OutlineNode& node : bench.axis().graph().nodes)
      off = std::max(off, std::abs(dot(node.center, v)) / length(v));
    CHECK(off < 1e-3);
  }
}

TEST_CASE("the axis beside arcs does not depend on where curves begin and how they run") {
  PlaneCurve backwards({5, -2});
  backwards.line_to({-5, -2});
  turn(backwards, {-5, 0}, 2, -0.5 * kFlatAngle, -kFlatAngle);
  backwards.line_to({5, 2});
  turn(backwards, {5, 0}, 2, 0.5 * kFlatAngle, -kFlatAngle);
  backwards.close();
  const PlaneCurve hole = circle({4, 0.25}, 1);
  const AxisBench one(data_of_curves({slot(), hole}));
  const AxisBench other(data_of_curves({hole, backwards}));
  const auto a = pieces_of(one.axis(), 1.0);
  const auto b = pieces_of(other.axis(), 1.0);
  REQUIRE(a.size() > 50);
  CHECK(a.size() == b.size());
  CHECK(one.length() == Approx(other.length()).epsilon(1e-9));
}

TEST_CASE("a curved side that two shapes share has the same chords in both directions") {
  Rng rng(7);
  for (int i = 0; i < 400; ++i) {
    const Vec2 from{rng.uniform(-50.0, 50.0), rng.uniform(-50.0, 50.0)};
    const Vec2 to = from + Vec2{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)};
    const double half = rng.uniform(0.1, 1.2);  // of the angle of the arc
    const double radius = 0.5 * distance(from, to) / std::sin(half);
    PlaneCurve one(from);
    PlaneCurve other(to);
    if (i % 4 == 0) {  // as bulges of DXF
      const auto add = [](PlaneCurve& curve, Vec2 end, double bulge) {
        const Vec2 center =
            0.5 * (curve.end() + end) + (1.0 - bulge * bulge) / (4.0 * bulge) * perpendicular(end - curve.end());
        const Vec2 u = curve.end() - center;
        curve.arc_to({center, u, perpendicular(u), 0.0, 4.0 * std::atan(bulge)}, end);
      };
      add(one, to, -std::tan(0.5 * half));
      add(other, from, std::tan(0.5 * half));
    } else if (i % 4 == 1) {
      const Vec2 a = from + 0.3 * perpendicular(to - from) + 0.2 * (to - from);
      const Vec2 b = to + 0.4 * perpendicular(to - from) - 0.1 * (to - from);
      one.cubic_to(a, b, to);
      other.cubic_to(b, a, from);
    } else {  // circles and ellipses of SVG, turning clockwise from the first end
      const Vec2 radii = i % 4 == 2 ? Vec2{radius, radius} : Vec2{1.2 * radius, 1.5 * radius};
      one.arc_to(arc_between(from, to, radii, 0.4, false, false).value(), to);
      other.arc_to(arc_between(to, from, radii, 0.4, false, true).value(), from);
    }
    one.close();
    other.line_to(0.5 * (from + to) + 10.0 * perpendicular(to - from));
    other.close();
    JobControl job;
    const OutlineFaults faults = faults_of_outlines(std::array{one, other}, job);
    CHECK(faults.crossings == 0);
    CHECK(faults.overlaps == 0);
    CHECK(faults.repeated == 0);
  }
}

TEST_CASE("shapes that share a part of an arc have the same chords along it, and none cross") {
  Rng rng(11);
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    const Vec2 center{rng.uniform(-50.0, 50.0), rng.uniform(-50.0, 50.0)};
    const double radius = rng.uniform(1.0, 30.0);
    const auto at = [&](double angle) { return center + radius * Vec2{std::cos(angle), std::sin(angle)}; };
    const double begin = rng.uniform(0.0, 6.0);
    const double end = begin + rng.uniform(0.6, 2.6);
    // An arc that begins or ends between the ends of the first, lies in it, or holds it.
    const double other_begin = begin + rng.uniform(-0.25, 0.25);
    const double other_end = end + rng.uniform(-0.25, 0.25);
    const auto go = [&](PlaneCurve& curve, double to, bool turns_left) {
      curve.arc_to(arc_between(curve.end(), at(to), {radius, radius}, 0.0, false, turns_left).value(), at(to));
    };
    PlaneCurve segment(at(begin));
    go(segment, end, true);
    segment.close();
    PlaneCurve around(at(other_end));
    go(around, other_begin, false);
    const double middle = 0.5 * (begin + end);
    around.line_to(center + 2.0 * (at(other_begin) - center));
    around.line_to(center + 2.0 * (at(middle) - center));
    around.line_to(center + 2.0 * (at(other_end) - center));
    around.close();
    const std::vector<PlaneCurve> curves{segment, around};
    JobControl job;
    CHECK(faults_of_outlines(curves, job).crossings == 0);
    OutlineSides sides;
    sides.add(curves, 1e-3, job);
    double shared = 0.0;
    for (const OutlineSide& side : sides.take(job))
      if (!side.separates) shared += distance(side.from, side.to);
    CHECK(sides.crossings() == 0);
    CHECK(shared == Approx(radius * (std::min(end, other_end) - std::max(begin, other_begin))).epsilon(1e-3));
  }
}

TEST_CASE("circles that touch from inside, thin lenses and thin rings have their axis, however they are turned") {
  const auto length_of_axis = [](const std::vector<PlaneCurve>& curves) {
    const AxisBench bench(data_of_curves(curves));
    double out = 0.0;
    for (const OutlinePiece& piece : bench.axis().pieces()) out += distance(piece.from, piece.to);
    return out;
  };
  const auto faults_of = [](const std::vector<PlaneCurve>& curves) {
    JobControl job;
    const OutlineFaults out = faults_of_outlines(curves, job);
    return std::array{out.crossings, out.overlaps, out.repeated};
  };
  constexpr std::array<std::size_t, 3> kNone{};  // no crossings, overlaps and repeated sides
  for (const double turned : {0.1, 0.3, 1.0, 2.2, 4.0}) {
    CAPTURE(turned);
    const Vec2 away{std::cos(turned), std::sin(turned)};
    // The axis is the ellipse with the two centres as foci, which passes through the point of contact.
    const std::vector<PlaneCurve> crescent{circle({}, 5.0), circle(2.0 * away, 3.0)};
    const double a = 4.0;
    const double b = std::sqrt(a * a - 1.0);
    const double h = (a - b) * (a - b) / ((a + b) * (a + b));
    const double around = kFlatAngle * (a + b) * (1.0 + h / 4.0 + h * h / 64.0 + h * h * h / 256.0);
    CHECK(faults_of(crescent) == kNone);
    CHECK(length_of_axis(crescent) == Approx(around).epsilon(1e-3));

    const std::vector<PlaneCurve> ring{circle({}, 10.0), circle(1e-5 * away, 9.9999)};
    CHECK(faults_of(ring) == kNone);
    CHECK(length_of_axis(ring) == Approx(2.0 * kFlatAngle * 9.99995).epsilon(1e-6));

    const double radius = 150'000.0;  // arcs of height 0.003
    PlaneCurve lens(-30.0 * away);
    for (const double end : {1.0, -1.0})
      lens.arc_to(arc_between(lens.end(), 30.0 * end * away, {radius, radius}, 0.0, false, true).value(),
                  30.0 * end * away);
    lens.close();
    CHECK(faults_of({lens}) == kNone);
    CHECK(length_of_axis({lens}) == Approx(60.0).epsilon(1e-6));
  }
}
