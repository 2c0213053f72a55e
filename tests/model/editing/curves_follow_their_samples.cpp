// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "core/curves/affine.h"
#include "core/curves/nearest_place.h"
#include "core/document/taken_samples.h"
#include "core/document/timeline/timeline.h"

using namespace mes;

namespace {

PlaneCurve circle_about(Vec2 center) {
  PlaneCurve curve(center + Vec2{2, 0});
  curve.arc_to({center, {2, 0}, {0, 2}, 0.0, 2 * std::numbers::pi}, center + Vec2{2, 0});
  curve.close();
  return curve;
}

PlaneCurve triangle_at(Vec2 corner) {
  PlaneCurve curve(corner);
  curve.line_to(corner + Vec2{3, 0});
  curve.line_to(corner + Vec2{0, 4});
  curve.close();
  return curve;
}

/// Two circles and a triangle, 24 samples each, then three samples of no curve.
struct CurvesBench {
  Document heard;  // by the deltas alone, as the engine does
  Editor editor{[this](const std::shared_ptr<const DocumentDelta>& delta) { heard.apply(*delta); }};

  CurvesBench() {
    const auto curves = std::make_shared<const CurveSet>(
        CurveSet{.curves = {circle_about({0, 0}), circle_about({10, 0}), triangle_at({20, 0})}});
    const SamplingRequest request{.rule = SamplingRule::count, .count = 72};
    auto samples = sample(*curves, request);
    REQUIRE(samples);
    auto data = taken_from(curves, *std::move(samples), request);
    REQUIRE(data);
    REQUIRE(editor.load(*std::move(data)));
    REQUIRE(editor.insert(std::vector<Vec2>{{5, 9}, {6, 9}, {7, 9}}, "Insert"));
  }

  const Document& document() const { return editor.document(); }
  const CurveSet& curves() const { return *document().source()->curves; }
  std::vector<SampleId> of_contour(std::size_t contour) const {
    return document().curve_order()->contours[contour].samples;
  }
  std::vector<SampleId> of_all() const { return document().samples_of_source(); }

  std::vector<std::pair<SampleId, Vec2>> mapped(const std::vector<SampleId>& ids, const Affine& map) const {
    std::vector<std::pair<SampleId, Vec2>> out;
    for (const SampleId id : ids) out.emplace_back(id, map.of_point(document().position(document().slot_of(id))));
    return out;
  }
  void move(const std::vector<SampleId>& ids, const Affine& map) { REQUIRE(editor.move(mapped(ids, map), "Move")); }

  /// The greatest distance from a sample of the curves to the nearest point of them.
  double greatest_distance() const {
    double out = 0.0;
    for (const SampleId id : of_all()) {
      const Vec2 p = document().position(document().slot_of(id));
      const auto place = nearest_place(curves(), p, 100.0);
      REQUIRE(place);
      out = std::max(out, std::hypot(place->x - p.x, place->y - p.y));
    }
    return out;
  }
  void check_replay() const {
    CHECK(heard.digest() == document().digest());
    DocumentReplay replay;
    REQUIRE(replay.begin(*editor.timeline().data()));
    for (const TimelineEntry& entry : editor.timeline().entries()) REQUIRE(replay.apply(entry));
    CHECK(replay.document().digest() == document().digest());
    CHECK((replay.document().source() == document().source() || *replay.document().source() == *document().source()));
  }
};

constexpr double kNothing = 1e-7;  // the nearest point of an arc is known to 1e-9 of its parameter

}  // namespace

TEST_CASE("curves whose samples are all moved, turned, scaled or mirrored follow them, as one step of undo") {
  const Affine map = GENERATE(Affine::translation(3, -40), Affine::rotation(0.7), Affine::scaling(2.5, 0.5),
                              Affine::scaling(-1, 1), Affine::translation(1, 2) * Affine::rotation(2));
  CurvesBench bench;
  const CurveSet before = bench.curves();
  bench.move(bench.of_all(), map);
  CHECK(bench.curves() != before);
  CHECK(bench.greatest_distance() < kNothing);
  bench.check_replay();
  bench.editor.undo();
  CHECK(bench.curves() == before);
  CHECK(bench.greatest_distance() < kNothing);
  bench.editor.redo();
  CHECK(bench.greatest_distance() < kNothing);
  bench.check_replay();
}

