// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines as a hand draws them: closed, 600 samples, some close together and some far apart. No certificate covers
// their polar balls, nor scaled balls; the default decides both as `exact` does.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/structures/balls/ball_union.h"
#include "core/structures/poles/polar_union.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

ComputationSettings settings_of(Precision precision, double scale, bool use_shortcut = true) {
  ComputationSettings out;
  out.precision = precision;
  out[Parameter::a_scale] = scale;
  out[Parameter::p_scale] = scale;
  out[Parameter::union_shortcut] = use_shortcut ? 1.0 : 0.0;
  return out;
}

// From what lies along horizontal lines: the intervals of the disks, sorted.
double area_along_lines(const BallFamily& family) {
  struct Span {
    double from, to;
  };
  std::vector<Disk> disks;
  double low = 1e9, high = -1e9;
  for (std::size_t row = 0; row < family.rows(); ++row) {
    if (!family.is_ball(FamilySlot(row))) continue;
    disks.push_back(family.disk(FamilySlot(row)));
    low = std::min(low, disks.back().center.y - disks.back().radius);
    high = std::max(high, disks.back().center.y + disks.back().radius);
  }
  constexpr int kLines = 20000;
  const double step = (high - low) / kLines;
  double out = 0.0;
  std::vector<Span> spans;
  for (int line = 0; line < kLines; ++line) {
    const double y = low + (line + 0.5) * step;
    spans.clear();
    for (const Disk& disk : disks) {
      const double dy = y - disk.center.y;
      if (std::abs(dy) >= disk.radius) continue;
      const double half = std::sqrt((disk.radius - dy) * (disk.radius + dy));
      spans.push_back({disk.center.x - half, disk.center.x + half});
    }
    std::ranges::sort(spans, {}, &Span::from);
    double end = -1e9;
    for (const Span& span : spans) {
      out += step * std::max(0.0, span.to - std::max(span.from, end));
      end = std::max(end, span.to);
    }
  }
  return out;
}

constexpr std::string_view kFound[] = {"visible",       "hidden", "duplicates", "dual_singular", "dual_regular",
                                       "v_points",      "nodes",  "edges",      "components",    "cycles",
                                       "branch_points", "leaves", "isolated",   "chi",           "chi_dual"};

}  // namespace

TEST_CASE("balls of samples are decided exactly by default") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    // As it comes, and on the grid of a screen.
    for (const double grid : {0x1p-40, 1.0}) {
      for (const double scale : {1.0, 1.1, 0.95}) {
        INFO("seed " << seed << ", grid " << grid << ", scale " << scale);
        TestBench bench;
        bench.show({"a-ball-medial-axis", "p-ball-medial-axis", "a-union-boundary", "p-union-boundary"});
        bench.choose(settings_of(Precision::fast, scale));
        bench.replace(drawn_by_hand(600, seed, grid));
        TestBench exact;
        exact.show({"a-ball-medial-axis", "p-ball-medial-axis", "a-union-boundary", "p-union-boundary"});
        exact.choose(settings_of(Precision::exact, scale));
        exact.replace(drawn_by_hand(600, seed, grid));
        const auto check = [&](std::string_view id, const BallUnion& balls) {
          INFO(id);
          REQUIRE(balls.is_exact());
          REQUIRE(bench.count(id, "visible") > 60);
          for (const std::string_view key : kFound) {
            INFO(key);
            CHECK(bench.count(id, key) == exact.count(id, key));
          }
          CHECK(bench.count(id, "chi") == bench.count(id, "chi_dual"));
          if (balls.rung() == UnionRung::shortcut) return;
          for (const std::string_view key : {"sign_flips", "lost_crossings", "contradictions", "negative_radicands"})
            CHECK(bench.count(id, key) == 0);
          CHECK(bench.measure(id, "area") == Approx(area_along_lines(balls.family())).epsilon(1e-5));
        };
        check("p-union", bench.get<PUnion>());
        check("a-union", bench.get<AUnion>());
        for (const LayerIndex layer : all_layers())
          CHECK(bench.contents().sorted(layer) == exact.contents().sorted(layer));
      }
    }
  }
}

TEST_CASE("without the shortcut unions are those of the number type") {
  TestBench bench;
  bench.show({"p-ball-medial-axis", "a-ball-medial-axis"});
  bench.replace(drawn_by_hand(600, 4, 1.0));
  bench.choose(settings_of(Precision::fast, 1.0, false));
  CHECK(bench.get<PUnion>().rung() == UnionRung::doubles);
  CHECK(bench.get<AUnion>().rung() == UnionRung::doubles);
  CHECK(bench.count("p-union", "sign_flips") > 0);
  bench.choose(settings_of(Precision::fast, 1.0));
  CHECK(bench.get<PUnion>().is_exact());
  CHECK(bench.count("p-union", "sign_flips") == 0);
}
