// SPDX-License-Identifier: GPL-3.0-or-later
// The epsilon that is said of samples is a bound where formulas say what the axis of their curves is.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/builtins/builtins.h"
#include "core/curves/feature_field.h"
#include "core/curves/nearest_place.h"
#include "core/document/commands.h"
#include "core/engine/graph.h"
#include "core/resampling/decimate.h"
#include "core/resampling/repair.h"
#include "core/resampling/resampling.h"
#include "core/structures/density/curve_sampling.h"
#include "tests/curves/curve_parts.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/parcels.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::ellipse_around;
using mes::test::kPi;
using mes::test::polygon;

namespace {

struct Segment {
  Vec2 a{}, b{};
};

double distance_to_segment(const Segment& segment, Vec2 p) {
  const Vec2 along = segment.b - segment.a;
  const double size = dot(along, along);
  const double t = size > 0.0 ? std::clamp(dot(p - segment.a, along) / size, 0.0, 1.0) : 0.0;
  return distance(p, segment.a + t * along);
}

/// Curves whose distance to the axis is known.
struct KnownShape {
  std::string name;
  CurveSet curves;
  std::function<double(Vec2)> size;
};

KnownShape known_ellipse(double a, double b) {
  const double reach = (a * a - b * b) / a;
  return {"ellipse " + std::to_string(a), {.curves = {ellipse_around({0, 0}, a, b)}}, [reach](Vec2 p) {
            return distance_to_segment({{-reach, 0}, {reach, 0}}, p);
          }};
}

/// A rectangle with half sides w and h, w at least h, whose corners are arcs of radius r.
PlaneCurve rounded_rectangle(double w, double h, double r) {
  const auto corner = [&](PlaneCurve& curve, Vec2 center, double start) {
    const auto at = [&](double angle) { return center + r * Vec2{std::cos(angle), std::sin(angle)}; };
    if (distance(curve.end(), at(start)) > 1e-12) curve.line_to(at(start));
    curve.arc_to({center, {r, 0}, {0, r}, start, kPi / 2}, at(start + kPi / 2));
  };
  PlaneCurve curve({w - r, h});
  corner(curve, {-w + r, h - r}, kPi / 2);
  corner(curve, {-w + r, -h + r}, kPi);
  corner(curve, {w - r, -h + r}, 1.5 * kPi);
  corner(curve, {w - r, h - r}, 0.0);
  curve.close();
  return curve;
}

KnownShape known_rectangle(double w, double h, double r) {
  return {"rounded rectangle " + std::to_string(r), {.curves = {rounded_rectangle(w, h, r)}}, [=](Vec2 p) {
            const Vec2 q{std::abs(p.x), std::abs(p.y)};
            return std::min(distance_to_segment({{0, 0}, {w - h, 0}}, q),
                            distance_to_segment({{w - h, 0}, {w - r, h - r}}, q));
          }};
}

std::vector<KnownShape> known_shapes() {
  std::vector<KnownShape> out;
  for (const double a : {1.2, 2.0, 3.0, 8.0}) out.push_back(known_ellipse(a, 1.0));
  out.push_back({"circle", {.curves = {ellipse_around({1, 2}, 2, 2)}}, [](Vec2) { return 2.0; }});
  out.push_back({"stadium", {.curves = {rounded_rectangle(3, 1, 1)}}, [](Vec2) { return 1.0; }});
  out.push_back(known_rectangle(2, 1, 0.5));
  out.push_back(known_rectangle(3, 2, 0.1));
  out.push_back({"annulus", {.curves = {ellipse_around({0, 0}, 3, 3), ellipse_around({0, 0}, 1, 1)}}, [](Vec2) {
                   return 1.0;
                 }});
  out.push_back({"thin annulus",
                 {.curves = {ellipse_around({0, 0}, 3, 3), ellipse_around({0, 0}, 2.9, 2.9)}},
                 [](Vec2) { return 0.05; }});
  return out;
}

/// By definition: the largest distance of a place of the curves to its nearest sample over its feature size, of many places.
double true_epsilon(const KnownShape& shape, const std::vector<Vec2>& samples) {
  JobControl job;
  const auto places = sample(shape.curves, {.rule = SamplingRule::count, .count = 6000});
  REQUIRE(places);
  double out = 0.0;
  for (const Vec2 p : places->positions) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2 q : samples) nearest = std::min(nearest, distance(p, q));
    out = std::max(out, nearest / shape.size(p));
  }
  return out;
}

