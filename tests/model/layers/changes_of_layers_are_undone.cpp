// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>

#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "core/base/rng.h"
#include "core/io/session/session.h"
#include "tests/model/editing/random_editing.h"

using namespace mes;

namespace {

std::vector<LayerDescriptor> some_layers() {
  std::vector<LayerDescriptor> out;
  for (const std::string_view id : {"points", "curve", "voronoi", "delaunay", "image"}) {
    LayerDescriptor& layer = out.emplace_back();
    layer.id = layer.name = id;
    layer.visible_at_start = id == "points" || id == "curve";
    if (id != "image") layer.kinds = {PrimitiveKind::point};
  }
  return out;
}

constexpr LayerIndex kPoints = 0;
constexpr LayerIndex kCurve = 1;
constexpr LayerIndex kVoronoi = 2;
constexpr LayerIndex kDelaunay = 3;

struct LayerBench {
  std::vector<LayerDescriptor> descriptors = some_layers();
  LayerStack layers{descriptors};
  Editor editor{{}, &layers};

  LayerBench() {
    REQUIRE(editor.load({{{0, 0}, {1, 0}, {0, 1}}, {}, {}}));
    editor.note_layers();
  }
  void insert() { REQUIRE(editor.insert(std::array{Vec2{9, 9}}, "Insert")); }
  void widen(LayerIndex layer, double width) {
    LayerStyle style = layers.style(layer);
    style.line_width_px = width;
    layers.set_style(layer, style);
  }
  std::size_t samples() const { return editor.document().sample_count(); }
};

/// Everything that undo and redo can reach, of the document and of the layers.
struct State {
  std::uint64_t document = 0;
  LayerConfiguration layers{};
  std::string undo{};
  friend bool operator==(const State&, const State&) = default;
};
std::vector<State> reachable_states(Editor& editor, const LayerStack& layers) {
  std::vector<State> out;
  const auto look = [&] { out.push_back({editor.document().digest(), layers.configuration(), editor.undo_name()}); };
  look();
  while (editor.can_redo()) {
    editor.redo();
    look();
  }
  while (editor.can_undo()) {
    editor.undo();
    look();
  }
  return out;
}

void change_something(LayerStack& layers, Rng& random) {
  const auto layer = static_cast<LayerIndex>(random.below(layers.size()));
  const auto other = static_cast<LayerIndex>(random.below(layers.size()));
  LayerStyle style = layers.style(layer);
  switch (random.below(6)) {
    case 0: layers.set_visible(layer, !layers.is_visible(layer)); break;
    case 1: layers.move(layer, other, random.below(2) == 0); break;
    case 2:
      style.opacity = random.uniform();
      layers.set_style(layer, style);
      break;
    case 3:
      style.range_locked = true;
      style.range_high = 1.0 + random.uniform();
      layers.set_style(layer, style);
      break;
    case 4: layers.set_image({.file = std::to_string(random.below(3)) + ".png", .center = {}, .width = 1.0}); break;
    default: layers.reset();
  }
}

}  // namespace

TEST_CASE("a change of the layers is a step of undo with a name, among the edits") {
  LayerBench desk;
  CHECK_FALSE(desk.editor.can_undo());
  desk.layers.set_visible(kVoronoi, true);
  desk.editor.note_layers();
  CHECK(desk.editor.undo_name() == "Show voronoi");
  desk.insert();
  desk.widen(kCurve, 7.0);
  desk.editor.note_layers();
  CHECK(desk.editor.undo_name() == "Style of curve");
  const double width = desk.descriptors[kCurve].style.line_width_px;

  desk.editor.undo();
  CHECK(desk.layers.style(kCurve).line_width_px == width);
  CHECK(desk.samples() == 4);
  desk.editor.undo();
  CHECK(desk.samples() == 3);
  CHECK(desk.layers.is_visible(kVoronoi));
  desk.editor.undo();
  CHECK_FALSE(desk.layers.is_visible(kVoronoi));
  CHECK_FALSE(desk.editor.can_undo());
  CHECK(desk.editor.redo_name() == "Show voronoi");
  for (int i = 0; i < 3; ++i) desk.editor.redo();
  CHECK(desk.layers.is_visible(kVoronoi));
  CHECK(desk.samples() == 4);
  CHECK(desk.layers.style(kCurve).line_width_px == 7.0);
  CHECK_FALSE(desk.editor.can_redo());
}

