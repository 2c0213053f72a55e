// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <numeric>

#include "core/io/format.h"
#include "core/io/session/session.h"
#include "temporary_folder.h"

using namespace mes;

namespace {

using Indices = std::vector<std::uint32_t>;

LoadedFile read_contours(const std::string& bytes, const std::string& name = "a.poff") {
  auto read = read_sample_bytes(bytes, name);
  if (!read) FAIL(read.error().message());
  return *read;
}

}  // namespace

TEST_CASE("loop lines name points of the file, closed or open") {
  const LoadedFile file = read_contours(
      "POFF 4 0 0\n0 0\n1 0\n1 1\n0 1\n# loop closed 0 1 2\n#loop open\t3 2\n# loopy\n# loop the loop\n");
  CHECK(file.warnings.empty());
  REQUIRE(file.data.contours.size() == 2);
  CHECK(file.data.contours[0].closed);
  CHECK(file.data.contours[0].points == Indices{0, 1, 2});
  CHECK_FALSE(file.data.contours[1].closed);
  CHECK(file.data.contours[1].points == Indices{3, 2});
}

TEST_CASE("loops through points that do not exist are ignored with a warning, the points are not") {
  const std::string points = "POFF 2 0 0\n0 0\n1 0\n";
  const LoadedFile file = read_contours(points + "# loop closed 0 2 1\n# loop open 1 0\n");
  CHECK(file.data.positions.size() == 2);
  CHECK(file.data.contours.size() == 1);
  REQUIRE(file.warnings.size() == 1);
  CHECK_THAT(file.warnings[0], Catch::StartsWith("a.poff:4:17: ") && Catch::Contains("\"2\""));
  CHECK_THAT(read_contours(points + "  # loop open 1 two\n").warnings[0],
             Catch::StartsWith("a.poff:4:17: ") && Catch::Contains("\"two\""));
  // Of several the first says what is wrong.
  const LoadedFile two = read_contours(points + "# loop closed 0 2 1\n# loop open 1 two\n");
  REQUIRE(two.warnings.size() == 2);
  CHECK(two.warnings[1] == "a.poff: one more loop is ignored as well");
  CHECK(read_contours(points + "# loop open 9\n# loop open 9\n# loop open 9\n").warnings[1] ==
        "a.poff: 2 more loops are ignored as well");
}

TEST_CASE("a point that a loop names twice in a row, or at both ends of a closed one, is one corner") {
  const LoadedFile file = read_contours("POFF 4 0 0\n0 0\n1 0\n1 1\n0 1\n# loop closed 0 0 1 2 2 2 3 0\n");
  CHECK(file.warnings.empty());
  REQUIRE(file.data.contours.size() == 1);
  CHECK(file.data.contours[0].points == Indices{0, 1, 2, 3});
  const LoadedFile lone = read_contours("POFF 1 0 0\n0 0\n# loop closed 0 0 0\n");
  CHECK(lone.warnings.empty());
  REQUIRE(lone.data.contours.size() == 1);
  CHECK(lone.data.contours[0].points == Indices{0});
}

TEST_CASE("points that a loop names more than once stay in it, and are said in one line") {
  const std::string points = "POFF 5 0 0\n0 0\n4 0\n2 2\n4 4\n0 4\n";
  const LoadedFile eight = read_contours(points + "# loop closed 0 1 2 3 4 2\n");
  REQUIRE(eight.data.contours.size() == 1);
  CHECK(eight.data.contours[0].points == Indices{0, 1, 2, 3, 4, 2});
  REQUIRE(eight.warnings.size() == 1);
  CHECK(eight.warnings[0] == "a.poff:7:1: 1 sample is on its contour more than once; evolutions do not move it");
  const LoadedFile more =
      read_contours(points + "# loop closed 0 1 2\n# loop closed 2 3 2 1 2 4\n# loop open 0 4 0\n");
  CHECK(more.data.contours.size() == 3);
  REQUIRE(more.warnings.size() == 1);
  CHECK(more.warnings[0] == "a.poff:8:1: 2 samples are on their contour more than once; evolutions do not move them");
  // Loops may meet.
  CHECK(read_contours(points + "# loop closed 0 1 2\n# loop open 2 3 4\n").warnings.empty());
}

