// SPDX-License-Identifier: GPL-3.0-or-later
// Random edit scripts: after every edit each structure, and every layer's instances, equal those of a graph that sees
// the final samples only.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <map>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/document/timeline/history.h"
#include "core/draw/layer_mirror.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/effort.h"
#include "tests/support/layer_contents.h"
#include "tests/support/state_of_graph.h"

using namespace mes;
using namespace mes::test;

namespace {

// Unions of balls and what is made of them take most of the time.
bool is_of_union(const LayerDescriptor& layer) {
  return std::ranges::any_of(layer.structures, [](std::string_view structure) {
    return structure.ends_with("-union") || structure.ends_with("-diagram") ||
           structure.ends_with("-precision-difference") || structure.ends_with("-ball-filtration");
  });
}

/// What of the unions a script takes along. The exact ones compute in rationals whatever the number type.
enum class Unions { none, in_doubles, exact_too };

std::vector<LayerIndex> all_layers(Unions unions) {
  std::vector<LayerIndex> layers;
  for (LayerIndex i = 0; i < layer_descriptors().size(); ++i) {
    const LayerDescriptor& layer = layer_descriptors()[i];
    if (unions == Unions::none && is_of_union(layer)) continue;
    if (unions != Unions::exact_too && layer.id == "precision-difference") continue;
    layers.push_back(i);
  }
  return layers;
}

// A document, its history, and a graph that follows it edit by edit.
struct Bench {
  Document document;
  History history;
  Graph graph{builtins()};
  FramePatch patch;
  LayerContents contents;
  LayerMirror mirror;

  Unions unions;

  explicit Bench(Unions taken) : unions(taken) { graph.set_demand(all_layers(taken)); }

  void run() {
    JobControl job;
    REQUIRE(graph.run(patch, job));
    for (const NodeReport& node : patch.nodes) {
      INFO(node.structure << ": " << node.reason);
      REQUIRE((node.state == NodeState::up_to_date || node.state == NodeState::inactive));
    }
    contents.apply(patch);
    mirror.apply(patch);
  }
  void apply(const Expected<DocumentDelta>& delta) {
    REQUIRE(delta.has_value());
    document.apply(*delta);
    history.record(*delta);
    graph.post(std::make_shared<const DocumentDelta>(*delta));
  }

  // Compares with a fresh graph of the same samples, given in another order.
  void check() {
    REQUIRE(broken_row(graph) == "");
    Bench fresh(unions);
    SampleData data;
    auto slots = document.slots_in_input_order();
    std::ranges::reverse(slots);
    for (const SampleSlot slot : slots) data.positions.push_back(document.position(slot));
    auto ball_slots = document.ball_slots_in_input_order();
    std::ranges::reverse(ball_slots);
    for (const BallSlot slot : ball_slots) data.balls.push_back(document.disk(slot));
    fresh.apply(replace_all(fresh.document, data));
    fresh.run();
    REQUIRE(difference(state_of(graph), state_of(fresh.graph)) == "");
    for (LayerIndex i = 0; i < layer_descriptors().size(); ++i) {
      if (i == find_layer("last-change")) continue;
      INFO(layer_descriptors()[i].id);
      REQUIRE(mirror.digest(i) == fresh.mirror.digest(i));
    }
  }
};

using Source = std::function<Vec2(Rng&)>;

// Something happens to balls.
void edit_balls(Bench& bench, const Source& source, Rng& rng) {
  const auto slots = bench.document.ball_slots_in_input_order();
  const auto some_disk = [&] { return Disk{source(rng), rng.below(5) == 0 ? 0.0 : rng.uniform()}; };
  const auto pick = [&] { return bench.document.ball_id(slots[rng.below(slots.size())]); };
  switch (slots.size() < 2 ? 0 : rng.below(4)) {
    case 0:
    case 1: bench.apply(insert_balls(bench.document, std::vector<Disk>(1 + rng.below(3), some_disk()))); break;
    case 2: bench.apply(change_balls(bench.document, std::vector{std::pair{pick(), some_disk()}})); break;
    default: bench.apply(remove_balls(bench.document, std::vector{pick()})); break;
  }
}

void play_script(const Source& source, std::size_t start, std::size_t steps, std::uint64_t seed, double nudge,
                 bool with_balls = false) {
  Rng rng(seed);
  // One script of each kind takes the unions along, for fewer samples and steps, each of which takes so much longer.
  const Unions unions = seed % 10 != 1 ? Unions::none : (start <= 60 ? Unions::exact_too : Unions::in_doubles);
  constexpr std::size_t kUnionShare = 8, kUnionStart = 100;
  if (unions != Unions::none) {
    steps = steps * effort() / kUnionShare;
    start = std::min(start, kUnionStart);
  }
  Bench bench(unions);
  SampleData data;
  for (std::size_t i = 0; i < start; ++i) data.positions.push_back(source(rng));
  bench.apply(replace_all(bench.document, data));
  bench.run();
  bench.check();
  for (std::size_t step = 0; step < steps; ++step) {
    const auto slots = bench.document.slots_in_input_order();
    const auto pick = [&] { return bench.document.id(slots[rng.below(slots.size())]); };
    const std::uint64_t action = slots.size() < 3 ? 0 : rng.below(10);
    if (action < 3) {
      bench.apply(insert_samples(bench.document, std::vector{source(rng)}));
    } else if (action < 5) {
      bench.apply(remove_samples(bench.document, std::vector{pick()}));
    } else if (action < 8) {
      const SampleId id = pick();
      const Vec2 p = bench.document.position(bench.document.slot_of(id));
      const Vec2 to =
          rng.below(3) == 0 ? source(rng) : p + Vec2{nudge * (rng.uniform() - 0.5), nudge * (rng.uniform() - 0.5)};
      bench.apply(move_samples(bench.document, std::vector{std::pair{id, to}}));
    } else if (action == 8) {
      // A batch: several kinds of edits become one step of the graph.
      std::vector<Vec2> points(1 + rng.below(5));
      for (Vec2& p : points) p = source(rng);
      bench.apply(insert_samples(bench.document, points));
      std::vector<SampleId> gone{pick()};
      const SampleId second = pick();
      if (second != gone.front()) gone.push_back(second);
      bench.apply(remove_samples(bench.document, gone));
      bench.apply(insert_samples(bench.document, std::vector{source(rng)}));
    } else {
      for (const auto& delta : bench.history.undo()) {
        bench.document.apply(delta);
        bench.graph.post(std::make_shared<const DocumentDelta>(delta));
      }
    }
    if (with_balls && rng.below(2) == 0) {
      if (rng.below(2) == 0) bench.run();
      edit_balls(bench, source, rng);
    }
    INFO("seed " << seed << " step " << step);
    bench.run();
    bench.check();
  }
}

Vec2 curve_point(double t) {
  const double r = 200.0 * (1.0 + 0.3 * std::cos(5.0 * t) + 0.05 * std::cos(37.0 * t));
  return {r * std::cos(t), r * std::sin(t)};
}

}  // namespace

