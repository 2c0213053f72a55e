// SPDX-License-Identifier: GPL-3.0-or-later
// The scale axes and scale skeletons of the three families: against formulas, against the axis itself where the factor is
// 1, and against a fresh computation after every edit.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/graph/explain.h"
#include "core/io/format.h"
#include "core/structures/balls/axis_ball_union.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_degenerate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::array<const char*, 3> kLetters{"a", "p", "b"};
constexpr std::array<const char*, 6> kNames{"scale-axis",       "scale-axis-boundary", "scale-axis-grown-disks",
                                            "scale-axis-disks", "scale-axis-circles",  "scale-skeleton"};

std::string id_of(std::string_view letter, std::string_view name) {
  return std::string(letter) + '-' + std::string(name);
}

void show(TestBench& bench, std::string_view letter) {
  std::array<std::string, kNames.size()> ids;
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = id_of(letter, kNames[i]);
  bench.show({ids[0], ids[1], ids[2], ids[3], ids[4], ids[5]});
}

ComputationSettings factor(double s, double step = 3.0) {
  ComputationSettings out;
  out[Parameter::scale_axis_factor] = s;
  out[Parameter::scale_skeleton_step] = step;
  return out;
}

struct DrawnPiece {
  Vec2 a, b;
  double radius;
};
std::vector<DrawnPiece> pieces(const TestBench& bench, const std::string& layer) {
  std::vector<DrawnPiece> out;
  const auto values = bench.instances(layer, PrimitiveKind::segment);
  for (std::size_t at = 0; at < values.size(); at += stride_of(PrimitiveKind::segment))
    out.push_back({{values[at], values[at + 1]}, {values[at + 2], values[at + 3]}, values[at + 4]});
  return out;
}
Box2 box_of(const std::vector<DrawnPiece>& pieces) {
  Box2 out;
  for (const DrawnPiece& piece : pieces) {
    out.add(piece.a);
    out.add(piece.b);
  }
  return out;
}
double length_of(const std::vector<DrawnPiece>& pieces) {
  double out = 0.0;
  for (const DrawnPiece& piece : pieces) out += distance(piece.a, piece.b);
  return out;
}

/// Balls about places of the x axis, from `from` to `to`, with a radius that follows the place.
template <class Radius>
SampleData balls_in_line(double from, double to, int count, Radius radius) {
  SampleData out;
  for (int i = 0; i < count; ++i) {
    const double x = from + (to - from) * i / (count - 1);
    out.balls.push_back({{x, 0.0}, radius(x)});
  }
  return out;
}

SampleData random_scene(Rng& rng, std::size_t samples, std::size_t balls) {
  SampleData out;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(samples);
    const double r = 100.0 * (1.0 + 0.3 * std::cos(3.0 * t)) + 8.0 * (rng.uniform() - 0.5);
    out.positions.push_back({r * std::cos(t), r * std::sin(t)});
  }
  for (std::size_t i = 0; i < balls; ++i)
    out.balls.push_back({{200.0 * rng.uniform() - 100.0, 200.0 * rng.uniform() - 100.0}, 5.0 + 30.0 * rng.uniform()});
  return out;
}

}  // namespace

TEST_CASE("at a factor of 1 scale axis and scale skeleton are the axis of each family, instance for instance") {
  for (const char* letter : kLetters) {
    TestBench bench;
    const auto id = [letter](std::string_view name) { return id_of(letter, name); };
    bench.show({id("scale-axis"), id("scale-skeleton"), id("ball-medial-axis"), id("scale-axis-boundary"),
                id("union-boundary"), id("scale-axis-disks"), id("ball-medial-disks")});
    std::vector<SampleData> inputs;
    for (const DegenerateInput& input : degenerate_inputs()) inputs.push_back({.positions = input.positions});
    for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 4})) inputs.push_back(shape.data);
    Rng rng(4);
    inputs.push_back(random_scene(rng, 60, 20));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      INFO(letter << " input " << i);
      bench.load(inputs[i]);
      const auto same = [&](std::string_view a, std::string_view b) {
        INFO(a);
        CHECK(bench.contents().sorted(find_layer(id(a))) == bench.contents().sorted(find_layer(id(b))));
      };
      same("scale-axis", "ball-medial-axis");
      same("scale-skeleton", "ball-medial-axis");
      same("scale-axis-boundary", "union-boundary");
      same("scale-axis-disks", "ball-medial-disks");
      for (const char* key : {"components", "cycles", "nodes", "leaves", "visible"})
        CHECK(bench.count(id("scale-union"), key) == bench.count(id("union"), key));
      CHECK(bench.measure(id("scale-union"), "area") == bench.measure(id("union"), "area"));
    }
  }
}

