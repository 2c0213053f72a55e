// SPDX-License-Identifier: GPL-3.0-or-later
// Contours by way of the selection: one step of undo each, on the timeline, with their layer shown; the update that is
// held; handles of the frame.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/canvas/tools/select_tool.h"
#include "app/editing/curves/contour_commands.h"
#include "app/editing/source_selection.h"
#include "app/editing/update_hold.h"
#include "tests/support/bell.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using mes::test::Bell;

namespace {

struct ContourBench {
  LayerStack layers{layer_descriptors()};
  Editor editor{[](auto) {}, &layers};
  Bell bell;
  ContourCommands commands{editor, layers, bell.ring()};

  // A circle of 24 samples without a contour, and an open contour of five far from it.
  ContourBench() {
    SampleData data;
    for (int i = 0; i < 24; ++i)
      data.positions.push_back({std::cos(i * 2 * 3.14159265358979 / 24), std::sin(i * 2 * 3.14159265358979 / 24)});
    for (int i = 0; i < 5; ++i) data.positions.push_back({40 + 0.1 * i, 0.01 * i * i});
    data.contours = {{false, {24, 25, 26, 27, 28}}};
    REQUIRE(editor.load(data));
    editor.note_layers();
  }
  void select(std::initializer_list<std::uint32_t> rows) {
    editor.selection().clear();
    for (const std::uint32_t row : rows) editor.selection().add(SampleSlot(row));
  }
  const std::vector<CurveOrder::Contour>& contours() const { return editor.document().curve_order()->contours; }
  std::string finish() {
    std::string out;
    bell.wait_until([&] {
      const auto made = commands.follow();
      if (made && !*made) {
        REQUIRE(commands.is_under_way());
        return false;
      }
      out = made ? **made : made.error().text;
      return true;
    });
    return out;
  }
};

}  // namespace

TEST_CASE("a contour is closed in one step, with its layer, and undone with it") {
  ContourBench bench;
  const LayerIndex layer = find_layer("contours");
  REQUIRE_FALSE(bench.layers.is_visible(layer));
  bench.select({26});
  CHECK(bench.commands.change(ContourChange::close) == "Closed: the document has 1 contour");
  CHECK(bench.contours().front().closed);
  CHECK(bench.layers.is_visible(layer));
  CHECK(bench.editor.undo_name() == "Close contours");
  bench.editor.undo();
  CHECK_FALSE(bench.contours().front().closed);
  CHECK_FALSE(bench.layers.is_visible(layer));
  CHECK_FALSE(bench.editor.can_undo());
  bench.editor.redo();
  CHECK(bench.contours().front().closed);
  // Nothing to do: no step.
  const auto again = bench.commands.change(ContourChange::close);
  REQUIRE_FALSE(again);
  CHECK(again.error().text.starts_with("to close contours, select"));
}

TEST_CASE("chains of the crust become contours, in the place of those that share a sample") {
  ContourBench bench;
  bench.commands.begin_along_crust();
  CHECK(bench.finish() == "2 contours along the crust");
  REQUIRE(bench.contours().size() == 2);
  std::size_t closed = 0, samples = 0;
  for (const auto& contour : bench.contours()) {
    closed += contour.closed ? 1U : 0U;
    samples += contour.samples.size();
  }
  CHECK(closed == 1);
  CHECK(samples == 29);
  bench.commands.begin_along_crust();
  CHECK(bench.finish() == "The contours are the chains of the crust already");
  bench.editor.undo();
  bench.select({3});
  bench.commands.begin_along_crust();
  CHECK(bench.finish() == "1 contour along the crust");
  CHECK(bench.contours().size() == 2);
  CHECK(bench.contours().front().samples.size() == 5);
}