TEST_CASE("what follows the announced points is ignored with a warning") {
  const LoadedFile file = read_contours("POFF 1 0 0\n0 0 5\n6 7\n");
  CHECK(file.data.positions.size() == 1);
  REQUIRE(file.warnings.size() == 1);
  CHECK_THAT(file.warnings[0], Catch::StartsWith("a.poff:2:5: "));
}

TEST_CASE("white space in POFF is anything, and comments may stand anywhere") {
  const LoadedFile file = read_contours("\xEF\xBB\xBF# first\r\n\tPOFF#x\r2\v0 0 1 # one\n\f2\n\n\n+3 4.");
  CHECK(file.data.positions == std::vector<Vec2>{{1, 2}, {3, 4}});
}

TEST_CASE("a contours file beside a POFF file gives closed contours in file order") {
  const auto read = read_sample_file("tests/data/earcut_dude.poff");
  REQUIRE(read.has_value());
  CHECK(read->warnings.empty());
  CHECK(read->data.positions.size() == 104);
  REQUIRE(read->data.contours.size() == 3);
  CHECK(read->data.contours[0].points.size() == 94);
  CHECK(read->data.contours[1].points == Indices{94, 95, 96, 97});
  CHECK(read->data.contours[2].points == Indices{98, 99, 100, 101, 102, 103});
  for (const auto& contour : read->data.contours) CHECK(contour.closed);
}

TEST_CASE("islands of an archipelago are contours of their own") {
  const auto read = read_sample_file("tests/data/ne_hawaii.poff");
  REQUIRE(read.has_value());
  CHECK(read->data.contours.size() == 8);
  std::size_t points = 0;
  for (const auto& contour : read->data.contours) points += contour.points.size();
  CHECK(points == read->data.positions.size());
}

TEST_CASE("a contours file that does not fit is ignored with a warning that names it") {
  const test::TemporaryFolder folder;
  const auto poff = folder.write("a.poff", "POFF 3 0 0\n0 0\n1 0\n0 1\n");
  const std::string name = (folder / "a.contours").string();
  struct Case {
    std::string contours;
    std::string place;
    std::string says;
  };
  for (const Case& test :
       {Case{"2\n", ":2:1: ", "have 2 points, the file has 3"}, Case{"2\n2\n", ":2:1: ", "more points"},
        Case{"2 one\n", ":1:3: ", "\"one\""}, Case{"99999999999999999999999", ":1:1: ", "number"},
        Case{"", ":1:1: ", "have 0 points"}, Case{"-1 4", ":1:1: ", "\"-1\""}}) {
    folder.write("a.contours", test.contours);
    const auto read = read_sample_file(poff);
    REQUIRE(read.has_value());
    CHECK(read->data.positions.size() == 3);
    CHECK(read->data.contours.empty());
    REQUIRE(read->warnings.size() == 1);
    CHECK_THAT(read->warnings[0], Catch::StartsWith(name + test.place) && Catch::Contains(test.says));
  }
}

TEST_CASE("loops in the file win over a contours file beside it") {
  const test::TemporaryFolder folder;
  folder.write("a.contours", "3\n");
  const auto read = read_sample_file(folder.write("a.poff", "POFF 3 0 0\n0 0\n1 0\n0 1\n# loop open 0 2\n"));
  REQUIRE(read.has_value());
  REQUIRE(read->data.contours.size() == 1);
  CHECK(read->data.contours[0].points == Indices{0, 2});
}

