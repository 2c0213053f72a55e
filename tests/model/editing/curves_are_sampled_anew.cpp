// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "app/editing/curves/curve_sampler.h"
#include "core/document/taken_samples.h"
#include "core/io/session/session.h"
#include "tests/model/editing/positions_of.h"
#include "tests/support/bell.h"

using namespace mes;
using mes::test::Bell;
using mes::test::positions_of;

namespace {

std::shared_ptr<const CurveSet> curve_of_circle(double radius) {
  PlaneCurve curve({radius, 0});
  curve.arc_to({{0, 0}, {radius, 0}, {0, radius}, 0.0, 2 * std::numbers::pi}, {radius, 0});
  curve.close();
  curve.name = "round";
  return std::make_shared<const CurveSet>(CurveSet{.curves = {curve}});
}

SampleData data_of_circle(double radius, std::size_t count) {
  const auto curves = curve_of_circle(radius);
  const SamplingRequest request{.rule = SamplingRule::count, .count = count};
  auto samples = sample(*curves, request);
  REQUIRE(samples);
  auto data = taken_from(curves, *std::move(samples), request);
  REQUIRE(data);
  return *std::move(data);
}

struct SamplerBench {
  Document heard;  // by the deltas alone, as the engine does
  Editor editor{[this](const std::shared_ptr<const DocumentDelta>& delta) { heard.apply(*delta); }};
  Bell bell;
  CurveSampler sampler{editor, bell.ring()};

  SamplerBench() { REQUIRE(editor.load(data_of_circle(2, 40))); }
  void finish(bool is_held) {
    bell.wait_until([&] {
      if (sampler.is_busy()) REQUIRE(sampler.follow(is_held));
      return !sampler.is_busy();
    });
    REQUIRE(sampler.follow(is_held));
    CHECK(heard.digest() == editor.document().digest());
  }
  void want(std::size_t count, bool is_held) {
    REQUIRE(sampler.follow(is_held));
    SamplingRequest request = sampler.request();
    request.rule = SamplingRule::count;
    request.count = count;
    sampler.want(request);
    finish(is_held);
  }
  DocumentReplay replayed() const {
    DocumentReplay replay;
    REQUIRE(replay.begin(*editor.timeline().data()));
    for (const TimelineEntry& entry : editor.timeline().entries()) REQUIRE(replay.apply(entry));
    return replay;
  }
};

}  // namespace

TEST_CASE("other samples of the curves are one step of undo, and come back with redo") {
  SamplerBench bench;
  const std::vector<Vec2> before = positions_of(bench.editor.document());
  bench.want(100, false);
  CHECK(bench.editor.document().sample_count() == 100);
  CHECK(bench.editor.document().source()->sampling.count == 100);
  CHECK(bench.editor.undo_name() == "Take samples of curves");
  const std::vector<Vec2> after = positions_of(bench.editor.document());
  CHECK(bench.editor.document().curve_order()->contours.size() == 1);
  bench.editor.undo();
  CHECK(positions_of(bench.editor.document()) == before);
  CHECK(bench.editor.document().source()->sampling.count == 40);
  CHECK_FALSE(bench.editor.can_undo());
  bench.editor.redo();
  CHECK(positions_of(bench.editor.document()) == after);
  CHECK(bench.heard.digest() == bench.editor.document().digest());
}

TEST_CASE("while a control is held all samplings are one step, and two controls are two") {
  SamplerBench bench;
  for (const std::size_t count : {50U, 60U, 30U, 70U}) bench.want(count, true);
  CHECK(bench.editor.document().sample_count() == 70);
  bench.finish(false);
  for (const std::size_t count : {55U, 20U}) bench.want(count, true);
  bench.finish(false);
  CHECK(bench.editor.document().sample_count() == 20);
  bench.editor.undo();
  CHECK(bench.editor.document().sample_count() == 70);
  bench.editor.undo();
  CHECK(bench.editor.document().sample_count() == 40);
  CHECK_FALSE(bench.editor.can_undo());
  // An edit in between is a step of its own.
  bench.want(50, true);
  REQUIRE(bench.editor.insert(std::array{Vec2{0, 0}}, "Insert"));
  bench.want(60, true);
  bench.editor.undo();
  CHECK(bench.editor.document().sample_count() == 51);
}