TEST_CASE("contours that were edited come back with the timeline") {
  ContourBench bench;
  bench.select({24, 25});
  REQUIRE(bench.commands.change(ContourChange::cut));
  bench.select({0, 25});
  REQUIRE(bench.commands.change(ContourChange::join));
  DocumentReplay replay;
  REQUIRE(replay.begin(*bench.editor.timeline().data()));
  for (const TimelineEntry& entry : bench.editor.timeline().entries()) REQUIRE(replay.apply(entry));
  REQUIRE(replay.document().curve_order()->contours.size() == bench.contours().size());
  const auto numbers = [](const Document& document) {
    std::vector<std::vector<std::uint32_t>> out;
    for (const auto& contour : document.curve_order()->contours) {
      out.emplace_back();
      for (const SampleId id : contour.samples) out.back().push_back(id.value - document.first_id().value);
    }
    return out;
  };
  CHECK(numbers(replay.document()) == numbers(bench.editor.document()));
  CHECK(numbers(bench.editor.document()) == std::vector<std::vector<std::uint32_t>>{{0, 25, 26, 27, 28}});
}

TEST_CASE("held changes reach the listener in order, a drag as one, and a replacement releases them") {
  std::vector<std::shared_ptr<const DocumentDelta>> heard;
  UpdateHold hold([&](auto delta) { heard.push_back(std::move(delta)); });
  Editor editor([&](auto delta) { hold.post(std::move(delta)); });
  REQUIRE(editor.load({.positions = {{0, 0}, {1, 0}, {2, 5}}}));
  REQUIRE(heard.size() == 1);
  hold.set_held(true);
  const SampleId moved = editor.document().id(SampleSlot(1));
  editor.begin_gesture("Move");
  for (int i = 1; i <= 100; ++i) REQUIRE(editor.move(std::vector{std::pair{moved, Vec2{1.0 + 0.01 * i, 0.0}}}, ""));
  editor.end_gesture();
  REQUIRE(editor.insert(std::vector{Vec2{7, 7}}, "Insert"));
  CHECK(heard.size() == 1);
  REQUIRE(hold.waiting().size() == 2);
  CHECK(hold.waiting().front()->edits.front().from == Vec2{1, 0});
  CHECK(hold.waiting().front()->edits.front().to == Vec2{2, 0});
  Document follower;
  follower.apply(*heard.front());
  hold.set_held(false);
  REQUIRE(heard.size() == 3);
  follower.apply(*heard[1]);
  follower.apply(*heard[2]);
  CHECK(follower.digest() == editor.document().digest());
  hold.set_held(true);
  REQUIRE(editor.insert(std::vector{Vec2{8, 8}}, "Insert"));
  REQUIRE(editor.load({.positions = {{5, 5}}}));
  CHECK_FALSE(hold.is_held());
  REQUIRE(heard.size() == 5);
  follower.apply(*heard[3]);
  follower.apply(*heard[4]);
  CHECK(follower.digest() == editor.document().digest());
}

TEST_CASE("what waits for lack of memory is passed on later") {
  int refusals = 1;
  std::vector<std::uint64_t> heard;
  UpdateHold hold([&](auto delta) {
    if (refusals-- > 0) throw std::bad_alloc();
    heard.push_back(delta->to_revision);
  });
  const auto delta = [](std::uint64_t revision) {
    auto out = std::make_shared<DocumentDelta>();
    out->from_revision = revision - 1;
    out->to_revision = revision;
    out->edits.push_back({});
    return out;
  };
  hold.set_held(true);
  hold.post(delta(1));
  hold.post(delta(2));
  CHECK_THROWS_AS(hold.set_held(false), std::bad_alloc);
  hold.post(delta(3));
  CHECK(heard == std::vector<std::uint64_t>{1, 2, 3});
}

