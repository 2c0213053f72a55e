// SPDX-License-Identifier: GPL-3.0-or-later
// Repair, decimation and sampling say of samples what every reader of the graph says of them.
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/resampling/decimate.h"
#include "core/resampling/repair.h"
#include "core/resampling/resampling.h"
#include "core/structures/density/feature_size.h"
#include "core/workbench/workbench.h"
#include "tests/curves/curve_parts.h"

using namespace mes;
using mes::test::ellipse_around;

namespace {

/// The verdict of a graph on these samples, with these layers on screen as well.
std::string said_of(const SampleData& data, std::initializer_list<std::string_view> layers = {}) {
  Workbench bench(builtins());
  JobControl job;
  REQUIRE(bench.load(data));
  bench.need<FeatureSize>();
  REQUIRE(bench.show(layers));
  bench.set_want_findings(true);
  REQUIRE(bench.run(job));
  return sampling_verdict(bench.nodes()).text();
}

SampleData sampled_polygon(const std::vector<Vec2>& corners, int per_side) {
  SampleData out;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (int k = 0; k < per_side; ++k) {
      const double u = static_cast<double>(k) / per_side;
      out.positions.push_back((1.0 - u) * corners[i] + u * corners[(i + 1) % corners.size()]);
    }
  return out;
}

/// A smooth curve, one with corners, and two curves.
std::vector<std::shared_ptr<const CurveSet>> judged_curves() {
  std::vector<std::shared_ptr<const CurveSet>> out;
  for (const CurveSet& curves :
       {CurveSet{.curves = {ellipse_around({0, 0}, 2, 1)}},
        CurveSet{.curves = {mes::test::polygon({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}})}},
        CurveSet{.curves = {ellipse_around({0, 0}, 3, 3), ellipse_around({0, 0}, 1, 1)}}})
    out.push_back(std::make_shared<const CurveSet>(curves));
  return out;
}

std::vector<std::pair<std::string, SampleData>> judged_inputs() {
  std::vector<std::pair<std::string, SampleData>> out;
  SampleData circle;
  for (int i = 0; i < 40; ++i)
    circle.positions.push_back({std::cos(0.05 * std::numbers::pi * i), std::sin(0.05 * std::numbers::pi * i)});
  out.emplace_back("circle", circle);
  out.emplace_back("square", sampled_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 6));
  out.emplace_back("letter", sampled_polygon({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 5));
  Rng rng(3);
  SampleData random;
  for (int i = 0; i < 300; ++i) random.positions.push_back({rng.uniform(), rng.uniform()});
  out.emplace_back("random points", random);
  SampleData stroke;
  for (int i = 0; i < 30; ++i) stroke.positions.push_back({0.1 * i, std::sin(0.1 * i)});
  out.emplace_back("stroke", stroke);
  JobControl job;
  for (const auto& curves : judged_curves()) {
    const auto taken = take_samples(curves, {.rule = SamplingRule::count, .count = 30}, job);
    REQUIRE(taken);
    out.emplace_back("samples of curves", taken->data);
    SampleData moved = taken->data;
    moved.positions[3] = moved.positions[3] + Vec2{0.01, 0.02};
    out.emplace_back("samples of curves, one of them moved", moved);
  }
  return out;
}

}  // namespace

TEST_CASE("a report on new samples ends with the verdict that everyone gives of them") {
  JobControl job;
  for (const auto& [name, data] : judged_inputs())
    for (const double epsilon : {0.15, 0.25, 0.5}) {
      INFO(name << ", epsilon " << epsilon);
      const auto repaired = repair(builtins(), data, epsilon, job);
      REQUIRE(repaired);
      CHECK(repaired->before.text() == said_of(data));
      const std::string said = said_of(repaired->data);
      CHECK(repaired->after.text() == said);
      CHECK_THAT(repaired->words().front(), Catch::EndsWith(" " + said));
      // An epsilon above the one that was asked for is never left without its place.
      if (repaired->after.epsilon && repaired->after.epsilon->value > epsilon) CHECK_FALSE(repaired->left.empty());

      const auto decimated = decimate(builtins(), data, epsilon, job);
      REQUIRE(decimated);
      SampleData rest = decimated->data;
      if (data.source) {
        CurveSource source = *data.source;
        source.first = 0;
        source.count = static_cast<std::uint32_t>(rest.positions.size());
        rest.source = std::make_shared<const CurveSource>(std::move(source));
      }
      CHECK(decimated->before.text() == said_of(data));
      CHECK_THAT(decimated->words(), Catch::EndsWith(" " + said_of(rest)));
    }
}

TEST_CASE("samples by feature size are remarked on in the same words") {
  JobControl job;
  for (const auto& curves : judged_curves()) {
    const SamplingRequest request{.rule = SamplingRule::feature_size, .count = 200, .epsilon = 0.25};
    const auto taken = take_samples(curves, request, job);
    REQUIRE(taken);
    CHECK_THAT(remark_of(*taken, request), Catch::StartsWith(said_of(taken->data)));
  }
}

TEST_CASE("exempt corners and ends are part of every epsilon") {
  CHECK_THAT(said_of(sampled_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 6)), Catch::Contains("(4 corners exempt); "));
  SampleData stroke;
  for (int i = 0; i < 30; ++i) stroke.positions.push_back({0.1 * i, std::sin(0.1 * i)});
  CHECK_THAT(said_of(stroke), Catch::Contains("(2 ends exempt); "));
}

// The theorem is about the inner balls; the polar balls of a shape with corners cross elsewhere than in samples.
TEST_CASE("showing the polar balls does not change the verdict") {
  bool has_foreign = false;
  for (const auto& [name, data] : judged_inputs()) {
    INFO(name);
    JobControl job;
    const auto repaired = repair(builtins(), data, 0.25, job);
    REQUIRE(repaired);
    const std::string said = said_of(repaired->data);
    CHECK(said_of(repaired->data, {"p-union-boundary", "p-v-points"}) == said);
    CHECK(said_of(repaired->data, {"a-union-boundary", "a-v-points"}) == said);
    Workbench bench(builtins());
    REQUIRE(bench.load(repaired->data));
    REQUIRE(bench.show({"p-union-boundary"}));
    bench.set_want_statistics(true);
    REQUIRE(bench.run(job));
    has_foreign = has_foreign || std::get<std::int64_t>(*bench.statistic("p-union", "foreign_v_points")) != 0;
  }
  CHECK(has_foreign);
}