TEST_CASE("smooth curve") {
  const Source source = [](Rng& rng) { return curve_point(6.283185307179586 * rng.uniform()); };
  for (std::uint64_t seed = 1; seed < 2 + effort(); ++seed) play_script(source, 300, 400, seed, 3.0);
}

TEST_CASE("noisy curve") {
  const Source source = [](Rng& rng) {
    return curve_point(6.283185307179586 * rng.uniform()) + Vec2{8.0 * rng.uniform(), 8.0 * rng.uniform()};
  };
  for (std::uint64_t seed = 11; seed < 12 + effort(); ++seed) play_script(source, 250, 400, seed, 10.0);
}

TEST_CASE("random points") {
  const Source source = [](Rng& rng) { return Vec2{rng.uniform(), rng.uniform()}; };
  for (std::uint64_t seed = 21; seed < 22 + effort(); ++seed) play_script(source, 150, 400, seed, 0.1);
}

TEST_CASE("a small integer lattice, where everything is cocircular and positions repeat") {
  const Source source = [](Rng& rng) {
    return Vec2{static_cast<double>(rng.below(7)), static_cast<double>(rng.below(7))};
  };
  for (std::uint64_t seed = 31; seed < 32 + effort(); ++seed) play_script(source, 25, 300, seed, 0.0);
  play_script(source, 25, 300, 60, 0.0);
}

TEST_CASE("from nothing, through one point and collinear points, and back") {
  const Source source = [](Rng& rng) {
    return Vec2{static_cast<double>(rng.below(3)), static_cast<double>(rng.below(2))};
  };
  for (std::uint64_t seed = 41; seed < 42 + 2 * effort(); ++seed) play_script(source, 0, 150, seed, 0.0);
}

TEST_CASE("duplicates of a few positions") {
  const Source source = [](Rng& rng) {
    const double t = 0.5 * static_cast<double>(rng.below(13));
    return Vec2{std::cos(t), std::sin(t)};
  };
  for (std::uint64_t seed = 51; seed < 52 + effort(); ++seed) play_script(source, 60, 200, seed, 0.0);
}

TEST_CASE("exactly cocircular samples, whose common centre each triangle rounds in its own way") {
  const Source source = [](Rng& rng) {
    constexpr std::array<Vec2, 12> kCircle{
        {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}}};
    const Vec2 middle{10.0 * static_cast<double>(rng.below(3)), 10.0 * static_cast<double>(rng.below(2))};
    return kCircle[rng.below(12)] + middle;
  };
  for (std::uint64_t seed = 71; seed < 72 + 2 * effort(); ++seed) play_script(source, 30, 200, seed, 1.0);
}

TEST_CASE("balls among samples, in steps of their own and in common ones") {
  const Source source = [](Rng& rng) { return Vec2{rng.uniform(), rng.uniform()}; };
  for (std::uint64_t seed = 61; seed < 62 + effort(); ++seed) play_script(source, 60, 300, seed, 0.1, true);
  for (std::uint64_t seed = 65; seed < 65 + effort(); ++seed) play_script(source, 0, 150, seed, 0.1, true);
}
