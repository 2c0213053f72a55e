// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the graph are stopped at each place where they look for it, one after the other, with edits, other settings
// and other layers between; all patches go through a mirror, and what it holds in the end is what a fresh graph
// draws.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/document/timeline/history.h"
#include "core/structures/delaunay/delaunay.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::int64_t kNever = 1'000'000'000;

// A graph and the consumer of its patches. One patch serves for all runs, as the engine has it.
struct Consumer {
  Graph graph{builtins()};
  FramePatch patch;
  LayerMirror mirror;

  /// True when the run came to its end before it had looked so many times.
  bool run(std::int64_t stop_at) {
    JobControl job;
    job.stop_at_look(stop_at);
    const std::uint64_t shown = mirror.document_revision();
    const bool is_complete = graph.run(patch, job);
    REQUIRE(patch.complete == is_complete);
    mirror.apply(patch);
    if (!is_complete) {
      REQUIRE(patch.layer_count == 0);
      REQUIRE(patch.document_revision == shown);
      return false;
    }
    for (const NodeReport& node : patch.nodes) {
      INFO(node.structure << ": " << node.reason);
      REQUIRE((node.state == NodeState::up_to_date || node.state == NodeState::inactive));
    }
    return true;
  }
};

class Script {
 public:
  explicit Script(std::uint64_t seed) : rng_(seed) {
    SampleData data;
    for (int i = 0; i < 24; ++i) data.positions.push_back(place());
    for (int i = 0; i < 6; ++i) data.balls.push_back({place(), 3.0 + 20.0 * rng_.uniform()});
    post(*replace_all(document_, data));  // cannot be undone
    choose_layers();
  }

  /// Something happens.
  void act() {
    const auto slots = document_.slots_in_input_order();
    const auto pick = [&] { return document_.id(slots[rng_.below(slots.size())]); };
    switch (rng_.below(12)) {
      case 0:
      case 1: apply(insert_samples(document_, std::vector{place()})); break;
      case 2:
        if (slots.size() > 12) apply(remove_samples(document_, std::vector{pick()}));
        break;
      case 3:
      case 4: apply(move_samples(document_, std::vector{std::pair{pick(), place()}})); break;
      case 5: apply(insert_balls(document_, std::vector{Disk{place(), 30.0 * rng_.uniform()}})); break;
      case 6: {
        // All samples at once, far away now and then: the pictures are then drawn in another frame.
        const double far = rng_.below(3) == 0 ? 0x1p30 : 0.0;
        std::vector<Vec2> positions;
        for (const SampleSlot slot : slots) positions.push_back(0.99 * document_.position(slot) + Vec2{far, 0.0});
        apply(arrange_samples(document_, positions, {}));
        break;
      }
      case 7:
        for (const auto& delta : history_.undo()) post(delta);
        break;
      case 8: choose_layers(); break;
      case 9:
        settings_[Parameter::union_shortcut] = static_cast<double>(rng_.below(2));
        settings_[Parameter::a_scale] = rng_.below(2) == 0 ? 1.0 : 1.25;
        settings_[Parameter::b_scale] = rng_.below(2) == 0 ? 1.0 : 0.75;
        settings_[Parameter::lambda_limit] = rng_.below(2) == 0 ? 0.0 : 5.0;
        settings_[Parameter::angle_limit] = rng_.below(2) == 0 ? 0.0 : 40.0;
        settings_[Parameter::keep_topology] = static_cast<double>(rng_.below(2));
        settings_[Parameter::alpha_radius] = rng_.below(2) == 0 ? 0.0 : 12.0;
        settings_[Parameter::scale_axis_factor] = rng_.below(2) == 0 ? 1.0 : 1.2;
        consumer_.graph.post_settings(settings_);
        break;
      case 10: consumer_.graph.set_want_statistics(rng_.below(2) == 0); break;
      default: consumer_.graph.set_want_findings(rng_.below(2) == 0); break;
    }
  }
  bool run(std::int64_t stop_at) { return consumer_.run(stop_at); }
  Rng& rng() { return rng_; }