TEST_CASE("what happens before the layers are at rest is one step, and an edit or undo ends it") {
  LayerBench desk;
  for (int i = 1; i <= 50; ++i) desk.widen(kCurve, i);
  desk.editor.note_layers();
  CHECK(desk.editor.timeline().entries().size() == 2);
  // No step was taken between these two.
  desk.layers.set_visible(kPoints, false);
  desk.insert();
  CHECK(desk.editor.undo_name() == "Insert");
  desk.editor.undo();
  CHECK(desk.editor.undo_name() == "Hide points");
  desk.layers.set_visible(kDelaunay, true);
  desk.editor.undo();
  CHECK_FALSE(desk.layers.is_visible(kDelaunay));
  CHECK_FALSE(desk.layers.is_visible(kPoints));
  // Nothing that lasts is no step.
  desk.layers.set_visible(kCurve, !desk.layers.is_visible(kCurve));
  desk.layers.set_visible(kCurve, !desk.layers.is_visible(kCurve));
  desk.editor.note_layers();
  CHECK(desk.editor.undo_name() == "Hide points");
}

TEST_CASE("steps are called what they do") {
  LayerBench desk;
  const auto name = [&](auto change) {
    change();
    desk.editor.note_layers();
    return desk.editor.undo_name();
  };
  LayerStack& layers = desk.layers;
  CHECK(name([&] { layers.set_visible(kVoronoi, true); }) == "Show voronoi");
  CHECK(name([&] {
          for (const LayerIndex layer : {kPoints, kCurve, kVoronoi}) layers.set_visible(layer, false);
        }) == "Hide 3 layers");
  CHECK(name([&] {
          LayerStyle style = layers.style(kVoronoi);
          style.color_map = "viridis";
          layers.set_style(kVoronoi, style);
        }) == "Colour map of voronoi");
  CHECK(name([&] { layers.move(kPoints, kDelaunay, true); }) == "Restack points");
  CHECK(name([&] {
          layers.set_image({.file = "a.png", .center = {}, .width = 1.0});
          layers.set_visible(4, true);
        }) == "Picture underneath");
  CHECK(name([&] { layers.set_image({.file = "a.png", .center = {1, 1}, .width = 1.0}); }) == "Place the picture");
  CHECK(name([&] { layers.set_image({}); }) == "Remove the picture");
  CHECK(name([&] { layers.reset(); }) == "Change layers");
  desk.editor.change_layers("Bundle \"Crust\"", [&] { layers.set_configuration({{{"curve", true, {}}}, {}}); });
  CHECK(desk.editor.undo_name() == "Bundle \"Crust\"");
}

TEST_CASE("a style made by hand is back after one undo of a bundle") {
  LayerBench desk;
  desk.widen(kCurve, 12.0);
  const LayerConfiguration by_hand = desk.layers.configuration();
  desk.editor.change_layers("Bundle", [&] { desk.layers.set_configuration({{{"voronoi", true, {}}}, {}}); });
  CHECK(desk.layers.configuration() != by_hand);
  desk.editor.undo();
  CHECK(desk.layers.configuration() == by_hand);
  CHECK(desk.editor.undo_name() == "Style of curve");
}

TEST_CASE("a change of the layers leaves edits that can be redone as they are") {
  LayerBench desk;
  desk.insert();
  desk.layers.set_visible(kVoronoi, true);
  desk.editor.note_layers();
  desk.insert();
  for (int i = 0; i < 3; ++i) desk.editor.undo();
  CHECK(desk.samples() == 3);
  desk.layers.set_visible(kDelaunay, true);
  desk.editor.note_layers();
  desk.editor.redo();
  desk.editor.redo();
  CHECK(desk.samples() == 5);
  CHECK_FALSE(desk.editor.can_redo());
  // What would be redone of the layers has gone, as it would with an edit.
  CHECK_FALSE(desk.layers.is_visible(kVoronoi));
  CHECK(desk.layers.is_visible(kDelaunay));
}

