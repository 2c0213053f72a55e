// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <thread>

#include "core/io/session/session.h"
#include "render/figure/writers.h"
#include "tests/model/files/files_bench.h"

using namespace mes;
using mes::test::contents_of;
using Bench = mes::test::FilesBench;

TEST_CASE("a file of balls is opened, changed and saved to itself") {
  Bench bench;
  const auto file = bench.folder.write("a.wpoff", "WPOFF 1 0 0\n0.1 0 2\n");
  const auto outcome = bench.open(file);
  REQUIRE_FALSE(outcome.error);
  CHECK(outcome.format == "wpoff");
  CHECK(outcome.balls == 1);
  CHECK(outcome.samples == 0);
  CHECK(bench.files.file() == file);
  CHECK(bench.files.title() == "a.wpoff");
  CHECK_FALSE(bench.editor.is_modified());
  bench.add_ball();
  CHECK(bench.editor.is_modified());
  REQUIRE(bench.save());
  CHECK_FALSE(bench.editor.is_modified());
  CHECK(contents_of(file) == "WPOFF 2 0 0\n0.1 0 2\n1 2 3\n");
  CHECK(bench.folder.file_count() == 1);
}

TEST_CASE("a document of samples and balls counts as modified until both have a file") {
  Bench bench;
  const auto samples = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  REQUIRE_FALSE(bench.open(samples).error);
  bench.add_ball();
  REQUIRE(bench.save());
  CHECK(contents_of(samples) == "POFF 1 0 0\n5 6\n");
  CHECK(bench.editor.is_modified());
  CHECK_FALSE(bench.files.unsaved().samples);
  CHECK(bench.files.unsaved().balls);

  const auto balls = bench.folder / "b.WPOFF";
  REQUIRE(bench.save_as(balls));
  CHECK(contents_of(balls) == "WPOFF 1 0 0\n1 2 3\n");
  CHECK_FALSE(bench.editor.is_modified());
  CHECK(bench.is_complete());

  // From now on one save writes both.
  bench.add_sample();
  bench.add_ball();
  CHECK(bench.files.unsaved().samples);
  CHECK(bench.files.unsaved().balls);
  REQUIRE(bench.save());
  CHECK(contents_of(samples) == "POFF 2 0 0\n5 6\n7 8\n");
  CHECK(contents_of(balls) == "WPOFF 2 0 0\n1 2 3\n1 2 3\n");
  CHECK_FALSE(bench.editor.is_modified());

  // A copy of the samples leaves the file of the balls alone.
  bench.add_ball();
  REQUIRE(bench.save_as(bench.folder / "copy.poff"));
  CHECK(contents_of(balls) == "WPOFF 2 0 0\n1 2 3\n1 2 3\n");
  CHECK(bench.editor.is_modified());
  CHECK(bench.files.sample_file() == bench.folder / "copy.poff");
  bench.editor.undo();
  CHECK(bench.is_complete());
}

TEST_CASE("annotations count as unsaved until a session holds them") {
  Bench bench;
  const auto samples = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  REQUIRE_FALSE(bench.open(samples).error);
  REQUIRE(bench.editor.annotate({{.text = "here", .anchors = {{.at = {5, 6}, .samples = {0}}}}}, "Annotate"));
  CHECK(bench.files.unsaved().annotations);
  CHECK_FALSE(bench.files.unsaved().samples);
  REQUIRE(bench.save());
  CHECK(bench.editor.is_modified());
  CHECK(bench.files.unsaved().annotations);
  const auto session = bench.folder / "a.json";
  REQUIRE(bench.save_as(session));
  CHECK_FALSE(bench.editor.is_modified());
  CHECK(bench.is_complete());
  // What is opened again has them, and a file of samples has not.
  REQUIRE_FALSE(bench.open(session).error);
  CHECK(bench.editor.document().annotations()->size() == 1);
  CHECK(bench.is_complete());
  REQUIRE(bench.editor.annotate({}, "Delete annotation"));
  REQUIRE(bench.save_as(bench.folder / "b.poff"));
  CHECK(bench.editor.is_modified());
  CHECK(bench.files.unsaved().annotations);
  bench.editor.undo();
  CHECK_FALSE(bench.files.unsaved().annotations);
}