TEST_CASE("samples set by hand stay, and those of the curves go, moved or not") {
  SamplerBench bench;
  Editor& editor = bench.editor;
  CHECK(bench.sampler.samples_text() == "40 samples");
  REQUIRE(editor.insert(std::array{Vec2{0.5, 0.5}}, "Insert"));
  CHECK(bench.sampler.samples_text() == "40 of 41 samples are of the curves");
  const SampleId first = editor.document().id(editor.document().slots_in_input_order().front());
  REQUIRE(editor.move(std::array{std::pair(first, Vec2{9, 9})}, "Move"));
  const SampleId second = editor.document().id(editor.document().slots_in_input_order()[1]);
  REQUIRE(editor.remove(std::array{second}, "Delete"));
  CHECK(bench.sampler.samples_text() == "39 of 40 samples are of the curves");
  bench.want(12, false);
  CHECK(bench.sampler.samples_text() == "12 of 13 samples are of the curves");
  std::vector<Vec2> now = positions_of(editor.document());
  REQUIRE(now.size() == 13);
  CHECK(std::ranges::count(now, Vec2{0.5, 0.5}) == 1);
  CHECK(std::ranges::count(now, Vec2{9, 9}) == 0);
  for (const Vec2 p : now)
    if (p != Vec2{0.5, 0.5}) CHECK(length(p) == Approx(2.0));
  // Whatever happened, the timeline tells of it.
  const DocumentReplay replay = bench.replayed();
  CHECK(positions_of(replay.document()) == now);
  CHECK(replay.document().digest() == editor.document().digest());
  REQUIRE(replay.document().source());
  CHECK(*replay.document().source() == *editor.document().source());
  CHECK(*replay.document().curve_order() == *editor.document().curve_order());
  CHECK(replay.document().snapshot()->free_slots == editor.document().snapshot()->free_slots);
}

TEST_CASE("a notice tells of edits that a sampling replaces, once, and of nothing else") {
  SamplerBench bench;
  const auto told = [&] { return bench.sampler.take_notice().value_or(""); };
  const auto first = [&] {
    const Document& document = bench.editor.document();
    return document.id(document.slots_in_input_order().front());
  };
  bench.want(50, false);
  CHECK(told().empty());
  // A sample that is removed, before anything was sampled here or after it.
  for (const std::size_t count : {60U, 70U}) {
    REQUIRE(bench.editor.remove(std::array{first()}, "Delete"));
    bench.want(count, false);
    CHECK_THAT(told(), Catch::Contains("edits of samples of the curves are gone"));
    bench.want(count + 1, false);
    CHECK(told().empty());
  }
  REQUIRE(bench.editor.move(std::array{std::pair(first(), Vec2{9, 9})}, "Move"));
  bench.want(80, true);
  bench.want(81, true);
  bench.want(82, false);
  CHECK_THAT(told(), Catch::Contains("edits of samples of the curves are gone"));
  CHECK(told().empty());
  // Adding a sample beside the curves edits none of theirs.
  REQUIRE(bench.editor.insert(std::array{Vec2{0.5, 0.5}}, "Insert"));
  bench.want(90, false);
  CHECK(told().empty());
}

TEST_CASE("curves are saved with sessions and samples can be taken of them when they are read") {
  SamplerBench bench;
  bench.want(30, false);
  REQUIRE(bench.editor.resample(data_of_circle(5, 20), "Shape", false));
  bench.want(25, true);
  bench.want(35, true);
  bench.finish(false);
  Session session;
  session.data = bench.editor.timeline().data();
  session.entries = bench.editor.timeline().entries();
  const std::string text = write_session(session);
  const auto read = read_session(text, "a.json");
  REQUIRE(read);
  CHECK(read->entries == session.entries);
  CHECK(*read->data->source == *session.data->source);
  CHECK(write_session(*read) == text);
  DocumentReplay replay;
  REQUIRE(replay_session(*read, replay, "a.json"));
  Editor editor({});
  editor.restore(std::move(replay), read->data, read->entries);
  CHECK(*editor.document().source() == *bench.editor.document().source());
  CHECK(editor.document().source()->curves->curves[0].name == "round");
  CHECK(positions_of(editor.document()) == positions_of(bench.editor.document()));
  while (editor.can_undo()) editor.undo();
  CHECK(editor.document().sample_count() == 40);
  CHECK(*editor.document().source()->curves == *curve_of_circle(2));
  // What a picture carries has the curves, too, without the history.
  const SampleData now = data_of(bench.editor.document());
  REQUIRE(now.source);
  CHECK(now.source->count == 35);
  CHECK(*now.source->curves == *curve_of_circle(5));
}

