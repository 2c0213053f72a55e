// SPDX-License-Identifier: GPL-3.0-or-later
// However many balls an axis would take at the angle that is asked for, they are bounded; what is left out cannot be
// seen, and it is said.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/graph/size_refusal.h"
#include "core/structures/balls/axis_ball_union.h"
#include "core/structures/balls/internal/sampling/ball_halving.h"
#include "core/structures/balls/scale_axis.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// How far the crossing of two circles lies below the line that touches both on the same side.
double dent_between(const Disk& a, const Disk& b) {
  const double d = distance(a.center, b.center);
  const double x = (d * d + a.radius * a.radius - b.radius * b.radius) / (2.0 * d);
  const double y = std::sqrt(a.radius * a.radius - x * x);
  const double slope = (a.radius - b.radius) / d;
  return a.radius - (slope * x + std::sqrt(1.0 - slope * slope) * y);
}
/// Between the radii at the crossing.
double angle_between(const Disk& a, const Disk& b) {
  const double d = distance(a.center, b.center);
  const double cosine = (a.radius * a.radius + b.radius * b.radius - d * d) / (2.0 * a.radius * b.radius);
  return std::acos(std::min(1.0, cosine)) * 180.0 / std::numbers::pi;
}

std::vector<Vec2> noise(std::size_t count, double size, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back({size * rng.uniform(), size * rng.uniform()});
  return out;
}

ComputationSettings dense(double factor, double angle = 179.9) {
  ComputationSettings out;
  out[Parameter::scale_axis_factor] = factor;
  out[Parameter::medial_sampling_angle] = angle;
  return out;
}

double tolerance_of(const ABallSampling& sampling) {
  return std::get<double>(sampling.statistics().back().value);
}

/// A structure outside of the graph, with settings of its own.
struct OwnSettings {
  explicit OwnSettings(const ComputationSettings& chosen) {
    settings.post(chosen);
    settings.rebuild(job);
  }
  JobControl job;
  SettingsSource settings;
};

}  // namespace

TEST_CASE("with a tolerance neighbours cross at 120 degrees or more, and the dents between them are no deeper") {
  Rng rng(5);
  for (int run = 0; run < 200; ++run) {
    // About places of a line, through one point beside it, and shrunk.
    const double shrinking = 0.1 + 0.9 * rng.uniform();
    const Vec2 sample{0.0, std::pow(10.0, -3.0 * rng.uniform())};
    const Vec2 a{-2.0 * rng.uniform(), 0.0};
    const Vec2 b{0.2 + 2.0 * rng.uniform(), 0.0};
    const double tolerance = std::pow(10.0, -1.0 - 5.0 * rng.uniform());
    const double wanted = 100.0 + 79.9 * rng.uniform();
    INFO("run " << run << " tolerance " << tolerance << " angle " << wanted);
    const auto at = [&](double u) {
      const Vec2 center = place_between(a, b, u);
      return Disk{center, shrinking * distance(center, sample)};
    };
    const auto balls = [&](const BallHalving& halving) {
      std::vector<Disk> out{at(0.0), at(1.0)};
      halving.halve(at, at(0.0), at(1.0), [&](const Disk& disk) { out.push_back(disk); });
      std::ranges::sort(out, {}, [](const Disk& disk) { return disk.center.x; });
      return out;
    };
    const BallHalving halving(wanted, 0.0, false, tolerance);
    const std::vector<Disk> sampled = balls(halving);
    CHECK(sampled.size() <= balls(BallHalving(wanted)).size());
    CHECK(sampled.size() >= balls(BallHalving(wanted, 0.0, false, 4.0 * tolerance)).size());
    for (std::size_t i = 1; i < sampled.size(); ++i) {
      const double angle = angle_between(sampled[i - 1], sampled[i]);
      if (angle <= 180.0 - wanted + 1e-9) continue;
      CHECK(angle <= 60.0 + 1e-9);
      CHECK(dent_between(sampled[i - 1], sampled[i]) <= tolerance * (1.0 + 1e-9) + 1e-15);
    }
    const double radius = 2.0 * rng.uniform();
    const double apart = halving.widest(radius);
    CHECK(halving.is_near({{0, 0}, radius}, {{0.999 * apart, 0}, radius}));
    CHECK_FALSE(halving.is_near({{0, 0}, radius}, {{1.001 * apart, 0}, radius}));
  }
}