/// As samples are judged without their curves: half the distance of neighbours over the smaller size of both.
double epsilon_of_neighbours(const KnownShape& shape, const SampleData& data) {
  double out = 0.0;
  for (const SampleData::Contour& contour : data.contours)
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const Vec2 a = data.positions[contour.points[i]];
      const Vec2 b = data.positions[contour.points[(i + 1) % contour.points.size()]];
      out = std::max(out, 0.5 * distance(a, b) / std::min(shape.size(a), shape.size(b)));
    }
  return out;
}

std::shared_ptr<const CurveSet> shared(CurveSet curves) {
  return std::make_shared<const CurveSet>(std::move(curves));
}

}  // namespace

TEST_CASE("the epsilon that is said of samples of known shapes is a bound, and no more than was asked for") {
  for (const KnownShape& shape : known_shapes())
    for (const double epsilon : {0.05, 0.2, 0.25, 0.5, 0.8, 1.0}) {
      INFO(shape.name << ", epsilon " << epsilon);
      JobControl job;
      const auto taken = take_samples(shared(shape.curves),
                                      {.rule = SamplingRule::feature_size, .count = 400, .epsilon = epsilon}, job);
      REQUIRE(taken);
      const double said = taken->standing.epsilon;
      const double known = true_epsilon(shape, taken->data.positions);
      const double neighbours = epsilon_of_neighbours(shape, taken->data);
      INFO("said " << said << ", true " << known << ", of neighbours " << neighbours << ", samples "
                   << taken->data.positions.size());
      CHECK(said <= epsilon);
      CHECK(known <= said);
      CHECK(neighbours <= said);
      CHECK(taken->standing.off_curve == 0);
      CHECK(taken->standing.exempt == 0);
    }
}

namespace {

/// Samples of curves by a rule, as a file that is opened has them.
SampleData opened(const CurveSet& curves, const SamplingRequest& request) {
  JobControl job;
  auto taken = take_samples(shared(curves), request, job);
  REQUIRE(taken);
  return std::move(taken->data);
}

const CurveSet kLetter{.curves = {polygon({{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 100}, {0, 100}})}};

/// A document and what the window says of it.
class Window {
 public:
  explicit Window(const SampleData& data) {
    graph_.set_want_findings(true);
    graph_.set_want_statistics(true);
    graph_.set_demand(std::vector{find_layer("medial-axis"), find_layer("sampling-epsilon")});
    apply(replace_all(document_, data));
  }
  void apply(Expected<DocumentDelta> delta) {
    REQUIRE(delta);
    const auto made = std::make_shared<const DocumentDelta>(*std::move(delta));
    document_.apply(*made);
    graph_.post(made);
    JobControl job;
    REQUIRE(graph_.run(patch_, job));
  }
  const Document& document() const { return document_; }
  TheoremLight light() const { return light_of(patch_.nodes); }
  const CurveSampling& curves() const { return graph_.structures().get<CurveSampling>(); }
  const NodeReport& node(std::string_view structure) const {
    for (const NodeReport& one : patch_.nodes)
      if (one.structure == structure) return one;
    FAIL("no such structure");
    return patch_.nodes.front();
  }
  const std::vector<Finding>& findings() const { return node("curve-sampling").findings; }

 private:
  Document document_;
  Graph graph_{builtins()};
  FramePatch patch_;
};

/// How far a point is from the curves.
double off(const CurveSet& curves, Vec2 p) {
  const auto place = nearest_place(curves, p, 1e6);
  REQUIRE(place);
  return distance(*place, p);
}

}  // namespace

TEST_CASE("samples at the corners of a known outline alone are in doubt, with the place") {
  const Window bench(opened(kLetter, {.rule = SamplingRule::vertices}));
  REQUIRE(bench.document().sample_count() == 6);
  CHECK(bench.curves().standing().epsilon > 1.0);
  const std::vector<Finding> findings = bench.findings();
  REQUIRE(findings.size() >= 2);
  CHECK(findings[0].level == FindingLevel::note);
  CHECK_THAT(findings[0].epsilon->text(), Catch::StartsWith("epsilon ") && Catch::EndsWith("(6 corners exempt)"));
  CHECK(findings[1].level == FindingLevel::doubt);
  CHECK_THAT(findings[1].text, Catch::Contains("too few samples to stand for them"));
  REQUIRE_FALSE(findings[1].places.empty());
  for (const Vec2 place : findings[1].places) CHECK(off(kLetter, place) < 1e-9);
  CHECK(bench.light() == TheoremLight::yellow);
  // The same samples of no curves are what they are.
  SampleData alone = opened(kLetter, {.rule = SamplingRule::vertices});
  alone.source = nullptr;
  const Window plain(alone);
  CHECK_FALSE(plain.curves().has_standing());
  CHECK(plain.findings().empty());
  // Enough of them are no doubt.
  const Window dense(opened(kLetter, {.rule = SamplingRule::count, .count = 400}));
  CHECK(dense.curves().standing().epsilon < 0.25);
  REQUIRE(dense.findings().size() == 1);
  CHECK(dense.light() == TheoremLight::green);
}