TEST_CASE("another document drops what is under way") {
  SamplerBench bench;
  SamplingRequest request = bench.sampler.request();
  request.count = 77;
  bench.sampler.want(request);
  REQUIRE(bench.editor.load({.positions = {{0, 0}, {1, 0}, {0, 1}}}));
  bench.finish(false);
  CHECK(bench.editor.document().sample_count() == 3);
  CHECK(bench.sampler.source() == nullptr);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("an undo while samples are taken drops them, so that redo is there") {
  SamplerBench bench;
  bench.want(60, false);
  SamplingRequest request = bench.sampler.request();
  request.count = 77;
  bench.sampler.want(request);
  bench.editor.undo();
  bench.finish(false);
  CHECK(bench.editor.document().sample_count() == 40);
  CHECK(bench.editor.can_redo());
  bench.editor.redo();
  CHECK(bench.editor.document().sample_count() == 60);
}

TEST_CASE("the epsilon that is asked for stays the one that is asked for") {
  // Not proved at 1, so that a smaller epsilon is taken.
  SamplerBench bench;
  PlaneCurve ellipse({3, 0});
  ellipse.arc_to({{0, 0}, {3, 0}, {0, 0.2}, 0.0, 2 * std::numbers::pi}, {3, 0});
  ellipse.close();
  const auto curves = std::make_shared<const CurveSet>(CurveSet{.curves = {ellipse}});
  const SamplingRequest few{.rule = SamplingRule::count, .count = 20};
  REQUIRE(bench.editor.load(*taken_from(curves, *sample(*curves, few), few)));
  SamplingRequest request = bench.sampler.request();
  request.rule = SamplingRule::feature_size;
  request.epsilon = 1.0;
  bench.sampler.want(request);
  bench.finish(true);
  CHECK(bench.sampler.request() == request);
  // The same wish again begins nothing.
  bench.sampler.want(request);
  CHECK_FALSE(bench.sampler.is_busy());
}

TEST_CASE("a wish that cannot be fulfilled says why and changes nothing") {
  SamplerBench bench;
  SamplingRequest request = bench.sampler.request();
  request.rule = SamplingRule::spacing;
  request.spacing = 1e-12;
  bench.sampler.want(request);
  Expected<void> done;
  bench.bell.wait_until([&] {
    if (bench.sampler.is_busy()) done = bench.sampler.follow(false);
    return !bench.sampler.is_busy();
  });
  REQUIRE_FALSE(done);
  CHECK_THAT(done.error().text, Catch::Contains("as many as there may be"));
  CHECK(bench.editor.document().sample_count() == 40);
  CHECK(bench.sampler.request().rule == SamplingRule::count);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("curves are laid through samples that have none, and nothing moves") {
  SamplerBench bench;
  SampleData plain = data_of_circle(3, 24);
  plain.source.reset();
  REQUIRE(bench.editor.load(plain));
  CHECK(bench.sampler.source() == nullptr);
  bench.sampler.want_curves_of_samples();
  bench.finish(false);
  REQUIRE(bench.sampler.source() != nullptr);
  CHECK(positions_of(bench.editor.document()) == plain.positions);
  CHECK(bench.sampler.source()->curves->curves.size() == 1);
  CHECK(bench.sampler.take_notice() ==
        "1 curve was laid through the samples; others can be taken on the page Curves");
  bench.want(48, false);
  CHECK(bench.editor.document().sample_count() == 48);
  bench.editor.undo();
  bench.editor.undo();
  CHECK(bench.sampler.source() == nullptr);
  CHECK(positions_of(bench.editor.document()) == plain.positions);
  CHECK(bench.replayed().document().digest() == bench.editor.document().digest());
}

TEST_CASE("corners are marked with their angles in one step") {
  SamplerBench bench;
  CHECK(bench.sampler.corners().empty());
  PlaneCurve square({0, 0});
  for (const Vec2 p : {Vec2{4, 0}, Vec2{4, 4}, Vec2{0, 4}}) square.line_to(p);
  square.close();
  const auto curves = std::make_shared<const CurveSet>(CurveSet{.curves = {square}});
  const SamplingRequest request{.rule = SamplingRule::count, .count = 40};
  REQUIRE(bench.editor.load(*taken_from(curves, *sample(*curves, request), request)));
  CHECK(bench.sampler.corners().size() == 4);
  REQUIRE(bench.sampler.mark_corners());
  CHECK(bench.editor.document().annotations()->size() == 4);
  CHECK(bench.editor.document().annotations()->front().text == "90\u00b0");
  REQUIRE(bench.sampler.mark_corners());
  CHECK(bench.editor.document().annotations()->size() == 4);
  bench.editor.undo();
  CHECK(bench.editor.document().annotations()->empty());
}
