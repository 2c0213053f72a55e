// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is made of, with a registry that has more than the program, or less: what was added is listed, shown and
// computed like the program's own, and what is missing is left out.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/first_ball.h"
#include "app/editing/selection_commands.h"
#include "app/export/geometry_export.h"
#include "app/insight/computation_control.h"
#include "app/insight/parameter_sweep.h"
#include "app/layers/changed_parameters.h"
#include "app/layers/empty_view.h"
#include "app/layers/layer_list.h"
#include "app/panes/engine_demand.h"
#include "app/playing/lesson_walk.h"
#include "app/playing/player.h"
#include "app/playing/session_evolution.h"
#include "app/store/document_files.h"
#include "app/store/file_conflict.h"
#include "app/store/lessons.h"
#include "app/store/looks/bundles.h"
#include "app/store/trace_job.h"
#include "core/builtins/builtins.h"
#include "core/graph/live_registry.h"
#include "core/io/format_spec.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/added_to_registry.h"
#include "tests/support/bell.h"

using namespace mes;
using namespace mes::test;

namespace {

const SampleData kCorner{.positions = {{0, 0}, {1, 0}, {0, 1}}};

LayerIndex added_layer() {
  return registry_with_additions().find_layer("doubled-points");
}

LayerStack showing_added_layer() {
  LayerStack out(registry_with_additions().layers());
  LayerConfiguration alone;
  alone.layers.push_back({"doubled-points", true, {}});
  out.set_configuration(alone);
  return out;
}

/// A session that shows the added layer, and in which a sample is inserted.
Session session_with_addition() {
  Session out;
  out.title = "Additions";
  out.data = std::make_shared<const SampleData>(kCorner);
  out.entries = {TimelineEdit{.name = "Insert", .inserted = {{1, 1}}}};
  out.layers = showing_added_layer().configuration();
  out.settings[kDoublingFactor] = 3.0;
  return out;
}

}  // namespace

TEST_CASE("a layer that was added is in the stack, in its list, and among those that bundles know") {
  const Registry& registry = registry_with_additions();
  const LayerStack layers(registry.layers());
  REQUIRE(layers.find("doubled-points") == added_layer());
  CHECK(layers.size() == builtins().layers().size() + 1);
  CHECK(LayerStack(builtins().layers()).find("doubled-points") == kNoLayer);
  const LayerListing listing = list_layers(layers, {.search = "doubled"});
  REQUIRE(listing.listed == 1);
  CHECK(listing.sections.front().rows == std::vector{added_layer()});
  CHECK(std::ranges::count(known_layers(registry.layers()), std::string("doubled-points"), &KnownLayer::id) == 1);
  CHECK(showing_added_layer().visible_layers() == std::vector{added_layer()});
  CHECK(showing_added_layer().missing_count() == 0);
}

TEST_CASE("a parameter that was added is among those of the panels, and named when it is changed") {
  const Registry& registry = registry_with_additions();
  Engine engine(registry, {});
  ComputationControl control(registry, engine);
  CHECK(std::ranges::count(control.parameters(), kDoublingFactor) == 1);
  control.set(kDoublingFactor, 3.0);
  const auto changed = changed_parameters(control.parameters(), control.settings());
  REQUIRE(changed.size() == 1);
  CHECK(changed.front().text == "Doubling factor 3");
  CHECK(changed_parameters(builtins().parameters(), control.settings()).empty());
}

TEST_CASE("an evolution that was added is chosen by a session, and missing elsewhere") {
  const SessionEvolution saved{.id = "doubling", .seed = 3, .step = 2, .parameters = {{"doubling-times", 4.0}}};
  const EvolutionChoice choice = choice_of(registry_with_additions(), saved);
  CHECK_FALSE(choice.evolution->descriptor.is_missing);
  CHECK(choice.values[kDoublingTimes] == 4.0);
  const SessionEvolution again = session_evolution(registry_with_additions(), choice, 2);
  CHECK(again.id == "doubling");
  CHECK(std::ranges::count(again.parameters, std::pair(std::string("doubling-times"), 4.0)) == 1);
  CHECK(choice_of(builtins(), saved).evolution->descriptor.is_missing);
}