TEST_CASE("places where borders of regions meet are exempt, and samples near them stand for the borders") {
  // Of more parcels some borders end nearly opposite to each other, and ask for more samples there than by default.
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    const CurveSet outlines{.curves = test::parcels(2 + seed, 0.1 * static_cast<double>(seed), 12, seed).outlines};
    const Window bench(opened(outlines, default_sampling(outlines)));
    CHECK(bench.curves().standing().epsilon < 1.0);
    CHECK(bench.curves().standing().sparse.empty());
    // Four corners, and at least two ends of each border.
    CHECK(bench.curves().standing().exempt >= 4 + 2 * (outlines.curves.size() - 1));
  }
}

TEST_CASE("what is said after sampling and what the light says is one number and one verdict") {
  std::vector<CurveSet> all{kLetter, {.curves = {polygon({{0, 0}, {10, -1}, {10, 1}})}}};
  for (const KnownShape& shape : known_shapes()) all.push_back(shape.curves);
  for (const CurveSet& curves : all)
    for (const double epsilon : {0.25, 0.8}) {
      JobControl job;
      const SamplingRequest request{.rule = SamplingRule::feature_size, .count = 400, .epsilon = epsilon};
      const auto taken = take_samples(shared(curves), request, job);
      REQUIRE(taken);
      const Window bench(taken->data);
      CHECK(bench.curves().standing().epsilon == taken->standing.epsilon);
      CHECK(bench.light() == taken->verdict.light);
      const std::vector<Finding> findings = bench.findings();
      REQUIRE_FALSE(findings.empty());
      CHECK_THAT(remark_of(*taken, request), Catch::StartsWith(findings[0].epsilon->text() + "; "));
      // What shows the epsilon has no other one.
      const NodeReport& sizes = bench.node("feature-size");
      CHECK(sizes.findings.empty());
      const auto epsilon_stat = std::ranges::find(sizes.stats, "epsilon", &Stat::key);
      REQUIRE(epsilon_stat != sizes.stats.end());
      CHECK(std::get<double>(epsilon_stat->value) == taken->standing.epsilon);
    }
}

TEST_CASE("samples that are moved off their curves, removed and put back are followed") {
  const KnownShape shape = known_ellipse(2.0, 1.0);
  Window window(opened(shape.curves, {.rule = SamplingRule::count, .count = 60}));
  const double before = window.curves().standing().epsilon;
  const SampleSlot slot = window.document().slots_in_input_order()[7];
  const SampleId one = window.document().id(slot);
  const Vec2 place = window.document().position(slot);
  const auto move = [&](Vec2 to) { window.apply(move_samples(window.document(), std::vector{std::pair{one, to}})); };
  move({0.0, 0.3});
  CHECK_FALSE(window.curves().has_standing());
  REQUIRE(window.findings().size() == 1);
  CHECK(window.findings()[0].level == FindingLevel::note);
  CHECK(window.findings()[0].count == 1);
  CHECK(window.findings()[0].places == std::vector<Vec2>{{0.0, 0.3}});
  move(place);
  REQUIRE(window.curves().has_standing());
  CHECK(window.curves().standing().epsilon == before);
  window.apply(remove_samples(window.document(), std::vector{one}));
  CHECK(window.curves().standing().epsilon > before);
  window.apply(insert_samples(window.document(), std::vector{place}));
  CHECK(window.curves().standing().epsilon == before);
}

TEST_CASE("where samples have the epsilon of a shape by its formula, what is said is a bound for any of them") {
  // Not only of samples by feature size: of evenly spaced ones, too many in some places and too few in others.
  for (const KnownShape& shape : known_shapes())
    for (const std::size_t count : {12U, 30U, 200U}) {
      INFO(shape.name << ", " << count << " samples");
      const SampleData data = opened(shape.curves, {.rule = SamplingRule::count, .count = count});
      const Window bench(data);
      REQUIRE(bench.curves().has_standing());
      const double said = bench.curves().standing().epsilon;
      CHECK(true_epsilon(shape, data.positions) <= said);
      CHECK(epsilon_of_neighbours(shape, data) <= said);
      CHECK(said < 3.0 * std::max(true_epsilon(shape, data.positions), epsilon_of_neighbours(shape, data)));
    }
}

