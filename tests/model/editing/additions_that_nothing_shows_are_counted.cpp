// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>

#include "app/editing/editor.h"
#include "app/editing/hidden_additions.h"
#include "app/layers/ball_families.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

TEST_CASE("samples that are added while no layer shows samples are counted until one does") {
  LayerStack layers(layer_descriptors());
  const LayerIndex points = layers.find("points");
  Editor editor({});
  HiddenAdditions hidden;
  const auto follow = [&] {
    hidden.follow(editor.document(), layers, true);
    return hidden.count(AddedKind::samples);
  };
  REQUIRE(editor.load({.positions = {{0, 0}, {1, 0}}}));
  layers.set_visible(points, false);
  hidden.begin(editor.document());
  // Samples that came with the document are not news.
  CHECK(follow() == 0);
  REQUIRE(editor.insert(std::array{Vec2{2, 3}}, "Insert"));
  CHECK(follow() == 1);
  REQUIRE(editor.insert(std::array{Vec2{4, 3}, Vec2{5, 3}}, "Spray"));
  CHECK(follow() == 3);
  editor.undo();
  CHECK(follow() == 1);
  editor.undo();
  CHECK(follow() == 0);
  editor.redo();
  CHECK(follow() == 1);
  // Shown in any way, it is known.
  layers.set_visible(points, true);
  CHECK(follow() == 0);
  layers.set_visible(points, false);
  CHECK(follow() == 0);
  editor.redo();
  CHECK(follow() == 2);
  layers.solo(points);
  CHECK(follow() == 0);
  layers.end_solo();
  // Closed, it is not said once more, but for another document.
  REQUIRE(editor.insert(std::array{Vec2{6, 3}}, "Insert"));
  CHECK(follow() == 1);
  hidden.dismiss(AddedKind::samples);
  REQUIRE(editor.insert(std::array{Vec2{7, 3}}, "Insert"));
  CHECK(follow() == 0);
  hidden.begin(editor.document());
  REQUIRE(editor.insert(std::array{Vec2{8, 3}}, "Insert"));
  CHECK(follow() == 1);
  // Removing earlier samples does not make the count negative.
  REQUIRE(editor.load({}));
  CHECK(follow() == 0);
}

TEST_CASE("balls and annotations that are added while they are hidden are counted, each for themselves") {
  LayerStack layers(layer_descriptors());
  Editor editor({});
  HiddenAdditions hidden;
  bool shows_annotations = false;
  const auto follow = [&](AddedKind kind) {
    hidden.follow(editor.document(), layers, shows_annotations);
    return hidden.count(kind);
  };
  for (const char* const id : {"b-inner-disks", "b-inner-circles", "b-inner-centers"})
    layers.set_visible(layers.find(id), false);
  hidden.begin(editor.document());
  REQUIRE(editor.insert_balls(std::array{Disk{{0, 0}, 1}, Disk{{3, 0}, 1}}, "Insert"));
  CHECK(follow(AddedKind::balls) == 2);
  REQUIRE(editor.annotate({{.text = "here", .anchors = {{.at = {0, 0}}}}}, "Annotate"));
  CHECK(follow(AddedKind::annotations) == 1);
  CHECK(follow(AddedKind::balls) == 2);
  CHECK(follow(AddedKind::samples) == 0);
  hidden.dismiss(AddedKind::annotations);
  CHECK(follow(AddedKind::annotations) == 0);
  // One of the layers is enough.
  layers.set_visible(layers.find("b-inner-circles"), true);
  CHECK(follow(AddedKind::balls) == 0);
  layers.set_visible(layers.find("b-inner-circles"), false);
  CHECK(follow(AddedKind::balls) == 0);
  shows_annotations = true;
  CHECK(follow(AddedKind::annotations) == 0);
  shows_annotations = false;
  editor.undo();
  REQUIRE(editor.annotate({{.text = "there", .anchors = {{.at = {0, 0}}}}}, "Annotate"));
  CHECK(follow(AddedKind::annotations) == 0);
  hidden.begin(editor.document());
  editor.undo();
  CHECK(follow(AddedKind::annotations) == 0);
  editor.redo();
  CHECK(follow(AddedKind::annotations) == 1);
}

TEST_CASE("a click takes samples and balls that are seen, and hidden ones only while they are selected") {
  LayerStack layers(layer_descriptors());
  const LayerIndex points = layers.find("points");
  Editor editor({});
  REQUIRE(editor.load({.positions = {{0, 0}, {4, 0}}, .balls = {{{0.5, 0}, 0.25}}}));
  const SampleSlot first{0};
  const auto taken = [&](Vec2 p) { return seen_thing_at(editor, layers, p, 1.0); };
  const auto show_balls = [&](bool are_shown) {
    for (const std::string_view id : kOwnBallLayers) layers.set_visible(layers.find(id), are_shown);
  };
  layers.set_visible(points, true);
  show_balls(true);
  CHECK(taken({0.1, 0}).sample == first);
  CHECK(taken({0.5, 0}).ball == BallSlot{0});
  layers.set_visible(points, false);
  CHECK(taken({0.1, 0}).ball == BallSlot{0});
  CHECK_FALSE(taken({4, 0}).is_any());
  show_balls(false);
  CHECK_FALSE(taken({0.1, 0}).is_any());
  editor.selection().add(first);
  CHECK(taken({0.1, 0}).sample == first);
  CHECK_FALSE(taken({4, 0}).is_any());
  layers.set_visible(points, true);
  CHECK(taken({4, 0}).sample == SampleSlot{1});
}
