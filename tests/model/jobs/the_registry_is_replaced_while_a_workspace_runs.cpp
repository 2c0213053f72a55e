// SPDX-License-Identifier: GPL-3.0-or-later
// A workspace whose registry is replaced shows what the new one has, keeps what the user chose for what it lacks, and lets
// jobs end that were begun with the one before.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/window/work/workspace.h"
#include "core/builtins/builtins.h"
#include "core/structures/inputs/samples.h"
#include "tests/support/added_to_registry.h"
#include "tests/support/bell.h"

using namespace mes;
using namespace mes::test;

namespace {

using SharedRegistry = std::shared_ptr<const Registry>;

SharedRegistry program() {
  return std::make_shared<const Registry>(builtins());
}
SharedRegistry with_additions(const Registry& to) {
  Registry out = to;
  add_additions(out);
  return std::make_shared<const Registry>(std::move(out));
}
SharedRegistry without_additions(const Registry& from) {
  Registry out = from;
  remove_additions(out);
  return std::make_shared<const Registry>(std::move(out));
}

/// A workspace with the samples of a corner, and what its engine has sent.
struct Running {
  Bell bell;
  Messages messages;
  Workspace work;
  LayerMirror mirror;

  explicit Running(SharedRegistry registry = program())
      : work(LiveRegistry(std::move(registry)), "assets", messages, bell.ring()) {
    REQUIRE(work.editor().load({.positions = {{0, 0}, {1, 0}, {0, 1}}}));
    follow();
  }
  /// A frame, and all that is computed for it.
  void follow() {
    work.follow_layers(false, true);
    while (auto patch = work.engine().sync()) {
      mirror.apply(*patch);
      work.engine().recycle(std::move(patch));
    }
  }
  LayerIndex added() const { return work.layers().find("doubled-points"); }
  /// Of the points in a layer.
  double largest(VariantLayer layer) const {
    const auto points = mirror.instances(layer, PrimitiveKind::point);
    REQUIRE(points.size() == 3 * stride_of(PrimitiveKind::point));
    return *std::ranges::max_element(points);
  }
  std::vector<Vec2> positions() const { return data_of(work.document()).positions; }
  void step_to(std::uint64_t k) {
    work.evolution().step_to(k);
    bell.wait_until([this] {
      work.evolution().follow(false, 0.0);
      return !work.evolution().is_waiting();
    });
    REQUIRE(work.evolution().position() == k);
  }
  void choose_evolution(std::string_view id) {
    const auto found = work.registry().evolutions().find(id);
    REQUIRE(found != nullptr);
    work.evolution().choose(found);
  }
};

bool names(const LayerConfiguration& layers, const std::string& id) {
  return std::ranges::count(layers.layers, id, &LayerConfiguration::Entry::layer) == 1;
}

}  // namespace

TEST_CASE("a workspace shows what its next registry has, loses it, and has it again as it was") {
  Running running;
  Workspace& work = running.work;
  REQUIRE(running.added() == kNoLayer);
  const std::string undo_name = work.editor().undo_name();

  const SharedRegistry larger = with_additions(work.registry());
  work.set_registry(larger);
  const LayerIndex added = running.added();
  REQUIRE(added != kNoLayer);
  CHECK(std::ranges::count(work.layers().order(), added) == 1);
  CHECK(std::ranges::count(work.computation().parameters(), kDoublingFactor) == 1);
  CHECK(work.computation().settings()[kDoublingFactor] == 2.0);
  CHECK(work.evolution().evolutions().back()->descriptor.id == "doubling");
  work.layers().set_visible(added, true);
  running.follow();
  CHECK(running.largest(added) == 2.0);

  LayerStyle style = work.layers().style(added);
  style.point_size_px = 17.0;
  work.layers().set_style(added, style);
  work.computation().set(kDoublingFactor, 3.0);
  work.panes().add(ParameterChoice{kDoublingFactor, 4.0});
  running.follow();
  CHECK(running.largest(added) == 3.0);
  CHECK(running.largest({1, added}) == 4.0);
  work.editor().note_layers();
  const std::string shown_name = work.editor().undo_name();
  CHECK(shown_name != undo_name);

  const SharedRegistry smaller = without_additions(*larger);
  work.set_registry(smaller);
  CHECK(running.added() == kNoLayer);
  CHECK(std::ranges::count(work.layers().order(), added) == 0);
  CHECK(work.computation().parameters().size() == builtins().parameters().size());
  running.follow();
  CHECK(work.is_complete());
  CHECK(std::ranges::count(work.shown_panes().demand, VariantLayer(added)) == 0);
  CHECK(work.shown_panes().variants.empty());
  // A session keeps all of it.
  const Session kept = work.session_for_picture("Kept", {}, {});
  CHECK(names(kept.layers, "doubled-points"));
  CHECK(kept.settings[kDoublingFactor] == 3.0);

  work.set_registry(with_additions(*smaller));
  CHECK(running.added() == added);
  CHECK(work.layers().is_visible(added));
  CHECK(work.layers().style(added) == style);
  CHECK(work.computation().settings()[kDoublingFactor] == 3.0);
  running.follow();
  CHECK(running.largest(added) == 3.0);
  CHECK(running.largest({1, added}) == 4.0);
  work.editor().note_layers();
  CHECK(work.editor().undo_name() == shown_name);
}

