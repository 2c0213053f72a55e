// SPDX-License-Identifier: GPL-3.0-or-later
// Hairs that the sampling leaves on the axis of grown balls: which go, that only free ends go, and that nothing depends
// on the order of the rows.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/balls/internal/sampling/scale_hairs.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// Pieces between nodes of a graph; each is seen from v-points of its own, at the ends of a chord across its middle, or
/// beside it.
struct Drawn {
  std::vector<Vec2> nodes;
  struct Piece {
    int a, b;
    double chord;  ///< of its v-points
    double away;   ///< of them from the end that is nearer to them, along the piece; negative: they are across it
  };
  std::vector<Piece> pieces;
};

UnionTables tables_of(const Drawn& drawn, const std::vector<std::size_t>& order,
                      const std::vector<std::size_t>& names) {
  UnionTables t;
  t.balls.resize(drawn.nodes.size(), BallState::visible);
  for (const std::size_t i : order) {
    const Drawn::Piece& from = drawn.pieces[i];
    const Vec2 a = drawn.nodes[static_cast<std::size_t>(from.a)];
    const Vec2 b = drawn.nodes[static_cast<std::size_t>(from.b)];
    const Vec2 along = (1.0 / distance(a, b)) * (b - a);
    const Vec2 across{-along.y, along.x};
    const Vec2 middle = from.away < 0.0 ? 0.5 * a + 0.5 * b : a - from.away * along;
    AxisPiece piece{.a = a, .b = b};
    for (const std::size_t side : {0U, 1U}) {
      piece.v[side] = VPointSlot(t.v_points.size());
      t.v_points.push_back({middle + (side == 0 ? 0.5 : -0.5) * from.chord * across, kNoSlot, 1});
      t.v_origins.push_back({piece.v[side], DualEdgeSlot(t.dual_edges.size())});
    }
    piece.radius_a = distance(a, t.v_points[piece.v[0]].position);
    piece.radius_b = distance(b, t.v_points[piece.v[0]].position);
    piece.node[0] = AxisNodeSlot(names[static_cast<std::size_t>(from.a)]);
    piece.node[1] = AxisNodeSlot(names[static_cast<std::size_t>(from.b)]);
    t.dual_edges.push_back({{FamilySlot(0), FamilySlot(0)}});
    t.axis.push_back(piece);
  }
  return t;
}

std::vector<std::size_t> in_order(std::size_t count) {
  std::vector<std::size_t> out(count);
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

/// Which pieces are left, by their number in `drawn`.
std::vector<bool> left_of(const Drawn& drawn, double spacing, std::vector<std::size_t> order,
                          const std::vector<std::size_t>& names) {
  UnionTables t = tables_of(drawn, order, names);
  const ScaleHairs hairs = cut_hairs(t, Table<FamilySlot, double>(t.balls.size(), spacing));
  std::vector<bool> out(drawn.pieces.size());
  std::int64_t cut = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    out[order[i]] = t.axis[AxisPieceSlot(i)].is_alive();
    cut += out[order[i]] ? 0 : 1;
  }
  CHECK(hairs.pieces == cut);
  return out;
}
std::vector<bool> left_of(const Drawn& drawn, double spacing) {
  return left_of(drawn, spacing, in_order(drawn.pieces.size()), in_order(drawn.nodes.size()));
}

/// A comb outline: straight sides, sampled evenly from corner to corner.
std::vector<Vec2> comb_samples(int teeth, double tooth, double gap, double length, double beam, double step) {
  std::vector<Vec2> corners{{0.0, 0.0}, {teeth * (tooth + gap) - gap, 0.0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = i * (tooth + gap);
    corners.push_back({left + tooth, i == teeth - 1 ? beam + length : beam});
    if (i != teeth - 1) corners.push_back({left + tooth, beam + length});
    corners.push_back({left, beam + length});
    if (i != 0) corners.push_back({left, beam});
  }
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 b = corners[(i + 1) % corners.size()];
    const int parts = static_cast<int>(std::ceil(distance(a, b) / step));
    for (int k = 0; k < parts; ++k) out.push_back(a + (static_cast<double>(k) / parts) * (b - a));
  }
  return out;
}

}  // namespace

