// SPDX-License-Identifier: GPL-3.0-or-later
// The annotation tool and the editor of annotations: what clicks and drags make, how many steps of undo they are, and what
// they follow.
#include <catch2/catch.hpp>

#include "app/canvas/canvas.h"
#include "app/canvas/tools/annotate_tool.h"
#include "app/canvas/tools/measure_tool.h"
#include "core/io/session/session.h"
#include "tests/model/editing/tool_hand.h"

using namespace mes;
using mes::test::at_pixel;

namespace {

struct AnnotationBench {
  Editor editor{{}};
  double spacing = 10.0;
  int refused = 0;
  AnnotationEditor annotations{editor};
  std::optional<std::size_t> under_pointer{};
  ToolContext context{
      editor, annotations, spacing, [this](const Error&) { ++refused; }, {}, [this](Vec2) { return under_pointer; }};
  AnnotateTool tool{context};

  // Two samples on a horizontal line, one below: the centre of their circle is at (150, 150).
  AnnotationBench() {
    REQUIRE(
        editor.load({.positions = {at_pixel(100, 100).world, at_pixel(200, 100).world, at_pixel(200, 200).world}}));
  }
  void drag(const Pointer& from, const Pointer& to) {
    tool.hover(from);
    tool.press(from);
    for (int i = 1; i <= 4; ++i)
      tool.drag(at_pixel(from.px.x + 0.25 * i * (to.px.x - from.px.x), from.px.y + 0.25 * i * (to.px.y - from.px.y)));
    tool.release(to);
    CHECK_FALSE(tool.is_active());
    CHECK_FALSE(editor.in_gesture());
  }
  void click(const Pointer& pointer) { drag(pointer, pointer); }
  void write(const std::string& text) {
    REQUIRE(annotations.current() != nullptr);
    Annotation changed = *annotations.current();
    changed.text = text;
    REQUIRE(annotations.change(changed));
  }
  const Annotations& all() const { return *editor.document().annotations(); }
  Vec2 place(std::size_t i, std::size_t anchor = 0) const {
    return editor.document().place_of(all()[i].anchors[anchor]);
  }
  void move_sample(std::uint32_t number, Vec2 to) {
    const SampleId id{editor.document().first_id().value + number};
    REQUIRE(editor.move(std::array{std::pair{id, to}}, "Move"));
  }
};

}  // namespace

TEST_CASE("a click is where words begin, and writing them is one step") {
  AnnotationBench bench;
  bench.click(at_pixel(400, 300));
  REQUIRE(bench.annotations.is_draft());
  CHECK(bench.all().empty());
  CHECK_FALSE(bench.editor.can_undo());
  for (const char* words : {"c", "cr", "cru", "crust"}) bench.write(words);
  REQUIRE(bench.all().size() == 1);
  CHECK(bench.all()[0].text == "crust");
  CHECK(bench.all()[0].kind == AnnotationKind::text);
  CHECK(bench.place(0) == at_pixel(400, 300).world);
  CHECK(bench.annotations.close());
  CHECK(bench.editor.undo_name() == "Annotate");
  bench.editor.undo();
  CHECK(bench.all().empty());
  CHECK_FALSE(bench.editor.can_undo());
  bench.editor.redo();
  CHECK(bench.all()[0].text == "crust");

  // What is changed later is one more step, however many letters.
  bench.annotations.select(0);
  for (const char* words : {"crus", "crusts"}) bench.write(words);
  bench.annotations.close();
  CHECK(bench.editor.undo_name() == "Change annotation");
  bench.editor.undo();
  CHECK(bench.all()[0].text == "crust");
}

TEST_CASE("words that are taken back leave nothing") {
  AnnotationBench bench;
  bench.click(at_pixel(400, 300));
  bench.annotations.close();
  CHECK(bench.all().empty());
  bench.click(at_pixel(400, 300));
  bench.write("a");
  bench.write("");
  bench.annotations.close();
  CHECK(bench.all().empty());
  CHECK_FALSE(bench.editor.can_undo());
  // Of an older one, deleting is a step of its own.
  bench.click(at_pixel(400, 300));
  bench.write("older");
  bench.annotations.close();
  bench.annotations.select(0);
  bench.write(" ");
  bench.annotations.close();
  CHECK(bench.all().empty());
  bench.editor.undo();
  bench.editor.undo();
  CHECK(bench.all()[0].text == "older");
}