TEST_CASE("repair of samples of known curves puts new ones on the curves, and keeps corners") {
  std::vector<CurveSet> all{kLetter};
  for (const KnownShape& shape : known_shapes()) all.push_back(shape.curves);
  for (const CurveSet& curves : all) {
    const SampleData data = opened(curves, {.rule = SamplingRule::count, .count = 10});
    JobControl job;
    const auto repaired = repair(builtins(), data, 0.25, job);
    REQUIRE(repaired);
    CHECK(repaired->is_on_curves);
    CHECK(repaired->inserted > 0);
    CHECK(repaired->after.epsilon->value <= 0.25);
    CHECK(repaired->before.epsilon->value > 0.25);
    CHECK(repaired->after.light == TheoremLight::green);
    const std::vector<Vec2>& p = repaired->data.positions;
    REQUIRE(std::equal(data.positions.begin(), data.positions.end(), p.begin()));
    for (const Vec2 at : p) CHECK(off(curves, at) < 1e-6);
    // Loops go on along the curves, each sample once.
    std::size_t named = 0;
    double length = 0.0;
    for (const SampleData::Contour& contour : repaired->data.contours) {
      named += contour.points.size();
      for (std::size_t i = 0; i < contour.points.size(); ++i)
        length += distance(p[contour.points[i]], p[contour.points[(i + 1) % contour.points.size()]]);
    }
    CHECK(named == p.size());
    double known = 0.0;
    const SampleData dense = opened(curves, {.rule = SamplingRule::count, .count = 2000});
    for (const SampleData::Contour& contour : dense.contours)
      for (std::size_t i = 0; i < contour.points.size(); ++i)
        known += distance(dense.positions[contour.points[i]],
                          dense.positions[contour.points[(i + 1) % contour.points.size()]]);
    CHECK(length == Approx(known).epsilon(0.03));
    REQUIRE(repaired->data.source);
    CHECK(repaired->data.source->count == p.size());
    // The window has the same of them.
    const Window bench(repaired->data);
    CHECK(bench.curves().standing().epsilon == repaired->after.epsilon->value);
    CHECK(bench.light() == repaired->after.light);
  }
}

TEST_CASE("decimation of samples of known curves keeps the epsilon by the curves, not only by the estimate") {
  const double epsilon = GENERATE(0.25, 0.5);
  for (const KnownShape& shape : known_shapes()) {
    INFO(shape.name);
    const SampleData data = opened(shape.curves, {.rule = SamplingRule::count, .count = 4500});
    JobControl job;
    const auto decimated = decimate(builtins(), data, epsilon, job);
    REQUIRE(decimated);
    CHECK_FALSE(decimated->removed.empty());
    REQUIRE(decimated->before.epsilon);
    REQUIRE(decimated->after.epsilon);
    CHECK_FALSE(decimated->after.epsilon->is_estimate);
    CHECK(decimated->after.epsilon->value <= epsilon);
    CHECK(true_epsilon(shape, decimated->data.positions) <= epsilon);
  }
  const SampleData letter = opened(kLetter, {.rule = SamplingRule::count, .count = 4500});
  JobControl job;
  const auto decimated = decimate(builtins(), letter, epsilon, job);
  REQUIRE(decimated);
  CHECK_FALSE(decimated->removed.empty());
  CHECK(decimated->after.epsilon->value <= std::max(epsilon, decimated->before.epsilon->value));
}

TEST_CASE("samples of which most lie off their curves are repaired along a curve through themselves") {
  const KnownShape shape = known_ellipse(2.0, 1.0);
  SampleData data = opened(shape.curves, {.rule = SamplingRule::count, .count = 16});
  for (Vec2& p : data.positions) p = 1.5 * p;
  JobControl job;
  const auto repaired = repair(builtins(), data, 0.25, job);
  REQUIRE(repaired);
  CHECK_FALSE(repaired->is_on_curves);
  CHECK(repaired->after.light == TheoremLight::green);
  // One of them stays where it is, and new ones lie on the curves.
  SampleData one = opened(shape.curves, {.rule = SamplingRule::count, .count = 16});
  one.positions[3] = {0.1, 0.05};
  const auto partly = repair(builtins(), one, 0.25, job);
  REQUIRE(partly);
  CHECK(partly->is_on_curves);
  CHECK(partly->off_curve == 1);
  for (std::size_t i = one.positions.size(); i < partly->data.positions.size(); ++i)
    CHECK(std::abs(std::hypot(partly->data.positions[i].x / 2.0, partly->data.positions[i].y) - 1.0) < 1e-9);
}
