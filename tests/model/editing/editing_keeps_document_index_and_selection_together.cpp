// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <limits>

#include "app/editing/editor.h"

using namespace mes;

namespace {

constexpr std::array<Vec2, 3> kThree{{{0, 0}, {1, 0}, {0, 1}}};

}  // namespace

TEST_CASE("the listener hears every change once and can rebuild the document from it") {
  Document copy;
  Editor editor([&copy](const std::shared_ptr<const DocumentDelta>& delta) { copy.apply(*delta); });
  REQUIRE(editor.load({{kThree.begin(), kThree.end()}, {}}));
  REQUIRE(editor.insert(std::array{Vec2{5, 5}, Vec2{6, 6}}, "insert"));
  editor.selection().add(SampleSlot(0));
  REQUIRE(editor.nudge_selection({1, 0}));
  REQUIRE(editor.remove_selection());
  editor.undo();
  editor.undo();
  editor.redo();
  CHECK(copy.digest() == editor.document().digest());
  CHECK(copy.sample_count() == 5);
}

TEST_CASE("a refused command changes nothing and makes no step") {
  Editor editor({});
  REQUIRE(editor.load({{kThree.begin(), kThree.end()}, {}}));
  const auto digest = editor.document().digest();
  CHECK_FALSE(editor.insert(std::array{Vec2{std::numeric_limits<double>::infinity(), 0}}, "insert"));
  CHECK_FALSE(editor.remove(std::array{SampleId{99}}, "remove"));
  CHECK(editor.document().digest() == digest);
  CHECK_FALSE(editor.can_undo());
  CHECK_FALSE(editor.is_modified());
}

TEST_CASE("modified means: another state than the saved one") {
  Editor editor({});
  REQUIRE(editor.load({{kThree.begin(), kThree.end()}, {}}));
  CHECK_FALSE(editor.is_modified());
  REQUIRE(editor.insert(std::array{Vec2{5, 5}}, "insert"));
  CHECK(editor.is_modified());
  editor.undo();
  CHECK_FALSE(editor.is_modified());
  editor.redo();
  editor.mark_saved();
  CHECK_FALSE(editor.is_modified());
  editor.undo();
  CHECK(editor.is_modified());
  // Another step in the place of the saved one is another state, though the history is as long.
  REQUIRE(editor.insert(std::array{Vec2{7, 7}}, "insert"));
  CHECK(editor.is_modified());
}

TEST_CASE("a removed sample leaves the selection") {
  Editor editor({});
  REQUIRE(editor.load({{kThree.begin(), kThree.end()}, {}}));
  editor.selection().select_all(editor.document());
  CHECK(editor.selection().size() == 3);
  REQUIRE(editor.remove(std::array{editor.document().id(SampleSlot(1))}, "remove"));
  CHECK(editor.selection().size() == 2);
  editor.undo();
  CHECK(editor.document().sample_count() == 3);
  CHECK(editor.selection().size() == 2);
  editor.selection().invert(editor.document());
  CHECK(editor.selection().slots() == std::vector{SampleSlot(1)});
  REQUIRE(editor.load({{kThree.begin(), kThree.end()}, {}}));
  CHECK(editor.selection().is_empty());
}

TEST_CASE("a cancelled gesture leaves neither change nor step") {
  Editor editor({});
  REQUIRE(editor.load({{kThree.begin(), kThree.end()}, {}}));
  const auto digest = editor.document().digest();
  editor.begin_gesture("Spray");
  REQUIRE(editor.insert(std::array{Vec2{5, 5}}, {}));
  REQUIRE(editor.insert(std::array{Vec2{6, 5}}, {}));
  editor.cancel_gesture();
  CHECK(editor.document().digest() == digest);
  CHECK_FALSE(editor.can_undo());
  editor.begin_gesture("Nothing");
  editor.cancel_gesture();
  CHECK_FALSE(editor.can_undo());
}