TEST_CASE("the scale axis of own balls that make a stadium is its core, with its radius, at every factor") {
  TestBench bench;
  show(bench, "b");
  bench.load(balls_in_line(-3.0, 3.0, 25, [](double) { return 1.0; }));
  for (const double s : {0.2, 0.5, 0.9, 1.05, 1.3, 2.0, 3.0}) {
    INFO("s " << s);
    bench.choose(factor(s));
    for (const char* layer : {"b-scale-axis", "b-scale-skeleton"}) {
      INFO(layer);
      const std::vector<DrawnPiece> axis = pieces(bench, layer);
      CHECK(box_of(axis).low.x == Approx(-3.0).margin(1e-9));
      CHECK(box_of(axis).high.x == Approx(3.0).margin(1e-9));
      CHECK(std::max(-box_of(axis).low.y, box_of(axis).high.y) < 1e-9);
      CHECK(length_of(axis) == Approx(6.0));
      for (const DrawnPiece& piece : axis) CHECK(piece.radius == Approx(1.0).margin(0.01));
    }
    CHECK(bench.measure("b-scale-union", "area") == Approx(std::numbers::pi * s * s + 12.0 * s).epsilon(0.01));
    CHECK(bench.count("b-scale-union", "components") == 1);
  }
}

TEST_CASE("balls whose radius grows along a line are swallowed by the largest from the inverse of the slope on") {
  TestBench bench;
  show(bench, "b");
  bench.load(balls_in_line(0.0, 4.0, 41, [](double x) { return 0.5 + 0.6 * x; }));
  for (const double s : {0.3, 0.7, 1.2, 1.6, 1.7, 2.5}) {
    INFO("s " << s);
    bench.choose(factor(s, 1.0));
    for (const char* layer : {"b-scale-axis", "b-scale-skeleton"}) {
      INFO(layer);
      if (s > 1.0 / 0.6) {
        CHECK(pieces(bench, layer).empty());
        const auto point = bench.instances(layer, PrimitiveKind::point);
        REQUIRE(point.size() == stride_of(PrimitiveKind::point));
        CHECK(point[0] == Approx(4.0));
        CHECK(point[2] == Approx(2.9));
      } else {
        CHECK(box_of(pieces(bench, layer)).low.x == Approx(0.0).margin(1e-9));
        CHECK(box_of(pieces(bench, layer)).high.x == Approx(4.0).margin(1e-9));
      }
    }
  }
}

TEST_CASE("scale axis and skeleton of each family are continuous at a factor of 1") {
  for (const char* letter : {"a", "p"}) {
    TestBench bench;
    show(bench, letter);
    bench.replace(ellipse(2.0, 1.0, 200, {0.3, 0.1, 3}).data.positions);
    const double whole = length_of(pieces(bench, id_of(letter, "scale-axis")));
    for (const double s : {1.0 - 1e-6, 1.0 + 1e-6}) {
      bench.choose(factor(s));
      for (const char* name : {"scale-axis", "scale-skeleton"})
        CHECK(length_of(pieces(bench, id_of(letter, name))) == Approx(whole).epsilon(0.01));
    }
  }
}

TEST_CASE("the scale skeleton of an ellipse is shorter by the formula of the scale axis, and has its radii") {
  const double a = 2.0;
  const double c2 = a * a - 1.0;
  TestBench bench;
  show(bench, "a");
  bench.replace(ellipse(a, 1.0, 300, {0.3, 0.1, 3}).data.positions);
  for (const double s : {1.1, 1.3, 2.0}) {
    INFO("s " << s);
    bench.choose(factor(s, 10.0));
    const double end = c2 / std::sqrt(s * s + c2);
    CHECK(bench.count("a-skeleton-union", "steps_before") == std::lround((s - 1.0) / 0.1) - 1);
    CHECK(bench.count("a-skeleton-union", "components") == 1);
    CHECK(bench.count("a-skeleton-union", "leaves") == 2);
    const std::vector<DrawnPiece> axis = pieces(bench, "a-scale-skeleton");
    CHECK(box_of(axis).low.x == Approx(-end).margin(0.03));
    CHECK(box_of(axis).high.x == Approx(end).margin(0.03));
    for (const DrawnPiece& piece : axis) {
      const double x = std::min(end, std::abs(0.5 * (piece.a.x + piece.b.x)));
      CHECK(piece.radius == Approx(std::sqrt(1.0 - x * x / c2)).margin(0.02));
    }
  }
}