TEST_CASE("another registry is no step of undo, modifies no document, and leaves the bundle that is shown") {
  Running running;
  Workspace& work = running.work;
  work.editor().note_layers();
  work.editor().set_saved_layers(work.layers().configuration());
  REQUIRE(work.bundles().save("Corner"));
  REQUIRE_FALSE(work.editor().can_undo());
  REQUIRE_FALSE(work.editor().is_modified());
  const SharedRegistry larger = with_additions(work.registry());
  for (const SharedRegistry& next : {larger, without_additions(*larger)}) {
    work.set_registry(next);
    running.follow();
    work.editor().note_layers();
    CHECK_FALSE(work.editor().can_undo());
    CHECK_FALSE(work.editor().is_modified());
    REQUIRE(work.bundles().current());
    CHECK_FALSE(work.bundles().is_changed());
  }
  work.set_registry(with_additions(work.registry()));
  work.layers().set_visible(running.added(), true);
  CHECK(work.bundles().is_changed());
  CHECK(work.editor().is_modified());
  const SharedRegistry smaller = without_additions(work.registry());
  work.set_registry(smaller);
  CHECK(work.bundles().is_changed());
  CHECK(work.editor().is_modified());
}

TEST_CASE("an evolution that goes leaves the document in its state, and goes on when it is there again") {
  Running running;
  Workspace& work = running.work;
  const SharedRegistry larger = with_additions(work.registry());
  work.set_registry(larger);
  running.choose_evolution("doubling");
  work.evolution().set_value(kDoublingTimes, 3.0);
  running.step_to(2);
  const std::vector<Vec2> second{{0, 0}, {9, 0}, {0, 9}};
  CHECK(running.positions() == second);
  const std::string undo_name = work.editor().undo_name();

  const SharedRegistry smaller = without_additions(*larger);
  work.set_registry(smaller);
  CHECK(work.evolution().descriptor().is_missing);
  CHECK(work.evolution_now().id == "doubling");
  CHECK(work.evolution_now().step == 2);
  CHECK(running.positions() == second);
  work.evolution().step_to(3);
  const auto refused = work.evolution().take_problem();
  REQUIRE(refused);
  CHECK(refused->text == "the evolution doubling is not available here");
  CHECK(work.evolution().position() == 2);

  work.set_registry(with_additions(*smaller));
  CHECK_FALSE(work.evolution().descriptor().is_missing);
  CHECK(work.evolution().position() == 2);
  CHECK(work.editor().undo_name() == undo_name);
  running.step_to(3);
  CHECK(running.positions() == std::vector<Vec2>{{0, 0}, {27, 0}, {0, 27}});
  running.step_to(0);
  CHECK(running.positions() == std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}});
  CHECK_FALSE(work.editor().can_undo());
}

TEST_CASE("a parameter that an evolution moved has its steps when the evolution is there again") {
  Running running;
  Workspace& work = running.work;
  const auto all = work.registry().evolutions().all();
  const auto moving = std::ranges::find_if(all, [](const auto& one) { return one->moved_parameter() != nullptr; });
  REQUIRE(moving != all.end());
  const std::shared_ptr<const Evolution> evolution = *moving;
  const Parameter parameter = evolution->moved_parameter()->parameter;
  const double first = 0.5 * (parameter.default_value + 2.0);
  work.computation().set(parameter, first);
  work.evolution().choose(evolution);
  running.step_to(2);
  const double second = work.computation().settings()[parameter];
  CHECK(second != first);

  Registry changed = work.registry();
  REQUIRE(changed.evolutions().remove(evolution->descriptor.id));
  work.set_registry(std::make_shared<const Registry>(changed));
  CHECK(work.evolution().descriptor().is_missing);
  CHECK(work.evolution().position() == 2);
  CHECK(work.computation().settings()[parameter] == second);

  changed.evolutions().add(evolution->descriptor.id, evolution);
  work.set_registry(std::make_shared<const Registry>(changed));
  CHECK_FALSE(work.evolution().descriptor().is_missing);
  CHECK(work.evolution().position() == 2);
  running.step_to(0);
  CHECK(work.computation().settings()[parameter] == first);
}