TEST_CASE("a pane with another value of an added parameter has an added layer of its own") {
  PaneList list;
  list.add(ParameterChoice{kDoublingFactor, 3.0});
  const ShownPanes shown = shown_panes(registry_with_additions(), list, showing_added_layer(), {});
  REQUIRE(shown.variants.size() == 1);
  CHECK(shown.variants.front().settings[kDoublingFactor] == 3.0);
  CHECK(shown.demand == std::vector<VariantLayer>{added_layer(), {1, added_layer()}});
}

TEST_CASE("geometry and tables of what was added are computed aside") {
  const Registry& registry = registry_with_additions();
  const auto text = compute_layer_text(registry, kCorner, *find_layer_text_format("csv"),
                                       {.layers = {added_layer()}, .settings = {}, .on_patch = {}});
  REQUIRE(text);
  CHECK(text->text == "x,y\n0,0\n2,0\n0,2\n");
  CHECK_FALSE(find_layer_text_format("wpoff")->holds(registry.layers()[added_layer()]));
  ParameterSweep sweep;
  sweep.data = kCorner;
  sweep.range.parameter = kDoublingFactor;
  sweep.range.from = 1.0;
  sweep.range.to = 2.0;
  sweep.range.steps = 1;
  sweep.layers = {added_layer()};
  JobControl job;
  const auto table = sweep_as_csv(registry, sweep, {}, job);
  REQUIRE(table);
  CHECK(table->starts_with("doubling-factor,layers.doubled-points.points,"));
  CHECK(table->find("\n2,3,") != std::string::npos);
}

TEST_CASE("a session with a layer that was added is played, and its lesson shows it") {
  Session session = session_with_addition();
  LayerMirror mirror;
  Player player(registry_with_additions(), session, [&mirror](const FramePatch& patch) { mirror.apply(patch); });
  for (const PlayStep& step : player.steps()) {
    REQUIRE(player.apply(step));
    CHECK(player.complete().empty());
  }
  CHECK(player.layers().visible_layers() == std::vector{added_layer()});
  CHECK(mirror.count(added_layer(), PrimitiveKind::point) == 4);
  session.lesson.steps = {{.caption = "After", .position = 1}};
  LessonWalk walk(registry_with_additions(), session);
  const auto scene = walk.scene(0);
  REQUIRE(scene);
  CHECK(scene->layers.visible_layers() == std::vector{added_layer()});
  CHECK(scene->data.positions.size() == 4);
}

TEST_CASE("layers of the program that a registry lacks are left out") {
  const Registry& registry = registry_of_one_layer();
  LayerStack layers(registry.layers());
  REQUIRE(layers.size() == 1);
  Engine engine(registry, {});
  Editor editor([&](std::shared_ptr<const DocumentDelta> delta) { engine.post(std::move(delta)); }, &layers);
  REQUIRE(editor.load({.positions = kCorner.positions, .balls = {{{0, 0}, 1.0}}}));
  FirstBall().follow(editor, layers);
  show_instead(ShowInstead::own_family, layers);
  layers.set_visible(0, true);
  // The density, which no layer shows here, is looked at.
  PaneList list;
  list.add(FamilyKind::polar);
  list.add(ParameterChoice{kDoublingFactor, 3.0});
  const ComputationSettings settings;
  EngineDemand demand;
  EngineDemand::Wanted wanted{registry, layers, list, settings, editor.document().revision()};
  wanted.with_density = true;
  CHECK(demand.follow(engine, wanted, false));
  LayerMirror mirror;
  while (auto patch = engine.sync()) {
    mirror.apply(*patch);
    engine.recycle(std::move(patch));
  }
  CHECK(mirror.count(LayerIndex{0}, PrimitiveKind::point) == 3);
  CHECK(mirror.count({1, 0}, PrimitiveKind::point) == 3);
  CHECK(layers_for(registry, *find_layer_text_format("npoff"), {0}) == std::vector<LayerIndex>{0});
  const LayerConfiguration unknown{.layers = {{"a-v-points", true, {}}}};
  CHECK(in_family(registry.layers(), unknown, FamilyKind::own) == unknown);
  CHECK_FALSE(family_of(registry.layers(), unknown));
  CHECK(choice_of(registry, {}).evolution->descriptor.is_missing);
}