  void check() {
    Consumer fresh;
    fresh.graph.post_settings(settings_);
    fresh.graph.set_demand(shown_);
    SampleData data;
    for (const SampleSlot slot : document_.slots_in_input_order()) data.positions.push_back(document_.position(slot));
    for (const BallSlot slot : document_.ball_slots_in_input_order()) data.balls.push_back(document_.disk(slot));
    Document document;
    fresh.graph.post(std::make_shared<const DocumentDelta>(*replace_all(document, data)));
    REQUIRE(fresh.run(kNever));
    REQUIRE(consumer_.patch.document_revision == document_.revision());
    for (const LayerIndex layer : shown_) {
      if (layer == find_layer("last-change")) continue;
      INFO(layer_descriptors()[layer].id);
      REQUIRE(consumer_.mirror.digest(layer) == fresh.mirror.digest(layer));
    }
  }

 private:
  Vec2 place() {
    const double t = 6.283185307179586 * rng_.uniform();
    const double r = 100.0 + 10.0 * rng_.uniform();
    return {1.5 * r * std::cos(t), r * std::sin(t)};
  }
  void post(const DocumentDelta& delta) {
    document_.apply(delta);
    consumer_.graph.post(std::make_shared<const DocumentDelta>(delta));
  }
  void apply(const Expected<DocumentDelta>& delta) {
    REQUIRE(delta.has_value());
    if (delta->is_empty()) return;
    history_.record(*delta);
    post(*delta);
  }
  void choose_layers() {
    shown_.clear();
    for (const LayerIndex layer : all_layers())
      if (rng_.below(5) == 0 && layer_descriptors()[layer].id != "precision-difference") shown_.push_back(layer);
    consumer_.graph.set_demand(shown_);
  }

  Rng rng_;
  Document document_;
  History history_;
  ComputationSettings settings_;
  std::vector<LayerIndex> shown_;
  Consumer consumer_;
};

}  // namespace

TEST_CASE("a run that is stopped anywhere brings nothing, and the next brings everything") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Script script(seed);
    std::int64_t stops = 0;
    for (int step = 0; step < 10; ++step) {
      INFO("seed " << seed << " step " << step);
      script.act();
      std::int64_t look = 1;
      while (!script.run(look)) {
        ++look;
        ++stops;
      }
      script.check();
    }
    CHECK(stops > 100);
  }
}

TEST_CASE("things go on happening while runs are stopped") {
  for (std::uint64_t seed = 11; seed <= 30; ++seed) {
    Script script(seed);
    for (int step = 0; step < 60; ++step) {
      INFO("seed " << seed << " step " << step);
      // Several in one run, often; most runs are stopped, early ones more often than late ones.
      for (std::uint64_t i = script.rng().below(3); i != 0; --i) script.act();
      const auto look = static_cast<std::int64_t>(1 + script.rng().below(1 + script.rng().below(120)));
      if (script.run(look)) script.check();
      if (script.rng().below(6) != 0) continue;
      REQUIRE(script.run(kNever));
      script.check();
    }
    REQUIRE(script.run(kNever));
    script.check();
  }
}

TEST_CASE("what an earlier run changed is not reported again by a later one") {
  Consumer consumer;
  Document document;
  const auto post = [&](const Expected<DocumentDelta>& delta) {
    document.apply(*delta);
    consumer.graph.post(std::make_shared<const DocumentDelta>(*delta));
  };
  const std::vector<LayerIndex> shown{find_layer("delaunay")};
  const auto& delaunay = consumer.graph.structures().get<Delaunay>();
  post(replace_all(document, {.positions = {{0, 0}, {4, 0}, {0, 3}, {5, 7}}}));
  consumer.graph.set_demand(shown);
  REQUIRE(consumer.run(kNever));
  post(insert_samples(document, std::vector{Vec2{1, 1}}));
  REQUIRE(consumer.run(kNever));
  CHECK_FALSE(delaunay.face_changes().is_empty());
  // A run without the structure, and another that needs it and leaves it as it is.
  consumer.graph.set_demand(std::vector<LayerIndex>());
  REQUIRE(consumer.run(kNever));
  consumer.graph.set_demand(shown);
  REQUIRE(consumer.run(kNever));
  CHECK(delaunay.face_changes().is_empty());
}