TEST_CASE("along the one-step axis there is a largest number of balls, and what they take instead is said") {
  for (const Vec2 place : {Vec2{0, 0}, Vec2{1e9, -3e8}}) {
    std::vector<Vec2> samples = noise(3000, 100.0, 3);
    for (Vec2& p : samples) p = p + place;
    TestBench bench;
    bench.show({"medial-axis"});
    bench.replace(samples);
    OwnSettings own(dense(0.1));
    const StructureSet& set = bench.graph().structures();
    AxisSampling sampling(own.settings, set.get<Delaunay>(), set.get<MedialAxis>());
    sampling.rebuild(own.job);
    CHECK(sampling.between().count() <= kMostBallsBetween);
    CHECK(sampling.between().count() > kMostBallsBetween / 8);
    std::vector<Finding> findings;
    sampling.find(findings);
    REQUIRE(findings.size() == 1);
    CHECK(findings.front().level == FindingLevel::note);
    CHECK(findings.front().text.find("farther apart than medial-sampling-angle asks for") != std::string::npos);
    const auto tolerance = std::get<double>(sampling.statistics()[1].value);
    CHECK(tolerance > 0.0);
    CHECK(tolerance <= 150.0 / 2048.0);
    for (const SampledSlot row : slots_below<SampledSlot>(sampling.between().rows()))
      REQUIRE(is_finite(sampling.between().disk(row)));
    // Such balls are not followed, but made anew.
    CHECK(sampling.update(own.job));
    // As many as the angle asks for, where these are few.
    OwnSettings few(dense(0.5, 150.0));
    AxisSampling coarse(few.settings, set.get<Delaunay>(), set.get<MedialAxis>());
    coarse.rebuild(few.job);
    CHECK(std::get<double>(coarse.statistics()[1].value) == 0.0);
    findings.clear();
    coarse.find(findings);
    CHECK(findings.empty());
  }
}

TEST_CASE("one inner ball that is a million times as large as the samples' box makes no dents that are seen") {
  // In a unit square, the outer ones so near to its sides that circles through three of them may be huge.
  std::mt19937_64 bits(12 * 97 + 1500);
  const auto uniform = [&] { return static_cast<double>(bits() >> 11U) * 0x1p-53; };
  std::vector<Vec2> samples;
  for (int i = 0; i < 1500; ++i) {
    const double off = 1e-9 * uniform();
    const double along = uniform();
    const std::array sides{Vec2{-off, along}, Vec2{1 + off, along}, Vec2{along, -off}, Vec2{along, 1 + off}};
    if (i < 150) {
      samples.push_back(sides[static_cast<std::size_t>(i % 4)]);
    } else {
      const double x = uniform();
      samples.push_back({x, uniform()});
    }
  }
  TestBench bench;
  bench.show({"medial-axis", "interior-voronoi-disks"});
  bench.replace(samples);
  const StructureSet& set = bench.graph().structures();
  const auto& delaunay = set.get<Delaunay>();
  double largest = 0.0;
  for (const FaceSlot face : delaunay.face_slots())
    if (delaunay.is_finite_face(face) && set.get<InnerBalls>().is_ball(face))
      largest = std::max(largest, delaunay.circumradius(face));
  REQUIRE(largest > 1e6);
  OwnSettings own(dense(0.5));
  AxisSampling sampling(own.settings, set.get<Delaunay>(), set.get<MedialAxis>());
  sampling.rebuild(own.job);
  const auto tolerance = std::get<double>(sampling.statistics()[1].value);
  CHECK(tolerance > 0.0);
  CHECK(tolerance <= 1.5 / 2048.0);
}