TEST_CASE("a curve follows its own samples, and the others stay") {
  CurvesBench bench;
  const CurveSet before = bench.curves();
  bench.move(bench.of_contour(1), Affine::translation(0, 7));
  CHECK(bench.curves().curves[0] == before.curves[0]);
  CHECK(bench.curves().curves[2] == before.curves[2]);
  CHECK(bench.curves().curves[1].start() == before.curves[1].start() + Vec2{0, 7});
  CHECK(bench.greatest_distance() < kNothing);
  bench.check_replay();

  SECTION("also with samples of no curve, and after a sample was removed") {
    REQUIRE(bench.editor.remove(std::vector{bench.of_contour(0)[5]}, "Delete"));
    std::vector<SampleId> ids = bench.of_contour(0);
    const Document& document = bench.document();
    std::erase_if(ids, [&](SampleId id) { return document.slot_of(id) == kNoSlot; });
    ids.emplace_back(document.first_id().value + document.source()->count);
    bench.move(ids, Affine::translation(-5, 0));
    CHECK(bench.greatest_distance() < kNothing);
    bench.check_replay();
  }
}

TEST_CASE("curves stay where only some of their samples move, or where these do not move alike") {
  CurvesBench bench;
  const CurveSet before = bench.curves();
  std::vector<SampleId> ids = bench.of_all();
  SECTION("some") {
    ids.pop_back();
    ids.erase(ids.begin());
    ids.erase(ids.begin() + 30);
    bench.move(ids, Affine::translation(1, 1));
  }
  SECTION("one") {
    bench.move({ids.front()}, Affine::translation(1, 1));
  }
  SECTION("each its own way") {
    auto targets = bench.mapped(ids, {});
    for (std::size_t i = 0; i < targets.size(); ++i) targets[i].second.x += i % 7 == 0 ? 0.5 : -0.25;
    REQUIRE(bench.editor.move(targets, "Move"));
  }
  CHECK(bench.curves() == before);
  bench.check_replay();
}

TEST_CASE("curves follow at the end of a gesture, and stay if it is cancelled") {
  CurvesBench bench;
  const CurveSet before = bench.curves();
  const auto drag = [&] {
    bench.editor.begin_gesture("Move samples");
    for (int step = 0; step < 5; ++step) bench.move(bench.of_all(), Affine::translation(1, 2));
  };
  drag();
  CHECK(bench.curves() == before);
  SECTION("ended") {
    bench.editor.end_gesture();
    CHECK(bench.curves().curves[0].start() == before.curves[0].start() + Vec2{5, 10});
    CHECK(bench.greatest_distance() < kNothing);
    bench.check_replay();
    bench.editor.undo();
    CHECK(bench.curves() == before);
    CHECK(bench.greatest_distance() < kNothing);
  }
  SECTION("cancelled") {
    bench.editor.cancel_gesture();
    CHECK(bench.curves() == before);
    CHECK(bench.greatest_distance() < kNothing);
    bench.check_replay();
  }
}

TEST_CASE("curves go with the last of their samples, and come back with them") {
  CurvesBench bench;
  const std::vector<SampleId> ids = bench.of_all();
  REQUIRE(bench.editor.remove(std::vector(ids.begin(), ids.end() - 2), "Delete"));
  REQUIRE(bench.document().source());
  REQUIRE(bench.editor.remove(std::vector(ids.end() - 2, ids.end()), "Delete"));
  CHECK_FALSE(bench.document().source());
  CHECK(bench.document().sample_count() == 3);
  bench.check_replay();
  bench.editor.undo();
  CHECK(bench.document().source());
  bench.check_replay();
}
