// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "app/editing/selection_commands.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/io/format.h"
#include "core/io/systems/map_conversion.h"

using namespace mes;

namespace {

struct SelectionBench {
  Editor editor{[](auto) {}};
  SelectionCommands commands{builtins(), editor};

  explicit SelectionBench(SampleData data) { REQUIRE(editor.load(data)); }
  const Document& document() const { return editor.document(); }
  void select_all() { editor.selection().select_all(document()); }
  std::vector<Vec2> positions() const {
    std::vector<Vec2> out;
    for (const SampleSlot slot : document().slots_in_input_order()) out.push_back(document().position(slot));
    return out;
  }
  std::vector<Disk> balls() const {
    std::vector<Disk> out;
    for (const BallSlot slot : document().ball_slots_in_input_order()) out.push_back(document().disk(slot));
    return out;
  }
  std::vector<Vec2> selected() const {
    std::vector<Vec2> out;
    for (const SampleSlot slot : editor.selection().slots()) out.push_back(document().position(slot));
    return out;
  }
  /// One step of undo takes it back, and one brings it again.
  void is_one_step(const std::vector<Vec2>& before, const std::vector<Disk>& balls_before) {
    const std::vector<Vec2> after = positions();
    const std::vector<Disk> balls_after = balls();
    editor.undo();
    CHECK(positions() == before);
    CHECK(balls() == balls_before);
    CHECK_FALSE(editor.can_undo());
    editor.redo();
    CHECK(positions() == after);
    CHECK(balls() == balls_after);
  }
};

SampleData square_and_ball() {
  return {.positions = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, .balls = {{{10, 2}, 1.5}}};
}

}  // namespace

TEST_CASE("one sample is put exactly where it is to be") {
  SelectionBench d({.positions = {{0.1, 0.2}, {5, 6}}});
  d.editor.selection().add(SampleSlot(0));
  CHECK(d.commands.numbers().middle == Vec2{0.1, 0.2});
  REQUIRE(d.commands.move_middle_to({1.0 / 3.0, 0.7}));
  CHECK(d.positions() == std::vector<Vec2>{{1.0 / 3.0, 0.7}, {5, 6}});
  CHECK(d.commands.numbers().middle == Vec2{1.0 / 3.0, 0.7});
  CHECK(d.editor.undo_name() == "Move sample");
  d.is_one_step({{0.1, 0.2}, {5, 6}}, {});
}

TEST_CASE("samples and balls are moved, turned, scaled and mirrored together, each as one step") {
  const SampleData data = square_and_ball();
  SECTION("moved by their middle") {
    SelectionBench d(data);
    d.select_all();
    CHECK(d.commands.numbers().middle == Vec2{5, 2});
    CHECK(d.commands.numbers().radius == 1.5);
    REQUIRE(d.commands.move_middle_to({6, 2}));
    CHECK(d.positions() == std::vector<Vec2>{{1, 0}, {5, 0}, {5, 4}, {1, 4}});
    CHECK(d.balls() == std::vector<Disk>{{{11, 2}, 1.5}});
    d.is_one_step(data.positions, data.balls);
  }
  SECTION("turned") {
    SelectionBench d(data);
    d.select_all();
    REQUIRE(d.commands.turn(90));
    CHECK(d.positions() == std::vector<Vec2>{{7, -3}, {7, 1}, {3, 1}, {3, -3}});
    CHECK(d.balls() == std::vector<Disk>{{{5, 7}, 1.5}});
    d.is_one_step(data.positions, data.balls);
  }
  SECTION("scaled, with the radius") {
    SelectionBench d(data);
    d.select_all();
    REQUIRE(d.commands.scale(2));
    CHECK(d.positions().front() == Vec2{-5, -2});
    CHECK(d.balls() == std::vector<Disk>{{{15, 2}, 3.0}});
    d.is_one_step(data.positions, data.balls);
    CHECK_FALSE(d.commands.scale(0));
    CHECK_FALSE(d.commands.scale(-1));
    CHECK_FALSE(d.commands.scale(std::nan("")));
  }
  SECTION("mirrored") {
    SelectionBench d(data);
    d.select_all();
    REQUIRE(d.commands.mirror(Axis::x));
    CHECK(d.positions().front() == Vec2{10, 0});
    CHECK(d.balls().front().center == Vec2{0, 2});
    d.is_one_step(data.positions, data.balls);
  }
  SECTION("radii set") {
    SelectionBench d(data);
    d.select_all();
    REQUIRE(d.commands.set_radius(0.25));
    CHECK(d.balls() == std::vector<Disk>{{{10, 2}, 0.25}});
    d.is_one_step(data.positions, data.balls);
    CHECK_FALSE(d.commands.set_radius(-1));
  }
}