TEST_CASE("a free end goes where its v-points are near to each other and seen at a small angle") {
  // A stem from 0 to 1, with a piece from 1 to 2 that ends before its v-points.
  const auto with = [](double chord, double away) {
    return Drawn{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}}, {{0, 1, 8.0, -1.0}, {2, 1, chord, away}}};
  };
  CHECK(left_of(with(1.9, 20.0), 1.0) == std::vector{true, false});
  CHECK(left_of(with(2.1, 20.0), 1.0) == std::vector{true, true});  // farther than the spacings of both
  CHECK(left_of(with(1.9, 1.0), 1.0) == std::vector{true, true});   // seen at 87 degrees
  CHECK(left_of(with(1.9, 1.7), 1.0) == std::vector{true, false});  // at 58
  CHECK(left_of(with(1.9, -1.0), 1.0) == std::vector{true, true});  // between them
  CHECK(left_of(with(0.0, -1.0), 1.0) == std::vector{true, true});  // along which two disks touch in a point
}

TEST_CASE("between what stays nothing goes, and of a component of hairs one piece stays") {
  // A cycle of short pieces stays, a twig on it goes with what hangs on it.
  const Drawn cycle{{{0, 0}, {4, 0}, {2, 3}, {8, 0}, {9, 2}},
                    {{0, 1, 0.5, 20.0}, {1, 2, 0.5, 20.0}, {2, 0, 0.5, 20.0}, {1, 3, 0.5, 20.0}, {3, 4, 0.5, 20.0}}};
  CHECK(left_of(cycle, 1.0) == std::vector{true, true, true, false, false});
  // A path whose middle alone is short.
  const Drawn path{{{0, 0}, {4, 0}, {8, 0}, {12, 0}}, {{0, 1, 8.0, -1.0}, {1, 2, 0.5, 20.0}, {2, 3, 8.0, -1.0}}};
  CHECK(left_of(path, 1.0) == std::vector{true, true, true});
  // A star of hairs keeps the one that is seen at the largest angle.
  const Drawn star{{{0, 0}, {4, 0}, {0, 4}, {-4, 0}}, {{1, 0, 0.5, 9.0}, {2, 0, 0.5, 5.0}, {3, 0, 0.5, 7.0}}};
  CHECK(left_of(star, 1.0) == std::vector{false, true, false});
}

TEST_CASE("hairs are cut from free ends inwards, in whatever order rows come") {
  Rng rng(7);
  for (int run = 0; run < 200; ++run) {
    INFO("run " << run);
    Drawn drawn;
    const int count = 2 + static_cast<int>(rng.below(30));
    for (int i = 0; i < count; ++i) drawn.nodes.push_back({100.0 * rng.uniform(), 100.0 * rng.uniform()});
    const auto piece = [&](int a, int b) {
      drawn.pieces.push_back({a, b, rng.below(3) == 0 ? 5.0 : 1.0 + 0.5 * rng.uniform(), 20.0 + rng.uniform()});
    };
    for (int i = 1; i < count; ++i) {
      if (rng.below(8) != 0) piece(i, static_cast<int>(rng.below(static_cast<std::uint32_t>(i))));
    }
    for (int i = 0; i + 2 < count; i += 9) piece(i, i + 2);
    // Leaves one by one, as long as there are any that may go; the last piece of a component stays.
    std::vector<bool> expected(drawn.pieces.size(), true);
    const auto degree = [&](int node) {
      int out = 0;
      for (std::size_t i = 0; i < drawn.pieces.size(); ++i)
        if (expected[i]) out += (drawn.pieces[i].a == node ? 1 : 0) + (drawn.pieces[i].b == node ? 1 : 0);
      return out;
    };
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (std::size_t i = 0; i < drawn.pieces.size(); ++i) {
        const Drawn::Piece& at = drawn.pieces[i];
        if (!expected[i] || at.chord > 2.0) continue;
        const int a = degree(at.a);
        const int b = degree(at.b);
        if ((a == 1) == (b == 1)) continue;
        expected[i] = false;
        is_changed = true;
      }
    }
    const auto left = left_of(drawn, 1.0);
    // A component of hairs alone may keep another piece here.
    CHECK(std::ranges::count(left, true) == std::ranges::count(expected, true));
    for (std::size_t i = 0; i < left.size(); ++i)
      if (drawn.pieces[i].chord > 2.0) CHECK(left[i]);
    for (int again = 0; again < 3; ++again) {
      auto order = in_order(drawn.pieces.size());
      auto names = in_order(drawn.nodes.size());
      for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[rng.below(static_cast<std::uint32_t>(i))]);
      for (std::size_t i = names.size(); i > 1; --i)
        std::swap(names[i - 1], names[rng.below(static_cast<std::uint32_t>(i))]);
      CHECK(left_of(drawn, 1.0, order, names) == left);
    }
  }
}