TEST_CASE("parameters of a session that were added have values in their range, in panes too") {
  PaneList list;
  list.add(ParameterChoice{{.id = "doubling-factor", .low = -1e300, .high = 1e300}, 99.0});
  const std::uint64_t revision = list.revision();
  list.resolve(builtins());
  CHECK(list.revision() == revision);
  CHECK(words_of(list.panes().front()) == "Doubling factor 99");
  list.resolve(registry_with_additions());
  CHECK(list.revision() != revision);
  CHECK(words_of(list.panes().front()) == "Doubling factor 10");
  Engine engine(registry_with_additions(), {});
  ComputationControl control(registry_with_additions(), engine);
  ComputationSettings read;
  read.values.keep("doubling-factor", 99.0);
  read.values.keep("not-known", 99.0);
  control.set(read);
  const auto changed = control.settings().values.changed();
  REQUIRE(changed.size() == 2);
  CHECK(changed[0].id == "doubling-factor");
  CHECK(changed[0].value == 10.0);
  CHECK(changed[1].value == 99.0);
}

TEST_CASE("a lesson shows the layers of the present registry") {
  LiveRegistry registry{builtins()};
  Session session = session_with_addition();
  session.lesson.steps = {{.caption = "After", .position = 1}};
  LessonWalk walk(registry, session);
  const auto before = walk.scene(0);
  REQUIRE(before);
  CHECK(before->layers.visible_layers().empty());
  registry.set(std::make_shared<const Registry>(registry_with_additions()));
  const auto after = walk.scene(0);
  REQUIRE(after);
  CHECK(after->layers.visible_layers() == std::vector{added_layer()});
  CHECK(after->data.positions == before->data.positions);
}

TEST_CASE("files and pasted text are read by the formats of the present registry") {
  const TemporaryFolder folder;
  const auto file = folder.write("corner.three", "three 0 0 1 0 0 1");
  LiveRegistry registry{builtins()};
  Bell bell;
  Editor editor{{}};
  DocumentFiles files(
      registry, editor, [] { return Session(); }, bell.ring());
  SelectionCommands commands(registry, editor);
  TraceJob tracing(registry, bell.ring());
  const auto opened = [&] {
    files.open(file);
    std::optional<DocumentFiles::Outcome> outcome;
    bell.wait_until([&] { return (outcome = files.poll()).has_value(); });
    return !outcome->error;
  };
  const auto traced = [&] {
    tracing.begin(file);
    tracing.trace({});
    std::optional<Expected<TraceJob::Samples>> samples;
    bell.wait_until([&] { return (samples = tracing.poll_samples()).has_value(); });
    return *samples && (*samples)->data.positions == kCorner.positions;
  };
  const auto holdings = [&] { return look_into(file, {}, nullptr, registry.now().formats()).theirs; };
  const ShippedLesson lesson{file, "three", "Three"};
  const auto refusal = [&] { return session_of(registry.now(), lesson, {}).error().text; };
  CHECK_FALSE(opened());
  CHECK_FALSE(commands.paste("three 0 0 1 0 0 1", {1, 0}, MapDegrees::projected));
  CHECK_FALSE(traced());
  CHECK_FALSE(holdings());
  CHECK(refusal() != "this is not a session but three");

  Registry with = builtins();
  const auto read = [](std::string_view, const std::string&, ReadJob&) -> Expected<LoadedFile> {
    return LoadedFile{.data = kCorner, .format = {}, .warnings = {}, .session = nullptr};
  };
  Format three;
  three.descriptor = {.id = "three", .name = "Three", .extensions = {".three"}, .can_read = true};
  three.match = [](std::string_view bytes) { return bytes.starts_with("three ") ? Match::surely : Match::no; };
  three.read = read;
  with.formats().add("three", std::make_shared<const Format>(three));
  // What is traced is read as a picture.
  REQUIRE(with.formats().remove("picture"));
  Format picture = three;
  picture.descriptor.id = "picture";
  picture.read_traced = [read](std::string_view bytes, const std::string& name, const TraceRequest&, ReadJob& job) {
    return read(bytes, name, job);
  };
  with.formats().add("picture", std::make_shared<const Format>(picture));
  registry.set(std::make_shared<const Registry>(with));
  CHECK(opened());
  CHECK(editor.document().sample_count() == 3);
  CHECK(commands.paste("three 0 0 1 0 0 1", {1, 0}, MapDegrees::projected));
  CHECK(editor.document().sample_count() == 6);
  CHECK(traced());
  REQUIRE(holdings());
  CHECK(holdings()->samples == 3);
  CHECK(refusal() == "this is not a session but three");
}