TEST_CASE("a handle scales what is selected in one step, and turns it") {
  Editor editor([](auto) {});
  AnnotationEditor annotations{editor};
  double spacing = 10.0;
  const SelectionFrame frame{editor};
  const bool shows_frame = true;
  ToolContext context{editor, annotations, spacing, [](const Error& error) { FAIL(error.message()); }};
  context.frame = &frame;
  context.shows_frame = &shows_frame;
  REQUIRE(editor.load({.positions = {{0, 0}, {2, 0}, {2, 1}, {9, 9}}, .balls = {{{1, 1}, 0.5}}}));
  for (const std::uint32_t row : {0U, 1U, 2U}) editor.selection().add(SampleSlot(row));
  editor.selection().add_ball(BallSlot(0));
  constexpr double kUnits = 0.01;
  const auto at = [](Vec2 p) { return Pointer{{p.x / kUnits, -p.y / kUnits}, p, kUnits, {}}; };
  SelectTool tool(context);
  const auto drag = [&](Vec2 from, Vec2 to) {
    tool.hover(at(from));
    tool.press(at(from));
    tool.drag(at(0.5 * (from + to)));
    tool.drag(at(to));
    tool.release(at(to));
  };
  const auto handle = [&](Handle which) { return HandleFrame(*frame.box(), kUnits).at(which); };
  tool.hover(at(handle(Handle::right)));
  REQUIRE(tool.feedback().frame);
  CHECK(tool.feedback().frame->taken == Handle::right);
  drag(handle(Handle::right), handle(Handle::right) + Vec2{2, 0});
  CHECK(editor.document().position(SampleSlot(1)) == Vec2{4, 0});
  CHECK(editor.document().disk(BallSlot(0)).radius == 0.5);
  CHECK(editor.undo_name() == "Scale samples and ball");
  drag(handle(Handle::upper_right), handle(Handle::upper_right) + Vec2{4, 1});
  CHECK(editor.document().position(SampleSlot(2)).x == Approx(8));
  CHECK(editor.document().position(SampleSlot(2)).y == Approx(2));
  CHECK(editor.document().disk(BallSlot(0)).radius == Approx(1.0));
  editor.undo();
  editor.undo();
  CHECK(editor.document().position(SampleSlot(1)) == Vec2{2, 0});
  CHECK_FALSE(editor.can_undo());
  const Vec2 top = handle(Handle::turn);
  drag(top, Vec2{1 - (top.y - 0.5), 0.5});
  CHECK(editor.document().position(SampleSlot(0)).x == Approx(1.5));
  CHECK(editor.document().position(SampleSlot(0)).y == Approx(-0.5));
  CHECK(editor.undo_name() == "Turn samples and ball");
  editor.undo();
  // Cancelled, it leaves no trace; a sample outside of the frame is taken as ever.
  tool.press(at(handle(Handle::left)));
  tool.drag(at(handle(Handle::left) - Vec2{1, 0}));
  tool.cancel();
  CHECK(editor.document().position(SampleSlot(0)) == Vec2{0, 0});
  CHECK_FALSE(editor.can_undo());
  drag({9, 9}, {8, 8});
  CHECK(editor.document().position(SampleSlot(3)) == Vec2{8, 8});
}

TEST_CASE("what an element comes from is selected") {
  Editor editor([](auto) {});
  REQUIRE(
      editor.load({.positions = {{0, 0}, {2, 0}, {2, 1}, {2, 1}, {9, 9}}, .balls = {{{1, 1}, 0.5}, {{1, 1}, 2}}}));
  Provenance element;
  element.lines = {
      {ProvenanceRole::itself, "", {{PrimitiveKind::circle, {1, 1, 0.5}}}, false},
      {ProvenanceRole::origin, "", {{PrimitiveKind::point, {2, 1}}, {PrimitiveKind::point, {5, 5}}}, false},
      {ProvenanceRole::product, "", {{PrimitiveKind::segment, {0, 0, 9, 9}}}, false}};
  CHECK(select_sources(editor, element) == 3);
  CHECK(editor.selection().contains(SampleSlot(2)));
  CHECK(editor.selection().contains(SampleSlot(3)));
  CHECK(editor.selection().contains_ball(BallSlot(0)));
  element.lines = {{ProvenanceRole::origin, "", {{PrimitiveKind::point, {5, 5}}}, false}};
  CHECK(select_sources(editor, element) == 0);
  CHECK(editor.selection().size() == 3);
}