TEST_CASE("formulas place each by itself") {
  SelectionBench d({.positions = std::vector<Vec2>(8), .balls = {{{1, 1}, 2}}});
  d.select_all();
  REQUIRE(d.commands.place_each({.x = "3 * cos(2*pi*i/8)", .y = "3 * sin(2*pi*i/8)", .r = "r / 2"}));
  const std::vector<Vec2> circle = d.positions();
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(length(circle[i]) == Approx(3.0));
    CHECK(circle[i].x == Approx(3 * std::cos(2 * 3.14159265358979 * static_cast<double>(i) / 8)).margin(1e-12));
  }
  CHECK(d.balls().front().radius == 1.0);
  CHECK(d.editor.undo_name() == "Place samples and ball");
  // What is left empty stays.
  REQUIRE(d.commands.place_each({.x = "x + n"}));
  CHECK(d.positions()[3].x == circle[3].x + 9);
  CHECK(d.positions()[3].y == circle[3].y);
  const std::vector<Vec2> before = d.positions();
  for (const char* bad : {"1/0", "x +", "foo", "log(-1)"}) {
    const auto done = d.commands.place_each({.x = bad});
    REQUIRE_FALSE(done);
    CHECK(done.error().text.starts_with("x"));
  }
  CHECK_FALSE(d.commands.place_each({.r = "-1"}));
  CHECK_FALSE(d.commands.place_each({.y = "1e300"}));
  CHECK(d.positions() == before);
}

TEST_CASE("places become exactly degenerate as one step, and it is said by how much they moved") {
  std::vector<Vec2> ring;
  for (int i = 0; i < 6; ++i) ring.push_back({std::cos(i + 0.3), std::sin(i + 0.3)});
  SelectionBench d({.positions = ring});
  d.select_all();
  const auto circle = d.commands.put_on_circle();
  REQUIRE(circle);
  CHECK(circle->starts_with("Exactly on one circle; moved by "));
  CHECK(d.positions() != ring);
  d.is_one_step(ring, {});
  const auto again = d.commands.put_on_circle();
  REQUIRE(again);
  CHECK(again->ends_with("moved by 0 at most"));
  const auto line = d.commands.put_on_line();
  REQUIRE(line);
  SelectionBench straight({.positions = {{0, 0}, {1, 1}, {2, 2}, {3, 3}}});
  straight.select_all();
  CHECK_FALSE(straight.commands.put_on_circle());
  CHECK_FALSE(straight.editor.can_undo());
}

TEST_CASE("a circle goes through three, and is selected") {
  SelectionBench d({.positions = {{1, 0}, {0, 1}, {-1, 0}}});
  d.select_all();
  REQUIRE(d.commands.add_circle());
  REQUIRE(d.balls().size() == 1);
  CHECK(d.balls().front() == Disk{{0, 0}, 1});
  CHECK(d.editor.selection().sample_count() == 0);
  CHECK(d.editor.selection().ball_count() == 1);
  d.is_one_step({{1, 0}, {0, 1}, {-1, 0}}, {});
  SelectionBench flat({.positions = {{1, 0}, {2, 0}, {3, 0}}});
  flat.select_all();
  CHECK_FALSE(flat.commands.add_circle());
  flat.editor.selection().remove(SampleSlot(0));
  CHECK_FALSE(flat.commands.add_circle());
}

TEST_CASE("text goes from one window to another with every digit") {
  Rng random(5);
  for (const bool has_samples : {true, false}) {
    for (const bool has_balls : {true, false}) {
      if (!has_samples && !has_balls) continue;
      SampleData data;
      for (int i = 0; i < 20 && has_samples; ++i)
        data.positions.push_back({random.uniform(), random.uniform(-1e9, 1e9)});
      for (int i = 0; i < 5 && has_balls; ++i)
        data.balls.push_back({{random.uniform(), random.uniform()}, random.uniform()});
      SelectionBench from(data);
      from.select_all();
      SelectionBench to({.positions = {{100, 100}}});
      REQUIRE(to.commands.paste(from.commands.text(), {1, -1}));
      std::vector<Vec2> expected = data.positions;
      expected.insert(expected.begin(), {100, 100});
      CHECK(to.positions() == expected);
      CHECK(to.balls() == data.balls);
      CHECK(to.editor.selection().sample_count() == data.positions.size());
      CHECK(to.editor.selection().ball_count() == data.balls.size());
      to.is_one_step({{100, 100}}, {});
    }
  }
}