TEST_CASE("what begins on a sample or a vertex follows it") {
  AnnotationBench bench;
  bench.click(at_pixel(103, 101));
  bench.write("sample");
  bench.drag(at_pixel(150, 152), at_pixel(300, 40));
  bench.write("vertex");
  bench.annotations.close();
  REQUIRE(bench.all().size() == 2);
  CHECK(bench.all()[0].kind == AnnotationKind::leader);
  CHECK(bench.all()[0].anchors[0].samples == std::vector<std::uint32_t>{0});
  CHECK(bench.all()[1].kind == AnnotationKind::leader);
  CHECK(bench.all()[1].anchors[0].samples.size() == 3);
  CHECK(bench.all()[1].shift == Vec2{150, -112});
  CHECK(bench.place(1) == at_pixel(150, 150).world);
  bench.move_sample(0, at_pixel(100, 200).world);
  CHECK(bench.place(0) == at_pixel(100, 200).world);
  CHECK(bench.place(1) == at_pixel(150, 150).world);
  bench.move_sample(1, at_pixel(200, 400).world);
  CHECK(bench.place(1) == at_pixel(150, 300).world);
}

TEST_CASE("a circle with a sample inside has no vertex at its centre") {
  AnnotationBench bench;
  CHECK(bench.annotations.anchor_at(at_pixel(152, 149).world, 4.5, true).samples.size() == 3);
  CHECK(bench.annotations.anchor_at(at_pixel(152, 149).world, 4.5, false).samples.empty());
  REQUIRE(bench.editor.insert(std::array{at_pixel(150, 90).world}, "Insert"));
  CHECK(bench.annotations.anchor_at(at_pixel(152, 149).world, 4.5, true).samples.empty());
  // Nothing is near, and nothing is there at all.
  CHECK(bench.annotations.anchor_at({1e30, 1e30}, 4.5, true).samples.empty());
  // Among more samples than can be searched while the pointer moves there are none either.
  SampleData many{.positions = {at_pixel(100, 100).world, at_pixel(200, 100).world, at_pixel(200, 200).world}};
  for (int i = 0; i <= 20'000; ++i) many.positions.push_back({1e4 + i, 1e4});
  REQUIRE(bench.editor.load(many));
  CHECK(bench.annotations.anchor_at(at_pixel(152, 149).world, 4.5, true).samples.empty());
  CHECK(bench.annotations.anchor_at(at_pixel(102, 99).world, 4.5, true).samples.size() == 1);
  REQUIRE(bench.editor.load({}));
  CHECK(bench.annotations.anchor_at({0, 0}, 4.5, true).samples.empty());
}

TEST_CASE("the element that a line will be on is ringed") {
  AnnotationBench bench;
  bench.tool.hover(at_pixel(103, 101));
  CHECK(bench.tool.feedback().ringed == at_pixel(100, 100).world);
  bench.tool.hover(at_pixel(152, 149));
  CHECK(bench.tool.feedback().ringed == at_pixel(150, 150).world);
  bench.tool.hover(at_pixel(400, 300));
  CHECK_FALSE(bench.tool.feedback().ringed.has_value());
  // Of words dragged off a sample, that sample; of an arrow, where its tip is.
  bench.tool.press(at_pixel(103, 101));
  bench.tool.drag(at_pixel(201, 199));
  CHECK(bench.tool.feedback().ringed == at_pixel(100, 100).world);
  REQUIRE(bench.tool.feedback().line.has_value());
  CHECK(bench.tool.feedback().line->second == at_pixel(201, 199).world);
  bench.tool.cancel();
  bench.tool.press(at_pixel(400, 300));
  bench.tool.drag(at_pixel(201, 199));
  CHECK(bench.tool.feedback().ringed == at_pixel(200, 200).world);
  bench.tool.cancel();
  CHECK(bench.all().empty());
  // What lies under an annotation is not taken.
  bench.under_pointer = 0;
  bench.tool.hover(at_pixel(103, 101));
  CHECK_FALSE(bench.tool.feedback().ringed.has_value());
  CHECK(bench.tool.feedback().annotation == 0);
}

TEST_CASE("a drag over free space is an arrow, which needs no words") {
  AnnotationBench bench;
  bench.drag(at_pixel(400, 300), at_pixel(202, 199));
  REQUIRE(bench.all().size() == 1);
  CHECK(bench.all()[0].kind == AnnotationKind::arrow);
  CHECK(bench.all()[0].anchors[1].samples == std::vector<std::uint32_t>{2});
  bench.annotations.close();
  CHECK(bench.all().size() == 1);
  CHECK(bench.refused == 0);
}

TEST_CASE("a drag of an annotation is one step, and Esc takes it back") {
  AnnotationBench bench;
  bench.click(at_pixel(400, 300));
  bench.write("words");
  bench.annotations.close();
  bench.under_pointer = 0;
  bench.drag(at_pixel(410, 298), at_pixel(450, 338));
  CHECK(bench.place(0) == at_pixel(440, 340).world);
  CHECK(bench.editor.undo_name() == "Move annotation");
  bench.editor.undo();
  CHECK(bench.place(0) == at_pixel(400, 300).world);
  bench.tool.press(at_pixel(410, 298));
  bench.tool.drag(at_pixel(600, 600));
  CHECK(bench.editor.in_gesture());
  bench.tool.cancel();
  CHECK_FALSE(bench.editor.in_gesture());
  CHECK(bench.place(0) == at_pixel(400, 300).world);
  // A click chooses it; the key that deletes it works on the annotation.
  bench.click(at_pixel(410, 298));
  REQUIRE(bench.annotations.current() != nullptr);
  CHECK(bench.annotations.current()->text == "words");
  REQUIRE(bench.annotations.erase());
  CHECK(bench.all().empty());
}

TEST_CASE("an end of an arrow is taken to another element") {
  AnnotationBench bench;
  bench.drag(at_pixel(400, 300), at_pixel(300, 300));
  bench.annotations.close();
  bench.under_pointer = 0;
  bench.drag(at_pixel(301, 300), at_pixel(200, 101));
  CHECK(bench.all()[0].anchors[0].at == at_pixel(400, 300).world);
  CHECK(bench.all()[0].anchors[1].samples == std::vector<std::uint32_t>{1});
}

TEST_CASE("whatever else changes annotations ends the choice") {
  AnnotationBench bench;
  bench.click(at_pixel(400, 300));
  bench.write("first");
  bench.annotations.close();
  bench.annotations.select(0);
  bench.editor.undo();
  CHECK(bench.annotations.current() == nullptr);
  bench.annotations.follow();
  CHECK_FALSE(bench.annotations.selected().has_value());
  REQUIRE(bench.annotations.erase());
  CHECK_FALSE(bench.annotations.close());
  // Deleting a sample changes the places of what follows it, and nothing else.
  bench.click(at_pixel(100, 100));
  bench.write("on a sample");
  const SampleId id{bench.editor.document().first_id().value};
  REQUIRE(bench.editor.remove(std::array{id}, "Delete"));
  bench.annotations.follow();
  bench.write("where a sample was");
  CHECK(bench.all()[0].text == "where a sample was");
  CHECK(bench.place(0) == at_pixel(100, 100).world);
}

TEST_CASE("a draft does not reach another document") {
  AnnotationBench bench;
  bench.click(at_pixel(100, 100));
  REQUIRE(bench.annotations.is_draft());
  bench.annotations.forget();
  CHECK(bench.annotations.current() == nullptr);
  REQUIRE(bench.editor.load({.positions = {{1, 2}}}));
  REQUIRE(bench.annotations.change({.text = "late", .anchors = {{.samples = {2}}}}));
  CHECK(bench.all().empty());
  // Nor does a choice.
  bench.click(at_pixel(400, 300));
  bench.write("words");
  REQUIRE(bench.editor.load({}));
  CHECK(bench.annotations.current() == nullptr);
  CHECK_FALSE(bench.annotations.close());
}

TEST_CASE("a measurement becomes a dimension that follows its samples") {
  AnnotationBench bench;
  MeasureTool measure(bench.context);
  CHECK_FALSE(measure.measurement().has_value());
  for (const Pointer& p : {at_pixel(100, 100), at_pixel(200, 100)}) {
    measure.press(p);
    measure.release(p);
  }
  auto kept = measure.measurement();
  REQUIRE(kept.has_value());
  CHECK(kept->kind == AnnotationKind::distance);
  REQUIRE(bench.annotations.begin(*kept));
  REQUIRE(bench.all().size() == 1);
  bench.move_sample(1, at_pixel(300, 100).world);
  CHECK(distance(bench.place(0, 0), bench.place(0, 1)) == 100.0);
  measure.press(at_pixel(200, 200));
  measure.release(at_pixel(200, 200));
  kept = measure.measurement();
  REQUIRE(kept.has_value());
  CHECK(kept->kind == AnnotationKind::angle);
}

TEST_CASE("a session brings annotations back with all that can be undone") {
  AnnotationBench bench;
  bench.click(at_pixel(100, 100));
  bench.write("on $p_0$");
  bench.annotations.close();
  bench.drag(at_pixel(400, 300), at_pixel(300, 300));
  bench.annotations.close();
  bench.move_sample(0, at_pixel(120, 90).world);
  const Session session{.data = bench.editor.timeline().data(), .entries = bench.editor.timeline().entries()};
  const auto read = read_session(write_session(session), "a.json");
  REQUIRE(read.has_value());
  DocumentReplay replay;
  REQUIRE(replay_session(*read, replay, "a.json"));
  CHECK(*replay.document().annotations() == bench.all());
  CHECK(replay.history().step_count() == 3);
}