TEST_CASE("states of an evolution take each other's place below changes of layers") {
  LayerBench desk;
  const auto evolve = [&](double x) {
    REQUIRE(desk.editor.evolve(std::array{Vec2{x, 0}, Vec2{1, 0}, Vec2{0, 1}}, {}, "Evolve"));
  };
  const std::uint64_t beginning = desk.editor.document().digest();
  evolve(0.1);
  desk.layers.set_visible(kVoronoi, true);
  evolve(0.2);
  evolve(0.3);
  CHECK(desk.editor.document().position(SampleSlot(0)).x == 0.3);
  desk.editor.undo();
  CHECK(desk.editor.document().digest() == beginning);
  CHECK(desk.layers.is_visible(kVoronoi));
  CHECK(desk.editor.undo_name() == "Show voronoi");
  desk.editor.redo();
  desk.layers.set_visible(kDelaunay, true);
  // Back to the beginning, whatever was done to the layers.
  desk.editor.undo_edit();
  CHECK(desk.editor.document().digest() == beginning);
  CHECK(desk.layers.is_visible(kDelaunay));
}

TEST_CASE("what an edit shows is part of its step") {
  LayerBench desk;
  desk.insert();
  desk.layers.set_visible(kDelaunay, true);
  desk.editor.join_layers();
  desk.widen(kDelaunay, 3.0);
  desk.editor.join_layers();
  desk.editor.undo();
  CHECK(desk.samples() == 3);
  CHECK_FALSE(desk.layers.is_visible(kDelaunay));
  CHECK_FALSE(desk.editor.can_undo());
  desk.editor.redo();
  CHECK(desk.layers.is_visible(kDelaunay));
  CHECK(desk.layers.style(kDelaunay).line_width_px == 3.0);
}

TEST_CASE("a gesture that is cancelled leaves what was done to the layers meanwhile") {
  LayerBench desk;
  desk.editor.begin_gesture("Drag");
  desk.insert();
  desk.layers.set_visible(kDelaunay, true);
  desk.editor.join_layers();
  desk.layers.set_visible(kVoronoi, true);
  desk.editor.cancel_gesture();
  CHECK(desk.samples() == 3);
  CHECK(desk.layers.is_visible(kVoronoi));
  CHECK_FALSE(desk.layers.is_visible(kDelaunay));
  desk.editor.note_layers();
  CHECK(desk.editor.undo_name() == "Show voronoi");
}

TEST_CASE("changes of layers count as unsaved where a file holds them") {
  LayerBench desk;
  desk.layers.set_visible(kVoronoi, true);
  desk.editor.note_layers();
  CHECK_FALSE(desk.editor.is_modified());
  desk.editor.set_saved_layers(desk.layers.configuration());
  CHECK_FALSE(desk.editor.is_modified());
  desk.widen(kCurve, 5.0);
  CHECK(desk.editor.is_modified());
  desk.editor.undo();
  CHECK_FALSE(desk.editor.is_modified());
  desk.editor.undo();
  CHECK(desk.editor.is_modified());
  desk.editor.set_saved_layers(std::nullopt);
  CHECK_FALSE(desk.editor.is_modified());
  // Another document is in no file that would hold layers.
  desk.editor.set_saved_layers(desk.layers.configuration());
  desk.widen(kCurve, 6.0);
  CHECK(desk.editor.is_modified());
  REQUIRE(desk.editor.load({{{0, 0}}, {}, {}}));
  CHECK_FALSE(desk.editor.is_modified());
}

TEST_CASE("solo stays while styles are undone, and ends where a visibility is") {
  LayerBench desk;
  desk.layers.set_visible(kVoronoi, true);
  desk.editor.note_layers();
  desk.widen(kCurve, 5.0);
  desk.editor.note_layers();
  desk.layers.solo(kCurve);
  desk.editor.undo();
  CHECK(desk.layers.soloed() == kCurve);
  desk.editor.undo();
  CHECK(desk.layers.soloed() == kNoLayer);
}