TEST_CASE("what is pasted twice does not lie on itself, and what is duplicated neither") {
  SelectionBench d({.positions = {{0, 0}, {1, 0}}});
  d.select_all();
  const std::string text = d.commands.text();
  CHECK(text == "0\t0\n1\t0\n");
  REQUIRE(d.commands.paste(text, {0.25, -0.25}));
  CHECK(d.selected() == std::vector<Vec2>{{0.25, -0.25}, {1.25, -0.25}});
  REQUIRE(d.commands.paste(text, {0.25, -0.25}));
  CHECK(d.selected() == std::vector<Vec2>{{0.5, -0.5}, {1.5, -0.5}});
  REQUIRE(d.commands.duplicate({3, 0}));
  CHECK(d.selected() == std::vector<Vec2>{{3.5, -0.5}, {4.5, -0.5}});
  CHECK(d.editor.undo_name() == "Duplicate samples");
  CHECK(d.document().sample_count() == 8);
}

TEST_CASE("a contour that is selected as a whole is duplicated as a contour, in one step") {
  SelectionBench d({.positions = {{0, 0}, {4, 0}, {4, 4}, {9, 9}, {8, 9}, {7, 7}},
                    .contours = {{true, {2, 0, 1}}, {false, {3, 4}}}});
  // Of the second contour one sample is not selected.
  for (const std::uint32_t i : {0U, 1U, 2U, 3U, 5U}) d.editor.selection().add(d.document().slots_in_input_order()[i]);
  const SampleData before = data_of(d.document());
  REQUIRE(d.commands.duplicate({100, 0}));
  const SampleData after = data_of(d.document());
  CHECK(after.positions.size() == 11);
  REQUIRE(after.contours.size() == 3);
  CHECK(after.contours[0] == before.contours[0]);
  CHECK(after.contours[1] == before.contours[1]);
  CHECK(after.contours[2].closed);
  std::vector<Vec2> copied;
  for (const std::uint32_t i : after.contours[2].points) copied.push_back(after.positions[i]);
  CHECK(copied == std::vector<Vec2>{{104, 4}, {100, 0}, {104, 0}});
  d.editor.undo();
  CHECK(data_of(d.document()).contours == before.contours);
  CHECK(d.positions() == before.positions);
  CHECK_FALSE(d.editor.can_undo());
}

TEST_CASE("text that holds no samples is refused in one line, and nothing changes") {
  SelectionBench d({.positions = {{1, 2}}});
  for (const std::string& text :
       {std::string(), std::string("hello world"), std::string("1 2\n3"), std::string("POFF 5 0 0\n1 2"),
        std::string(3, '\0'), std::string("nan 1"), std::string("1e400 2")}) {
    const auto done = d.commands.paste(text, {1, 1});
    INFO(text);
    REQUIRE_FALSE(done);
    CHECK(done.error().message().find('\n') == std::string::npos);
    CHECK(d.positions() == std::vector<Vec2>{{1, 2}});
    CHECK_FALSE(d.editor.can_undo());
  }
  // Other formats are read as when they are opened.
  REQUIRE(d.commands.paste("POLYGON ((0 0, 4 0, 4 4, 0 0))", {1, 1}));
  CHECK(d.document().sample_count() >= 4);
  REQUIRE(d.commands.paste("SRID=4326;MULTIPOINT ((9 50), (11.5 51))", {1, 1}, MapDegrees::kept));
  CHECK(d.positions().back() == Vec2{11.5, 51});
}

TEST_CASE("text of another coordinate system is pasted where it lies on the Earth") {
  SampleData data{.positions = {{0, 0}}};
  data.map = MapPlane{MapProjection::azimuthal, 9.7, 52.3};
  SelectionBench d(data);
  REQUIRE(d.commands.paste("SRID=25832;POINT (548206 5803104)", {1, 1}));
  const auto conversion = MapConversion::of(*data.map, MapTarget::wgs84);
  REQUIRE(conversion);
  // The numbers are those of cs2cs.
  CHECK(distance(conversion->from_plane(d.positions().back()), {9.708148085036, 52.376078240013}) < 1e-8);
  // A text without a system is taken as it is, and one that PROJ does not know is refused.
  REQUIRE(d.commands.paste("POINT (30 40)", {1, 1}));
  CHECK(d.positions().back() == Vec2{30, 40});
  const auto unknown = d.commands.paste("SRID=999999;POINT (1 2)", {1, 1});
  REQUIRE_FALSE(unknown);
  CHECK_THAT(unknown.error().message(), Catch::Contains("PROJ knows"));
}