TEST_CASE("a contour column groups the rows of a table") {
  const auto read = read_sample_file("tests/data/ampersand_contour_id.csv");
  REQUIRE(read.has_value());
  CHECK(read->format == "csv");
  CHECK(read->data.positions.size() == 216);
  CHECK(read->data.positions[1] == Vec2{463.54000000000013, 770.6200000000001});
  REQUIRE(read->data.contours.size() == 2);
  CHECK(read->data.contours[0].closed);
  CHECK(read->data.contours[0].points.size() == 49);
  CHECK(read->data.contours[1].points.size() == 167);
}

TEST_CASE("a repeated closing point is dropped and closes its contour") {
  const LoadedFile whole = read_contours("x,y\n0,0\n1,0\n1,1\n0,0\n", "a.csv");
  CHECK(whole.data.positions == std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}});
  REQUIRE(whole.data.contours.size() == 1);
  CHECK(whole.data.contours[0].closed);
  CHECK(whole.data.contours[0].points == Indices{0, 1, 2});

  // There and back is not a loop.
  const LoadedFile there_and_back = read_contours("x,y\n0,0\n1,0\n0,0\n", "a.csv");
  CHECK(there_and_back.data.positions == std::vector<Vec2>{{0, 0}, {1, 0}, {0, 0}});
  CHECK(there_and_back.data.contours.empty());

  // Rows of two contours in turn; only the first repeats its beginning, so only it is closed.
  const LoadedFile mixed = read_contours("ring,x,y\na,0,0\nb,5,5\na,1,0\nb,6,5\na,1,1\na,0,0\nb,6,6\n", "a.csv");
  CHECK(mixed.data.positions.size() == 6);
  REQUIRE(mixed.data.contours.size() == 2);
  CHECK(mixed.data.contours[0].closed);
  CHECK(mixed.data.contours[0].points == Indices{0, 2, 4});
  CHECK_FALSE(mixed.data.contours[1].closed);
  CHECK(mixed.data.contours[1].points == Indices{1, 3, 5});
  CHECK(mixed.data.positions[5] == Vec2{6, 6});
}

TEST_CASE("a column that numbers the rows groups nothing, and one called path is open") {
  CHECK(read_contours("id,x,y\n1,0,0\n2,1,0\n3,1,1\n", "a.csv").data.contours.empty());
  const LoadedFile strokes = read_contours("path,x,y\n1,0,0\n1,1,0\n2,1,1\n2,2,2\n", "a.csv");
  REQUIRE(strokes.data.contours.size() == 2);
  CHECK_FALSE(strokes.data.contours[0].closed);
  const LoadedFile parts = read_contours("part,ring,x,y\n0,0,1,2\n0,1,3,4\n1,0,5,6\n1,0,7,8\n", "a.csv");
  CHECK(parts.data.contours.size() == 3);
}

TEST_CASE("without a repetition rows of a table are points and no curve") {
  CHECK(read_contours("0,0\n1,0\n1,1\n", "a.csv").data.contours.empty());
}

TEST_CASE("a session whose contour lost the sample between two visits of another has one corner there") {
  Session session;
  session.data = std::make_shared<const SampleData>(
      SampleData{.positions = {{0, 0}, {1, 0}, {2, 0}}, .contours = {{false, {0, 1, 0, 2}}, {true, {0, 0, 2, 0}}}});
  session.entries = {TimelineEdit{.name = "Delete", .removed = {1}}};
  const LoadedFile file = read_contours(write_session(session), "a.json");
  CHECK(file.data.contours == std::vector<SampleData::Contour>{{false, {0, 1}}, {true, {0, 1}}});
  Document document;
  document.apply(*replace_all(document, file.data));
  const LoadedFile again = read_contours(write_poff(document));
  CHECK(again.warnings.empty());
  CHECK(again.data.contours == file.data.contours);
  // What was recorded is kept, so that the sample comes back to both visits.
  REQUIRE(file.session);
  CHECK(file.session->data->contours[0].points == Indices{0, 1, 0, 2});
}
