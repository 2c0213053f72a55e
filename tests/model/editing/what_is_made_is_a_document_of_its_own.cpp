// SPDX-License-Identifier: GPL-3.0-or-later
// What is made in the program, or traced from a picture, never goes into the file that was open.
#include <catch2/catch.hpp>
#include <memory>

#include "tests/model/files/files_bench.h"

using namespace mes;
using mes::test::contents_of;
using Bench = mes::test::FilesBench;

namespace {

std::shared_ptr<const SampleData> triangle() {
  return std::make_shared<const SampleData>(
      SampleData{.positions = {{0, 0}, {4, 0}, {0, 3}}, .contours = {{true, {0, 1, 2}}}});
}

DocumentFiles::Outcome make(Bench& bench, const std::string& title) {
  bench.files.open_made(triangle(), title, "1 outline");
  CHECK(bench.files.reading_name() == title);
  return bench.outcome();
}

}  // namespace

TEST_CASE("what is made has its own title, no file, and is unsaved") {
  Bench bench;
  const std::string before = "POFF 1 0 0\n5 6\n";
  for (const char* const name : {"a.poff", "a.json"}) {
    const auto file = bench.folder / name;
    REQUIRE_FALSE(bench.open(bench.folder.write("b.poff", before)).error);
    REQUIRE(bench.save_as(file));
    const std::string saved = contents_of(file);
    const DocumentFiles::Outcome outcome = make(bench, "disk.png");
    REQUIRE_FALSE(outcome.error);
    CHECK(outcome.is_made);
    CHECK(outcome.files.empty());
    CHECK(outcome.remark == "1 outline");
    CHECK(outcome.samples == 3);
    CHECK(bench.files.title() == "disk.png");
    CHECK(bench.files.file().empty());
    CHECK(bench.files.sample_file().empty());
    CHECK_FALSE(bench.files.has_session_file());
    CHECK(bench.editor.is_modified());
    CHECK(bench.files.unsaved().samples);
    CHECK_FALSE(bench.editor.can_undo());
    CHECK(bench.editor.document().sample_count() == 3);
    CHECK(bench.editor.document().curve_order()->contours.size() == 1);
    // Nothing is written where no name was given.
    REQUIRE(bench.save());
    CHECK(contents_of(file) == saved);
    CHECK(bench.editor.is_modified());
    REQUIRE(bench.save_as(bench.folder / "mine.poff"));
    CHECK_FALSE(bench.editor.is_modified());
    CHECK(bench.files.file() == bench.folder / "mine.poff");
    CHECK(contents_of(file) == saved);
  }
}

TEST_CASE("what is edited while something is made is not lost without a question") {
  Bench bench;
  bench.files.open_made(triangle(), "Circle");
  bench.add_sample();
  bench.wait_for_reading();
  CHECK_FALSE(bench.files.poll());
  CHECK(bench.files.would_lose_work());
  bench.files.cancel_reading();
  CHECK(bench.editor.document().sample_count() == 1);
  CHECK(bench.files.title() == "Untitled");
}

TEST_CASE("a text that is opened has its contours, curves and map, its own title, and no file") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  REQUIRE_FALSE(bench.open(file).error);
  const auto open = [&](const std::string& text) {
    bench.files.open_text(text, "Clipboard", MapDegrees::projected);
    CHECK(bench.files.reading_name() == "Clipboard");
    return bench.outcome();
  };
  const DocumentFiles::Outcome drawing =
      open(R"(<svg xmlns="http://www.w3.org/2000/svg"><circle cx="5" cy="5" r="5"/><text>a</text></svg>)");
  REQUIRE_FALSE(drawing.error);
  CHECK(drawing.is_made);
  CHECK(drawing.format == "svg");
  REQUIRE(drawing.warnings.size() == 1);
  CHECK_THAT(drawing.warnings[0], Catch::StartsWith("Clipboard:") && Catch::Contains("text"));
  CHECK(bench.files.title() == "Clipboard");
  CHECK(bench.files.file().empty());
  CHECK(bench.files.sample_file().empty());
  CHECK(bench.editor.is_modified());
  CHECK(bench.editor.document().sample_count() > 8);
  CHECK(bench.editor.document().curve_order()->contours.size() == 1);
  CHECK(bench.editor.document().source() != nullptr);

  const DocumentFiles::Outcome map = open("SRID=4326;POLYGON ((9 50, 9.1 50, 9.1 50.1, 9 50))");
  CHECK(map.degrees == MapDegrees::projected);
  CHECK(bench.editor.document().map().has_value());

  const std::string garbage = "no samples at all";
  const SampleData before = data_of(bench.editor.document());
  const DocumentFiles::Outcome refused = open(garbage);
  REQUIRE(refused.error);
  CHECK(data_of(bench.editor.document()).positions == before.positions);
  CHECK(contents_of(file) == "POFF 1 0 0\n5 6\n");
}