TEST_CASE("a parameter that comes back with another range and default keeps what the user chose, within the range") {
  Running running;
  Workspace& work = running.work;
  Parameter reach{.id = "reach", .low = 0.0, .high = 10.0, .default_value = 2.0};
  Parameter depth{.id = "depth", .low = 0.0, .high = 10.0, .default_value = 2.0};
  const Registry without = work.registry();
  const auto take = [&] {
    Registry with = without;
    with.add_parameter(reach);
    with.add_parameter(depth);
    work.set_registry(std::make_shared<const Registry>(std::move(with)));
  };
  take();
  work.computation().set(reach, 8.0);
  work.panes().add(ParameterChoice{reach, 9.0});
  work.set_registry(std::make_shared<const Registry>(without));
  CHECK(work.computation().settings()[reach] == 8.0);
  reach.high = 5.0;
  reach.title = "How far";
  depth.default_value = 3.0;
  take();
  CHECK(work.computation().settings()[reach] == 5.0);
  CHECK(work.computation().settings()[depth] == 3.0);
  CHECK(std::get<ParameterChoice>(work.panes().panes().front()).value == 5.0);
  CHECK(words_of(work.panes().panes().front()) == "How far 5");
}

namespace {

/// What a job and the test say to each other.
struct Gate {
  std::atomic<bool> is_reached = false;
  std::atomic<bool> is_open = false;
  void open() {
    is_open = true;
    is_open.notify_all();
  }
};

/// Its computation waits at the gate.
class GatedSamples final : public Structure {
 public:
  GatedSamples(Samples& samples, std::shared_ptr<Gate> gate)
      : Structure("gated-samples", {&samples}), gate_(std::move(gate)) {}
  void rebuild(JobControl&) override {
    gate_->is_reached = true;
    gate_->is_reached.notify_all();
    gate_->is_open.wait(false);
  }
  bool update(JobControl&) override { return false; }
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override { return {{"gates", 1.0}}; }

 private:
  std::shared_ptr<Gate> gate_;
};

Layer make_gated_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  Layer layer;
  layer.descriptor = {.id = "gated-points", .name = "Gated points", .kinds = {PrimitiveKind::point}};
  layer.structures = {&samples, &set.get<GatedSamples>()};
  layer.parts.push_back(table_part(
      {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
      [&samples](SampleSlot row, Instance& out) {
        if (samples.is_alive(row)) out.point(samples.position(row));
      }));
  return layer;
}

}  // namespace

TEST_CASE("a job ends with the registry that it was begun with, and lets it go") {
  const auto gate = std::make_shared<Gate>();
  std::weak_ptr<const Registry> old;
  LayerIndex gated = kNoLayer;
  const auto with_gate = [&] {
    Registry registry = builtins();
    registry.add_structure(
        [gate](const StructureSet& set) { return std::make_unique<GatedSamples>(set.get<Samples>(), gate); });
    registry.add_layer(make_gated_layer);
    gated = registry.find_layer("gated-points");
    auto out = std::make_shared<const Registry>(std::move(registry));
    old = out;
    return out;
  };
  Running running(with_gate());
  // Before the workspace waits for its jobs.
  struct Opening {
    Gate& gate;
    ~Opening() { gate.open(); }
  } const opening{*gate};
  Workspace& work = running.work;
  ParameterSweep sweep;
  sweep.data = data_of(work.document());
  sweep.range.parameter = Parameter::a_scale;
  sweep.range.from = 1.0;
  sweep.range.to = 2.0;
  sweep.range.steps = 1;
  sweep.layers = {gated};
  work.insight().sweep.begin(std::move(sweep));
  gate->is_reached.wait(false);

  Registry without = work.registry();
  REQUIRE(without.remove_structure("gated-samples"));
  work.set_registry(std::make_shared<const Registry>(std::move(without)));
  running.follow();
  CHECK(work.layers().find("gated-points") == kNoLayer);
  CHECK(work.insight().sweep.is_under_way());
  // The job alone has it now.
  CHECK_FALSE(old.expired());

  gate->open();
  std::optional<Expected<std::string>> table;
  running.bell.wait_until([&] { return (table = work.insight().sweep.poll()).has_value(); });
  REQUIRE(*table);
  CHECK((**table).find("layers.gated-points.points") != std::string::npos);
  CHECK((**table).find("\n2,3,") != std::string::npos);
  CHECK(old.expired());
}