TEST_CASE("samples added to a file of balls are not lost in it") {
  Bench bench;
  const auto balls = bench.folder.write("a.wpoff", "WPOFF 1 0 0\n0 0 2\n");
  REQUIRE_FALSE(bench.open(balls).error);
  bench.add_sample();
  REQUIRE(bench.save());
  CHECK(bench.editor.is_modified());
  CHECK(bench.files.unsaved().samples);
  CHECK(bench.folder.file_count() == 1);
  REQUIRE(bench.save_as(bench.folder / "a.poff"));
  CHECK_FALSE(bench.editor.is_modified());
}

TEST_CASE("a file that cannot be written leaves the files as they were chosen before") {
  Bench bench;
  const auto balls = bench.folder.write("a.wpoff", "WPOFF 1 0 0\n0 0 2\n");
  REQUIRE_FALSE(bench.open(balls).error);
  bench.add_ball();
  const auto saved = bench.save_as(bench.folder / "no such folder" / "b.wpoff");
  REQUIRE_FALSE(saved);
  CHECK(saved.error().code == ErrorCode::cannot_write);
  CHECK(bench.files.ball_file() == balls);
  CHECK(bench.files.file() == balls);
  CHECK(bench.editor.is_modified());
}

TEST_CASE("opening and starting anew forget both files") {
  Bench bench;
  REQUIRE_FALSE(bench.open(bench.folder.write("a.wpoff", "WPOFF 1 0 0\n0 0 2\n")).error);
  REQUIRE_FALSE(bench.open(bench.folder.write("a.csv", "x,y\n1,2\n")).error);
  CHECK(bench.files.file().empty());
  CHECK(bench.files.ball_file().empty());
  CHECK(bench.editor.document().ball_count() == 0);
  CHECK(bench.is_complete());
  REQUIRE_FALSE(bench.open(bench.folder / "a.wpoff").error);
  bench.files.start_empty();
  CHECK(bench.files.file().empty());
  CHECK(bench.files.ball_file().empty());
  CHECK(bench.editor.document().is_empty());
  CHECK_FALSE(bench.editor.is_modified());
}

TEST_CASE("a file of samples and one of balls are one document again") {
  Bench bench;
  const auto samples = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  const auto balls = bench.folder.write("b.wpoff", "WPOFF 1 0 0\n0 0 2\n");
  const auto others = bench.folder.write("c.poff", "POFF 1 0 0\n7 8\n");
  for (const auto& files : {std::vector{samples, balls}, std::vector{balls, samples}}) {
    const auto outcome = bench.open(files);
    REQUIRE_FALSE(outcome.error);
    CHECK(outcome.files == files);
    CHECK(outcome.left_out == 0);
    CHECK(bench.editor.document().sample_count() == 1);
    CHECK(bench.editor.document().ball_count() == 1);
    CHECK(bench.files.sample_file() == samples);
    CHECK(bench.files.ball_file() == balls);
    CHECK_FALSE(bench.editor.is_modified());
  }
  // What the first brought is not replaced by the next.
  const auto outcome = bench.open({samples, others, balls});
  CHECK(outcome.files == std::vector{samples, balls});
  CHECK(outcome.left_out == 1);
  CHECK(bench.editor.document().position(SampleSlot(0)) == Vec2{5, 6});
  bench.add_sample();
  bench.add_ball();
  REQUIRE(bench.save());
  CHECK(contents_of(samples) == "POFF 2 0 0\n5 6\n7 8\n");
  CHECK(contents_of(balls) == "WPOFF 2 0 0\n0 0 2\n1 2 3\n");
  CHECK(contents_of(others) == "POFF 1 0 0\n7 8\n");

  // One of them cannot be read: nothing is opened.
  const auto digest = bench.editor.document().digest();
  const auto missing = bench.open({others, bench.folder / "missing.wpoff"});
  REQUIRE(missing.error);
  CHECK(missing.error->file == (bench.folder / "missing.wpoff").string());
  CHECK(bench.editor.document().digest() == digest);
  CHECK(bench.files.sample_file() == samples);
}

TEST_CASE("a bad file of balls leaves the document as it is") {
  Bench bench;
  const auto good = bench.folder.write("a.wpoff", "WPOFF 1 0 0\n0 0 2\n");
  REQUIRE_FALSE(bench.open(good).error);
  const auto outcome = bench.open(bench.folder.write("b.wpoff", "WPOFF 1 0 0\n0 0 -2\n"));
  REQUIRE(outcome.error);
  CHECK(outcome.error->line == 2);
  CHECK(bench.editor.document().ball_count() == 1);
  CHECK(bench.files.file() == good);
}