TEST_CASE("the scale axis of a comb has a free end for each tooth and corner, and none for each sample") {
  TestBench bench;
  bench.show({"scale-axis"});
  bench.replace(comb_samples(8, 0.2, 0.1, 1.0, 0.4, 0.05));
  ComputationSettings settings;
  const auto at = [&](double s) {
    settings[Parameter::scale_axis_factor] = s;
    bench.choose(settings);
    CHECK(bench.count("scale-union", "chi") == bench.count("scale-union", "chi_dual"));
    CHECK(bench.count("scale-union", "components") == 1);
    return bench.count("scale-union", "leaves");
  };
  // Two corners of each tooth, and two of the beam.
  CHECK(at(1.0) == 18);
  CHECK(bench.count("scale-union", "hairs") == 0);
  CHECK(at(1.3) == 18);
  CHECK(bench.count("scale-union", "hairs") > 0);
  // The gaps are filled; teeth stand out as their ends, beside them the corners of the beam and what is thicker in it.
  CHECK(at(2.0) <= 22);
  CHECK(bench.count("scale-union", "hairs") > 20);
}

TEST_CASE("just above a factor of 1 the axis of noisy samples keeps its branches") {
  Rng rng(4);
  std::vector<Vec2> samples;
  for (int i = 0; i < 200; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 200.0;
    const double r = 1.0 + 0.005 * rng.uniform(-1.0, 1.0);
    samples.push_back({3.0 * r * std::cos(t), r * std::sin(t)});
  }
  TestBench bench;
  bench.show({"scale-axis"});
  bench.replace(samples);
  ComputationSettings settings;
  const auto length_at = [&](double s) {
    settings[Parameter::scale_axis_factor] = s;
    bench.choose(settings);
    return bench.measure("scale-union", "length");
  };
  const double whole = length_at(1.0);
  CHECK(length_at(1.0 + 1e-9) == Approx(whole).epsilon(1e-4));
  CHECK(length_at(1.3) < 0.8 * whole);
}

// Two clusters whose grown balls touch: rounding leaves edges of the dual complex without crossings.
TEST_CASE("crossings that the number type naive has lost end nothing") {
  TestBench bench;
  bench.show({"scale-axis"});
  ComputationSettings settings;
  settings.precision = Precision::naive;
  settings[Parameter::scale_axis_factor] = 2.5321778220419997;
  bench.choose(settings);
  bench.replace({{-0.20405638649610558, -0.37148990157986611},
                 {0.59616941315069338, -1.6808865712522887},
                 {1.7388874267537853, -0.78526608521453189},
                 {0.97114851195948859, 0.28192439195925778},
                 {-3.4276774489156407, 0.6464391004537613},
                 {-3.0169920852702177, 0.095153049001204915},
                 {-2.3958941847562238, 0.45501322402553779},
                 {-2.7843348808395181, 1.1255993221388358}});
  CHECK(bench.count("scale-union", "balls") > 0);
}