TEST_CASE("a session brings changes of layers back with edits, for any order of them") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    LayerBench desk;
    test::RandomEditing script(seed);
    Rng random(seed + 100);
    REQUIRE(desk.editor.load(script.data()));
    desk.editor.note_layers();
    for (int i = 0; i < 300; ++i) {
      if (random.below(3) == 0) change_something(desk.layers, random);
      if (random.below(2) == 0) desk.editor.note_layers();
      if (random.below(20) == 0) desk.editor.join_layers();
      if (random.below(20) == 0 && !desk.editor.in_gesture()) desk.editor.undo_edit();
      script.step(desk.editor);
    }
    if (desk.editor.in_gesture()) desk.editor.end_gesture();
    desk.editor.note_layers();

    Session session;
    session.data = desk.editor.timeline().data();
    session.entries = desk.editor.timeline().entries();
    session.layers = desk.layers.configuration();
    const auto read = read_session(write_session(session), "a.json");
    REQUIRE(read);
    REQUIRE(read->entries == session.entries);

    // The entries alone say how the layers look, without any history.
    LayerConfiguration folded;
    for (const TimelineEntry& entry : read->entries)
      if (const auto* change = std::get_if<LayersChanged>(&entry)) apply(*change, folded);
    CHECK(folded == session.layers);

    LayerBench other;
    DocumentReplay replay(other.editor.document());
    REQUIRE(replay_session(*read, replay, "a.json"));
    other.editor.restore(std::move(replay), read->data, read->entries);
    other.layers.set_configuration(read->layers);
    other.editor.take_layers_as_noted();
    const auto there = reachable_states(other.editor, other.layers);
    const auto here = reachable_states(desk.editor, desk.layers);
    REQUIRE(there.size() == here.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
      INFO("seed " << seed << ", state " << i << ": " << here[i].undo << " and " << there[i].undo);
      REQUIRE(there[i] == here[i]);
    }
    CHECK(other.editor.document().digest() == desk.editor.document().digest());
  }
}

TEST_CASE("a journal of nothing but changes of layers is work that was left") {
  LayerBench desk;
  Session head;
  head.data = desk.editor.timeline().data();
  desk.editor.change_layers("Bundle", [&] { desk.layers.set_visible(kVoronoi, true); });
  std::string text = write_journal_head(head);
  for (const TimelineEntry& entry : desk.editor.timeline().entries()) text += write_journal_line(entry);
  const auto journal = read_journal(text, "a.journal");
  REQUIRE(journal);
  CHECK(journal->complaint.empty());
  CHECK(journal->unsaved_edits == 1);
  CHECK(journal->session.layers == desk.layers.configuration());
  const auto saved = read_journal(text + write_journal_saved(), "a.journal");
  REQUIRE(saved);
  CHECK(saved->unsaved_edits == 0);
}

TEST_CASE("entries of layers that make no sense are refused and change nothing") {
  using Role = LayersChanged::Role;
  DocumentReplay replay;
  REQUIRE(replay.begin({{{0, 0}, {1, 0}}, {}, {}}));
  const LayersChanged show{.changed = {{"curve", true, {}}}};
  const auto with = [&](Role role, bool has_back = true) {
    LayersChanged out = show;
    out.role = role;
    if (has_back) out.back = {show};
    return out;
  };
  CHECK_FALSE(replay.apply(with(Role::undone)));
  CHECK_FALSE(replay.apply(with(Role::redone)));
  CHECK_FALSE(replay.apply(with(Role::joined)));
  CHECK_FALSE(replay.apply(with(Role::step, false)));
  CHECK(replay.history().step_count() == 0);
  REQUIRE(replay.apply(with(Role::step)));
  CHECK_FALSE(replay.apply(Undone{}));
  REQUIRE(replay.apply(with(Role::undone)));
  CHECK_FALSE(replay.apply(Redone{}));
  REQUIRE(replay.apply(with(Role::redone)));
  REQUIRE(replay.apply(GestureBegun{"A"}));
  CHECK_FALSE(replay.apply(with(Role::step)));
}