TEST_CASE("a session holds samples, balls and what can be undone") {
  Bench bench;
  REQUIRE_FALSE(bench.open(bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n")).error);
  bench.add_sample();
  bench.add_ball();
  const auto file = bench.folder.path() / "a.json";
  REQUIRE(bench.save_as(file));
  CHECK_FALSE(bench.editor.is_modified());
  CHECK(bench.files.title() == "a.json");
  bench.add_ball();
  CHECK(bench.files.unsaved().samples);
  REQUIRE(bench.save());
  CHECK(bench.is_complete());
  const std::uint64_t digest = bench.editor.document().digest();

  bench.files.start_empty();
  CHECK_FALSE(bench.files.has_session_file());
  const auto outcome = bench.open(file);
  REQUIRE_FALSE(outcome.error);
  REQUIRE(outcome.session != nullptr);
  CHECK(outcome.samples == 2);
  CHECK(outcome.balls == 2);
  CHECK(bench.editor.document().digest() == digest);
  CHECK_FALSE(bench.editor.is_modified());
  CHECK(bench.files.file() == file);
  bench.editor.undo();
  bench.editor.undo();
  CHECK(bench.editor.document().ball_count() == 0);
  CHECK(bench.editor.document().sample_count() == 2);

  // The samples alone are saved: what a session held besides counts as unsaved.
  REQUIRE(bench.save_as(bench.folder.path() / "b.poff"));
  CHECK_FALSE(bench.files.has_session_file());
  CHECK_FALSE(bench.files.unsaved().samples);
}

TEST_CASE("a session that cannot be written leaves file, title and mark as they were") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  REQUIRE_FALSE(bench.open(file).error);
  bench.add_sample();
  CHECK_FALSE(bench.save_as(bench.folder.path() / "no" / "such" / "folder" / "a.json"));
  CHECK(bench.files.file() == file);
  CHECK(bench.files.title() == "a.poff");
  CHECK(bench.editor.is_modified());
  REQUIRE(bench.save());
  CHECK(contents_of(file) == "POFF 2 0 0\n5 6\n7 8\n");
}

TEST_CASE("what is edited while a file is written stays unsaved") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  REQUIRE_FALSE(bench.open(file).error);
  bench.add_sample();
  bench.files.save();
  bench.add_sample();
  REQUIRE(bench.saved());
  CHECK(bench.editor.is_modified());
  CHECK(contents_of(file) == "POFF 2 0 0\n5 6\n7 8\n");
  bench.editor.undo();
  CHECK_FALSE(bench.editor.is_modified());
  CHECK(bench.is_complete());
}

TEST_CASE("a second save waits for the first, and the destructor for both") {
  const test::TemporaryFolder folder;
  {
    Bench bench;
    for (int i = 0; i < 20; ++i) {
      bench.add_sample();
      bench.files.save_as(folder / ("file" + std::to_string(i) + ".poff"));
    }
  }
  for (int i = 0; i < 20; ++i)
    CHECK(contents_of(folder / ("file" + std::to_string(i) + ".poff")).starts_with("POFF " + std::to_string(i + 1)));
}