TEST_CASE("what is pasted lies on nothing that is there, whichever of its places is taken") {
  SelectionBench d({.positions = {{0, 0}, {1, 0}, {2, 0}}, .balls = {{{5, 5}, 1}}});
  d.select_all();
  const std::string text = d.commands.text();
  d.editor.selection().clear();
  d.editor.selection().add(SampleSlot(0));
  REQUIRE(d.editor.remove_selection());
  REQUIRE(d.commands.paste(text, {0.25, -0.25}));
  CHECK(d.selected() == std::vector<Vec2>{{0.25, -0.25}, {1.25, -0.25}, {2.25, -0.25}});
  // The ball alone is in the way.
  REQUIRE(d.commands.paste("WPOFF 2 0 0\n7 7 1\n5 5 1\n", {0.25, -0.25}));
  CHECK(d.balls().back() == Disk{{5.5, 4.5}, 1});
}

TEST_CASE("what a pasted text has besides is said") {
  SelectionBench d({.positions = {{1, 2}}});
  const auto table = d.commands.paste("0\t0\n5\t6\n", {1, 1});
  REQUIRE(table);
  CHECK(table->warnings.empty());
  CHECK(table->without.empty());
  const auto map = d.commands.paste("POLYGON ((0 0, 4 0, 4 4, 0 0))\nPOINT Z (7 8 9)", {1, 1});
  REQUIRE(map);
  CHECK(map->without == "their order along 1 contour");
  REQUIRE(map->warnings.size() == 2);
  CHECK_THAT(map->warnings[0], Catch::Contains("samples were added between the 4 vertices"));
  CHECK_THAT(map->warnings[1], Catch::StartsWith("clipboard:2:") && Catch::Contains("heights"));
  const std::size_t before = d.document().sample_count();
  CHECK(before > 100);
  const auto drawing = d.commands.paste(
      R"(<svg xmlns="http://www.w3.org/2000/svg"><rect width="3" height="2"/><text>a</text><text>b</text></svg>)",
      {1, 1});
  REQUIRE(drawing);
  REQUIRE(drawing->warnings.size() == 1);
  CHECK_THAT(drawing->warnings[0], Catch::Contains("2 text"));
  // The sides are sampled as in a file, not at their corners alone.
  CHECK(d.document().sample_count() > before + 20);
}

TEST_CASE("a drawing or map begins a document where there is none, and a table of samples never does") {
  const std::string polygon = "POLYGON ((0 0, 4 0, 4 4, 0 0))";
  const std::string map = "SRID=25832;POINT (548206 5803104)";
  const std::string table = "0\t0\n5\t6\n";
  SelectionBench filled({.positions = {{1, 2}}});
  for (const std::string& text : {polygon, map, table})
    CHECK_FALSE(filled.commands.begins_document(text, MapDegrees::projected));
  SelectionBench empty({});
  CHECK(empty.commands.begins_document(polygon, MapDegrees::projected));
  CHECK(empty.commands.begins_document(map, MapDegrees::projected));
  const std::string circle = R"(<svg xmlns="http://www.w3.org/2000/svg"><circle r="5"/></svg>)";
  CHECK(empty.commands.begins_document(circle, MapDegrees::projected));
  // Samples that were cut come back by an edit.
  for (const std::string& text : {table, std::string("WPOFF 1 0 0\n7 7 1\n"), std::string("hello"), std::string()})
    CHECK_FALSE(empty.commands.begins_document(text, MapDegrees::projected));
}

TEST_CASE("a clipboard without text is said to have none") {
  SelectionBench d({.positions = {{1, 2}}});
  for (const std::string text : {"", " \t\r\n"}) {
    const auto done = d.commands.paste(text, {1, 1});
    REQUIRE_FALSE(done);
    CHECK(done.error().message() == "There is no text on the clipboard");
  }
}

TEST_CASE("with nothing selected nothing happens") {
  SelectionBench d(square_and_ball());
  CHECK(d.commands.numbers().samples + d.commands.numbers().balls == 0);
  CHECK(d.commands.move_middle_to({1, 1}));
  CHECK(d.commands.move_by({1, 1}));
  CHECK(d.commands.turn(10));
  CHECK(d.commands.scale(2));
  CHECK(d.commands.mirror(Axis::y));
  CHECK(d.commands.align(Alignment::top));
  CHECK(d.commands.distribute(Axis::x));
  CHECK(d.commands.place_each({.x = "x + 1"}));
  CHECK(d.commands.duplicate({1, 1}));
  CHECK(d.commands.text().empty());
  CHECK_FALSE(d.editor.can_undo());
}