TEST_CASE(
    "where edges of the curve are longer than the spacing of the angle, hairs go as they do from the scale axis") {
  TestBench bench;
  bench.show({"scale-axis", "a-scale-axis", "p-scale-axis", "a-scale-skeleton"});
  auto glyph = read_sample_file("tests/data/glyph_dejavusans_B_1000.poff");
  REQUIRE(glyph.has_value());
  const std::array inputs{ellipse(2.0, 1.0, 60, {0.3, 0.1, 3}).data, rounded_rectangle(3.0, 1.0, 0.6, 0.25).data,
                          glyph->data};
  for (const double angle : {175.0, 178.0}) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      INFO("input " << i << " angle " << angle);
      bench.choose({});
      bench.load(inputs[i]);
      REQUIRE(bench.count("axis-certificate", "certified") == 1);
      for (const double s : {0.5, 1.3}) {
        INFO("s " << s);
        ComputationSettings settings = factor(s, 3.0);
        settings[Parameter::medial_sampling_angle] = angle;
        bench.choose(settings);
        CHECK(bench.count("a-scale-union", "leaves") == bench.count("scale-union", "leaves"));
        CHECK(bench.measure("a-scale-union", "length") ==
              Approx(bench.measure("scale-union", "length")).epsilon(1e-12));
        CHECK(bench.count("p-scale-union", "leaves") == bench.count("scale-union", "leaves"));
        CHECK(bench.count("a-skeleton-union", "leaves") <= bench.count("scale-union", "leaves"));
      }
    }
  }
}

TEST_CASE("balls along a corridor far thinner than the data is wide do not part when they shrink") {
  SampleData data = stadium(0.01, 0.0005, 0.25).data;
  for (const Vec2& p : ellipse(0.6, 0.4, 60).data.positions) data.positions.push_back({p.x + 3.0, p.y});
  TestBench bench;
  bench.show({"scale-axis", "a-scale-axis", "p-scale-axis", "a-scale-skeleton"});
  bench.replace(data.positions);
  for (const double s : {0.1, 0.2, 0.5}) {
    INFO("s " << s);
    bench.choose(factor(s));
    for (const char* balls : {"scale-union", "a-scale-union", "p-scale-union", "a-skeleton-union"})
      CHECK(bench.count(balls, "components") == 2);
  }
}

TEST_CASE("the scale skeleton in one step is the scale axis, and does not depend on the factors before") {
  Rng rng(9);
  const SampleData scene = random_scene(rng, 60, 15);
  for (const char* letter : kLetters) {
    TestBench bench;
    show(bench, letter);
    bench.load(scene);
    for (const double s : {0.5, 1.2, 1.5}) {
      bench.choose(factor(s, 100.0));
      CHECK(bench.contents().sorted(find_layer(id_of(letter, "scale-skeleton"))) ==
            bench.contents().sorted(find_layer(id_of(letter, "scale-axis"))));
    }
    for (const auto& [s, step] : {std::pair{1.3, 5.0}, {1.31, 5.0}, {1.15, 5.0}, {1.45, 5.0}, {1.45, 9.0}}) {
      INFO(letter << " s " << s << " step " << step);
      bench.choose(factor(s, step));
      TestBench fresh;
      show(fresh, letter);
      fresh.choose(factor(s, step));
      fresh.load(scene);
      CHECK(bench.contents().sorted(find_layer(id_of(letter, "scale-skeleton"))) ==
            fresh.contents().sorted(find_layer(id_of(letter, "scale-skeleton"))));
    }
  }
}