TEST_CASE("a save that ends after something else was opened marks nothing of it") {
  Bench bench;
  REQUIRE_FALSE(bench.open(bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n")).error);
  bench.add_sample();
  bench.files.save_as(bench.folder / "b.json");
  bench.files.start_empty();
  bench.add_sample();
  REQUIRE(bench.saved());
  CHECK(bench.editor.is_modified());
  CHECK(bench.files.title() == "Untitled");
  CHECK(bench.files.file().empty());
}

TEST_CASE("a session that another window has saved is not overwritten, and the difference is shown") {
  Bench bench;
  bench.add_sample();
  const auto file = bench.folder / "a.json";
  REQUIRE(bench.save_as(file));
  Bench other;
  REQUIRE_FALSE(other.open(file).error);
  for (int i = 0; i < 2; ++i) other.add_sample();
  other.add_ball();
  REQUIRE(other.save());
  const std::string theirs = contents_of(file);

  bench.add_ball();
  bench.files.save();
  auto saved = bench.files.finish_saving();
  REQUIRE(saved);
  REQUIRE(saved->conflict);
  CHECK_FALSE(saved->error);
  CHECK(saved->conflict->mine == Holdings{1, 1, 2});
  CHECK(saved->conflict->theirs == Holdings{3, 1, 4});
  CHECK(saved->conflict->shared_edits == 1);
  CHECK(contents_of(file) == theirs);
  CHECK(bench.editor.is_modified());

  // It was changed once more before the answer.
  other.add_ball();
  REQUIRE(other.save());
  bench.files.overwrite(*saved->conflict);
  saved = bench.files.finish_saving();
  REQUIRE(saved->conflict);
  CHECK(saved->conflict->theirs == Holdings{3, 2, 5});
  bench.files.overwrite(*saved->conflict);
  REQUIRE(bench.saved());
  CHECK_FALSE(bench.editor.is_modified());

  // Each window knows what it wrote itself.
  bench.add_sample();
  REQUIRE(bench.save());
  other.add_sample();
  other.files.save();
  CHECK(other.files.finish_saving()->conflict);
  REQUIRE(other.save_as(other.folder / "b.json"));
  CHECK_FALSE(other.editor.is_modified());
  other.add_sample();
  REQUIRE(other.save());
}

TEST_CASE("of two files none is written while there is a question about the other") {
  Bench bench;
  const auto samples = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  const auto balls = bench.folder.write("a.wpoff", "WPOFF 1 0 0\n0 0 2\n");
  REQUIRE_FALSE(bench.open({samples, balls}).error);
  bench.add_sample();
  bench.add_ball();
  bench.folder.write("a.wpoff", "WPOFF 2 0 0\n0 0 2\n0 0 3\n");
  bench.files.save();
  const auto saved = bench.files.finish_saving();
  REQUIRE(saved->conflict);
  CHECK(saved->conflict->file == balls);
  CHECK(saved->conflict->theirs == Holdings{0, 2});
  CHECK(contents_of(samples) == "POFF 1 0 0\n5 6\n");
  bench.files.overwrite(*saved->conflict);
  REQUIRE(bench.saved());
  CHECK(contents_of(samples) == "POFF 2 0 0\n5 6\n7 8\n");
  CHECK(contents_of(balls) == "WPOFF 2 0 0\n0 0 2\n1 2 3\n");
  CHECK(bench.is_complete());
}

TEST_CASE("a file that is gone is written anew, and one that is something else now is asked about") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n5 6\n");
  REQUIRE_FALSE(bench.open(file).error);
  std::filesystem::remove(file);
  REQUIRE(bench.save());
  CHECK(contents_of(file) == "POFF 1 0 0\n5 6\n");

  bench.folder.write("a.poff", "no samples at all");
  bench.files.save();
  auto saved = bench.files.finish_saving();
  REQUIRE(saved->conflict);
  CHECK_FALSE(saved->conflict->theirs);
  CHECK_FALSE(saved->conflict->problem.empty());

  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  bench.files.save();
  saved = bench.files.finish_saving();
  REQUIRE(saved->conflict);
  bench.files.overwrite(*saved->conflict);
  saved = bench.files.finish_saving();
  REQUIRE(saved->error);
  CHECK_THAT(saved->error->message(), Catch::Contains("Is a directory"));
}

TEST_CASE("a document from a picture has no file yet, and the picture stays as it is") {
  Bench bench;
  SampleData data;
  data.positions = {{0, 0}, {1, 0}, {0.1, 3}};
  figure::Figure figure{.width = 10, .height = 10};
  figure.session = packed_session({.data = std::make_shared<const SampleData>(data)}).value();
  const std::string bytes = figure::svg_of(figure).value();
  const auto picture = bench.folder.write("a.svg", bytes);
  const auto outcome = bench.open(picture);
  REQUIRE_FALSE(outcome.error);
  CHECK(outcome.session != nullptr);
  CHECK(outcome.samples == 3);
  CHECK(bench.files.title() == "a.svg");
  CHECK(bench.files.file().empty());
  CHECK_FALSE(bench.files.has_session_file());
  bench.add_sample();
  const auto session = bench.folder / "a.json";
  REQUIRE(bench.save_as(session));
  CHECK(bench.files.file() == session);
  CHECK(contents_of(picture) == bytes);
}
