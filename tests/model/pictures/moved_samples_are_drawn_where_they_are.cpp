// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <map>

#include "app/picture/moved_points.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/graph.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

/// A document, a graph that follows when it is run, and the picture that is drawn of both.
struct MovedPointsBench {
  Document document;
  Graph graph{builtins()};
  FramePatch patch;
  JobControl job;
  LayerMirror picture;
  MovedPoints moved{find_layer("points")};

  explicit MovedPointsBench(const std::vector<Vec2>& points) {
    graph.set_demand(std::vector{find_layer("points")});
    post(*replace_all(document, {.positions = points}));
    run();
  }
  void post(const DocumentDelta& delta) {
    document.apply(delta);
    graph.post(std::make_shared<const DocumentDelta>(delta));
  }
  void run() {
    graph.run(patch, job);
    picture.apply(patch);
    moved.take(patch);
  }
  bool catch_up(const std::vector<SampleSlot>& samples) {
    const FramePatch* const own = moved.catch_up(document, samples, patch.frame);
    if (own != nullptr) picture.apply(*own);
    return own != nullptr;
  }
  /// Where the picture has each sample, by id.
  std::map<double, Vec2> drawn() const {
    std::map<double, Vec2> out;
    const auto points = picture.instances(find_layer("points"), PrimitiveKind::point);
    for (std::size_t at = 0; at < points.size(); at += 3) out[points[at + 2]] = {points[at], points[at + 1]};
    return out;
  }
  std::map<double, Vec2> expected() const {
    std::map<double, Vec2> out;
    for (const SampleSlot slot : document.slots_in_input_order())
      out[static_cast<double>(document.id(slot).value)] = document.position(slot);
    return out;
  }
};

std::vector<Vec2> random_points(Rng& rng, std::size_t n) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < n; ++i) out.push_back({rng.uniform(), rng.uniform()});
  return out;
}

}  // namespace

TEST_CASE("samples that were moved are drawn where they are before the engine has followed, and stay there") {
  Rng rng(7);
  MovedPointsBench bench(random_points(rng, 40));
  const std::vector<SampleSlot> slots = bench.document.slots_in_input_order();
  const std::vector<SampleSlot> held{slots[3], slots[17], slots[39]};
  for (int step = 0; step < 5; ++step) {
    std::vector<std::pair<SampleId, Vec2>> targets;
    for (const SampleSlot slot : held)
      targets.emplace_back(bench.document.id(slot), Vec2{rng.uniform(), rng.uniform()});
    bench.post(*move_samples(bench.document, targets));
    CHECK(bench.drawn() != bench.expected());
    CHECK(bench.catch_up(held));
    CHECK(bench.drawn() == bench.expected());
    if (step % 2 == 1) bench.run();
    CHECK(bench.drawn() == bench.expected());
  }
}

TEST_CASE("whichever samples come and go, those that are held are found") {
  Rng rng(11);
  MovedPointsBench bench(random_points(rng, 30));
  for (int round = 0; round < 60; ++round) {
    const std::vector<SampleSlot> slots = bench.document.slots_in_input_order();
    if (rng.below(2) == 0)
      bench.post(*insert_samples(bench.document, random_points(rng, 3)));
    else
      bench.post(*remove_samples(bench.document, std::vector{bench.document.id(slots[rng.below(slots.size())])}));
    bench.run();
    const std::vector<SampleSlot> now = bench.document.slots_in_input_order();
    const SampleSlot held = now[rng.below(now.size())];
    bench.post(
        *move_samples(bench.document, std::vector{std::pair{bench.document.id(held), Vec2{2.0, 0.1 * round}}}));
    CHECK(bench.catch_up({held}));
    REQUIRE(bench.drawn() == bench.expected());
    bench.run();
    REQUIRE(bench.drawn() == bench.expected());
  }
}

TEST_CASE("a sample that the engine has not seen yet is not drawn by the window") {
  Rng rng(3);
  MovedPointsBench bench(random_points(rng, 5));
  bench.post(*insert_samples(bench.document, std::vector<Vec2>{{3.0, 3.0}}));
  const SampleSlot newest = bench.document.slots_in_input_order().back();
  CHECK_FALSE(bench.catch_up({newest}));
  CHECK(bench.drawn().size() == 5);
  CHECK_FALSE(bench.catch_up({}));
}