TEST_CASE("scale axes of the families follow random edits and changes of the factor as a fresh computation does") {
  for (const char* letter : kLetters) {
    Rng rng(17);
    TestBench bench;
    show(bench, letter);
    bench.load(random_scene(rng, 40, 12));
    ComputationSettings settings;
    for (int step = 0; step < 24; ++step) {
      INFO(letter << " step " << step);
      if (step % 4 == 0) {
        settings = factor(std::array{1.0, 0.6, 1.1, 1.4}[rng.below(4)], std::array{4.0, 20.0}[rng.below(2)]);
        settings[Parameter::medial_sampling_angle] = std::array{160.0, 175.0}[rng.below(2)];
        bench.choose(settings);
      }
      const auto place = [&] { return Vec2{260.0 * rng.uniform() - 130.0, 260.0 * rng.uniform() - 130.0}; };
      switch (rng.below(4)) {
        case 0: bench.insert({place()}); break;
        case 1: bench.remove({bench.ids()[rng.below(bench.ids().size())]}); break;
        case 2: bench.move(bench.ids()[rng.below(bench.ids().size())], place()); break;
        default: bench.insert_balls({{place(), 5.0 + 20.0 * rng.uniform()}}); break;
      }
      TestBench fresh;
      show(fresh, letter);
      SampleData reversed{.positions = bench.positions(), .balls = bench.balls()};
      std::ranges::reverse(reversed.positions);
      std::ranges::reverse(reversed.balls);
      fresh.load(reversed);
      fresh.choose(settings);
      for (const char* name : kNames) {
        INFO(name);
        const LayerIndex layer = find_layer(id_of(letter, name));
        REQUIRE(bench.contents().sorted(layer) == fresh.contents().sorted(layer));
      }
    }
  }
}

TEST_CASE("at a factor of 1 a certified union's scale axis follows edits by parts, and other settings send nothing") {
  TestBench bench;
  bench.show({"a-scale-axis", "a-scale-axis-boundary", "a-scale-axis-grown-disks", "a-scale-axis-disks",
              "a-scale-skeleton", "lambda-medial-axis"});
  std::vector<Vec2> samples = ellipse(2.0, 1.0, 400, {0.3, 0.1, 3}).data.positions;
  bench.replace(samples);
  REQUIRE(bench.count("axis-certificate", "certified") == 1);
  const auto report = [&](std::string_view structure) -> const NodeReport& {
    return *std::ranges::find(bench.patch().nodes, structure, &NodeReport::structure);
  };
  const std::array structures{"a-scale-union", "a-skeleton-union", "a-scale-sampling"};
  ComputationSettings settings;
  for (const double limit : {0.1, 0.4}) {
    settings[Parameter::lambda_limit] = limit;
    bench.choose(settings);
    for (const char* id : structures) {
      INFO(id);
      CHECK_FALSE(report(id).rebuilt);
    }
    for (std::size_t i = 0; i < bench.patch().layer_count; ++i)
      CHECK(layer_descriptors()[bench.patch().layers[i].layer.layer].id == "lambda-medial-axis");
  }
  Rng rng(3);
  for (int step = 0; step < 60; ++step) {
    INFO("step " << step);
    const SampleId id = bench.ids()[rng.below(400)];
    const Vec2 at = bench.document().position(bench.document().slot_of(id));
    const double size = step % 6 == 5 ? 0.3 : 1e-4;
    switch (step % 3) {
      case 0: bench.move(id, {at.x + size * rng.uniform(-1.0, 1.0), at.y + size * rng.uniform(-1.0, 1.0)}); break;
      case 1: bench.insert({{(1.0 + size * rng.uniform()) * at.x, at.y + 1e-3}}); break;
      default: bench.undo(); break;
    }
    if (size < 0.1 && step % 6 > 1 && report("a-union").rebuilt == false)
      CHECK_FALSE(report("a-scale-union").rebuilt);
    TestBench fresh;
    fresh.show({"a-scale-axis", "a-scale-axis-boundary", "a-scale-axis-grown-disks", "a-scale-axis-disks",
                "a-scale-skeleton"});
    std::vector<Vec2> reversed = bench.positions();
    std::ranges::reverse(reversed);
    fresh.replace(reversed);
    for (const char* name :
         {"scale-axis", "scale-axis-boundary", "scale-axis-grown-disks", "scale-axis-disks", "scale-skeleton"}) {
      INFO(name);
      const LayerIndex layer = find_layer(id_of("a", name));
      REQUIRE(bench.contents().sorted(layer) == fresh.contents().sorted(layer));
    }
    for (const char* key : {"area", "perimeter", "length"})
      CHECK(bench.measure("a-scale-union", key) == bench.measure("a-union", key));
  }
}