TEST_CASE("sampling an axis is stopped while it makes the balls of few edges") {
  TestBench bench;
  bench.show({"medial-axis"});
  // Long thin triangles: each edge of the axis has some thousand balls.
  std::vector<Vec2> samples;
  for (int i = 0; i < 400; ++i) {
    samples.push_back({1.0 * i, 0.0});
    samples.push_back({1.0 * i + 0.3, 40.0});
  }
  bench.replace(samples);
  const StructureSet& set = bench.graph().structures();
  OwnSettings own(dense(0.1));
  AxisSampling sampling(own.settings, set.get<Delaunay>(), set.get<MedialAxis>());
  sampling.rebuild(own.job);
  const std::size_t balls = sampling.between().count();
  REQUIRE(balls > 100'000);
  std::size_t looks = 0;
  for (std::int64_t look = 1;; ++look, ++looks) {
    JobControl job;
    job.stop_at_look(look);
    try {
      sampling.rebuild(job);
      break;
    } catch (const Cancelled&) {
    }
  }
  CHECK(looks > 10);
  CHECK(sampling.between().count() == balls);
}

TEST_CASE("balls along the axis of a union that are only shown are bounded, too, and never fail") {
  TestBench bench;
  bench.show({"a-ball-medial-axis"});
  bench.replace(noise(600, 100.0, 3));
  const StructureSet& set = bench.graph().structures();
  const UnionTables& t = set.get<AUnion>().tables();
  OwnSettings own(dense(1.0));
  ABallSampling whole(own.settings, set.get<AUnion>());
  whole.rebuild(own.job);
  CHECK(tolerance_of(whole) == 0.0);
  const std::size_t medial = whole.medial().count();
  const std::size_t convex = whole.convex().count();
  REQUIRE(std::min(medial, convex) > 3 * t.node_count());
  std::vector<Finding> findings;
  whole.find(findings);
  CHECK(findings.empty());
  double last = 0.0;
  for (const std::size_t most : {std::min(medial, convex) / 2, std::min(medial, convex) / 4}) {
    INFO("at most " << most);
    ABallSampling fewer(own.settings, set.get<AUnion>(), most);
    fewer.rebuild(own.job);
    CHECK(fewer.medial().count() <= most + t.node_count());
    CHECK(fewer.convex().count() <= most + t.node_count());
    CHECK(std::max(fewer.medial().count(), fewer.convex().count()) > most / 4);
    CHECK(tolerance_of(fewer) > last);
    last = tolerance_of(fewer);
    findings.clear();
    fewer.find(findings);
    REQUIRE(findings.size() == 1);
    CHECK(findings.front().text.starts_with("a-ball-sampling: sampled balls, some of them farther apart"));
    CHECK(findings.front().count == static_cast<std::int64_t>(fewer.medial().count() + fewer.convex().count()));
  }
  // No tolerance suffices: as many as the widest takes.
  ABallSampling widest(own.settings, set.get<AUnion>(), 10);
  widest.rebuild(own.job);
  CHECK(tolerance_of(widest) > last);
  CHECK_FALSE(wider_tolerance(BallHalving(179.9, 0.0, false, tolerance_of(widest)), 150.0).has_value());
  CHECK(widest.medial().count() > t.node_count() / 4);
  CHECK(widest.medial().count() < medial / 4);
}

TEST_CASE("where circles may cross at 120 degrees anyhow no tolerance is tried, and nothing is said") {
  TestBench bench;
  bench.show({"a-ball-medial-axis"});
  bench.replace(noise(600, 100.0, 3));
  const StructureSet& set = bench.graph().structures();
  for (const double angle : {90.0, 120.0}) {
    INFO(angle);
    OwnSettings own(dense(1.0, angle));
    ABallSampling whole(own.settings, set.get<AUnion>());
    whole.rebuild(own.job);
    ABallSampling most(own.settings, set.get<AUnion>(), 10);
    most.rebuild(own.job);
    REQUIRE(whole.medial().count() > 10 + set.get<AUnion>().tables().node_count() / 4);
    CHECK(most.medial().count() == whole.medial().count());
    CHECK(most.convex().count() == whole.convex().count());
    CHECK(tolerance_of(most) == 0.0);
    std::vector<Finding> findings;
    most.find(findings);
    CHECK(findings.empty());
    // One look at the work after the other: what was made is thrown away once, not with each tolerance.
    const auto looks_of = [&](ABallSampling& sampling) {
      for (std::int64_t look = 1;; ++look) {
        JobControl job;
        job.stop_at_look(look);
        try {
          sampling.rebuild(job);
          return look;
        } catch (const Cancelled&) {
        }
      }
    };
    CHECK(looks_of(most) <= 2 * looks_of(whole));
  }
}

TEST_CASE("sampled balls are followed up to the bound, and made anew with a tolerance beyond it") {
  TestBench bench;
  bench.show({"a-ball-medial-axis"});
  bench.replace(ellipse(2.0, 1.0, 120, {0.3, 0.1, 3}).data.positions);
  const StructureSet& set = bench.graph().structures();
  OwnSettings own(dense(1.0));
  ABallSampling whole(own.settings, set.get<AUnion>());
  whole.rebuild(own.job);
  const auto sorted = [](const SampledBalls& balls) {
    std::vector<std::array<double, 3>> out;
    for (const SampledSlot row : slots_below<SampledSlot>(balls.rows()))
      if (balls.is_alive(row))
        out.push_back({balls.disk(row).center.x, balls.disk(row).center.y, balls.disk(row).radius});
    std::ranges::sort(out);
    return out;
  };
  std::size_t followed = 0;
  std::size_t made_anew = 0;
  Rng rng(11);
  // About as many as there are inside links: some edits lead across the bound, and back.
  const std::size_t most = std::max(whole.medial().count(), whole.convex().count()) -
                           static_cast<std::size_t>(bench.count("a-union", "visible"));
  ABallSampling sampling(own.settings, set.get<AUnion>(), most);
  sampling.rebuild(own.job);
  for (int edit = 0; edit < 80; ++edit) {
    if (edit % 8 < 4) {
      const double angle = 2.0 * std::numbers::pi * rng.uniform();
      bench.insert({{2.0 * std::cos(angle), std::sin(angle)}});
    } else {
      const std::vector<SampleId> ids = bench.ids();
      bench.remove({ids.back()});
    }
    if (sampling.update(own.job)) {
      ++followed;
    } else {
      ++made_anew;
      sampling.rebuild(own.job);
    }
    ABallSampling fresh(own.settings, set.get<AUnion>(), most);
    fresh.rebuild(own.job);
    REQUIRE(sorted(sampling.medial()) == sorted(fresh.medial()));
    REQUIRE(sorted(sampling.convex()) == sorted(fresh.convex()));
    REQUIRE(tolerance_of(sampling) == tolerance_of(fresh));
  }
  CHECK(followed > 5);
  CHECK(made_anew > 5);
}

TEST_CASE("balls that no tolerance makes few enough are refused in one line") {
  const auto with = [](double tolerance, double angle = 179.9) { return BallHalving(angle, 0.0, false, tolerance); };
  CHECK(next_tolerance(with(0.0), 1.0) == 0x1p-29);
  CHECK(next_tolerance(with(0.0, 120.1), 1.0) == 0x1p-29);
  CHECK(next_tolerance(with(0x1p-29), 1.0) == 0x1p-27);
  CHECK(next_tolerance(with(0x1p-13), 1.0) == 0x1p-11);
  for (const double angle : {90.0, 119.9, 120.0}) {
    CHECK_FALSE(wider_tolerance(with(0.0, angle), 1.0).has_value());
    CHECK_THROWS_AS(next_tolerance(with(0.0, angle), 1.0), SizeRefusal);
  }
  for (const double diameter : {0.0, 1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    INFO(diameter);
    try {
      next_tolerance(with(diameter == 1.0 ? 0x1p-11 : 0.0), diameter);
      FAIL("not refused");
    } catch (const SizeRefusal& error) {
      const std::string text = error.what();
      CHECK(text.starts_with("it takes more than 500000 balls along the axis"));
      CHECK(text.find('\n') == std::string::npos);
    }
  }
}