TEST_CASE("hairs of a scaled family go by the spacing of its samples, as they do unscaled") {
  TestBench bench;
  bench.show({"scale-axis", "a-scale-axis", "p-scale-axis", "a-scale-skeleton"});
  auto glyph = read_sample_file("tests/data/glyph_dejavusans_B_1000.poff");
  REQUIRE(glyph.has_value());
  const std::array inputs{ellipse(2.0, 1.0, 60, {0.3, 0.1, 3}).data, rounded_rectangle(3.0, 1.0, 0.6, 0.25).data,
                          glyph->data};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    bench.load(inputs[i]);
    for (const double scale : {0.9, 1.0, 1.05}) {
      for (const double s : {0.7, 1.3}) {
        INFO("input " << i << " balls times " << scale << " s " << s);
        ComputationSettings settings = factor(s, 100.0);
        settings[Parameter::a_scale] = scale;
        settings[Parameter::p_scale] = scale;
        bench.choose(settings);
        const std::int64_t leaves = bench.count("scale-union", "leaves");
        CAPTURE(leaves, bench.count("a-scale-union", "leaves"), bench.count("p-scale-union", "leaves"));
        CHECK(bench.count("a-scale-union", "leaves") <= leaves + 4);
        CHECK(bench.count("p-scale-union", "leaves") <= leaves + 4);
        CHECK(bench.measure("a-scale-union", "length") ==
              Approx(bench.measure("scale-union", "length")).epsilon(scale == 1.0 ? 1e-9 : 0.1));
      }
    }
  }
}

TEST_CASE("where parts of the axis are too short to be halved, hairs go by how far apart their balls are") {
  // Noise of a size of a few hundred short parts, beside something large.
  SampleData data;
  Rng rng(4);
  for (int i = 0; i < 150; ++i) data.positions.push_back({0.02 * rng.uniform(), 0.02 * rng.uniform()});
  for (const Vec2& p : ellipse(1.0, 0.9, 60).data.positions) data.positions.push_back({p.x + 5.0, p.y});
  TestBench bench;
  bench.show({"a-scale-axis"});
  bench.replace(data.positions);
  std::vector<std::int64_t> leaves, balls;
  for (const double angle : {179.0, 179.9}) {
    ComputationSettings settings = factor(0.5);
    settings[Parameter::medial_sampling_angle] = angle;
    bench.choose(settings);
    leaves.push_back(bench.count("a-scale-union", "leaves"));
    balls.push_back(bench.count("a-scale-union", "balls"));
  }
  CHECK(balls[1] < 5 * balls[0]);  // ten times as many by the angle
  CHECK(leaves[1] <= leaves[0]);
  ComputationSettings coarse = factor(0.5);
  bench.choose(coarse);
  CHECK(leaves[1] <= bench.count("a-scale-union", "leaves"));
}

TEST_CASE("balls of the scale skeleton say which step they are of") {
  TestBench bench;
  bench.show({"a-scale-axis-grown-disks", "a-scale-skeleton"});
  bench.replace(ellipse(2.0, 1.0, 60, {0.3, 0.1, 3}).data.positions);
  bench.choose(factor(1.25, 10.0));
  REQUIRE(bench.count("a-skeleton-union", "steps_before") == 2);
  const auto line_of = [&](const Structure& structure, FamilySlot ball) {
    JobControl job;
    Explanation out(
        bench.graph().structures(), [](const Structure&) { return true; }, job);
    structure.explain(ElementKind::ball, ball.index(), out);
    const std::vector<ProvenanceLine> lines = out.take();
    return lines.empty() ? std::string() : lines.front().text;
  };
  CHECK(line_of(bench.get<ASkeletonUnion>(), FamilySlot(0))
            .starts_with("Ball about a point of the scale axis after step 2, at a factor of 1.2, radius "));
  CHECK(
      line_of(bench.get<AScaleUnion>(), FamilySlot(0)).starts_with("Ball about a point of the axis of the union, "));
}
