// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/prepared_document.h"
#include "tests/model/files/files_bench.h"

using namespace mes;
using mes::test::contents_of;
using Bench = mes::test::FilesBench;

TEST_CASE("the degrees of a map are projected or kept, as it is opened") {
  Bench bench;
  const auto map =
      bench.folder.write("a.geojson", R"({"type": "MultiPoint", "coordinates": [[10, 60], [12.5, 61]]})");
  const auto points = bench.folder.write("a.poff", "POFF 1 0 0\n1 2\n");
  CHECK(bench.open({map}, MapDegrees::kept).degrees == MapDegrees::kept);
  CHECK(bench.editor.document().position(SampleSlot{1}) == Vec2{12.5, 61});
  CHECK(bench.open(map).degrees == MapDegrees::projected);
  CHECK(bench.editor.document().position(SampleSlot{1}) != Vec2{12.5, 61});
  // Each opening is asked anew, and what has no degrees says so.
  CHECK(bench.open({points}, MapDegrees::kept).degrees == std::nullopt);
}

TEST_CASE("a file that is read while the document is edited takes its place, with numbers never given before") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 2 0 0\n1 2\n3 4\n");
  const auto session = bench.folder.write(
      "a.json", R"({"mesecina":"session","schema":1,"data":{"samples":[0,0,1,1]},"timeline":[{"edit":{"name":"more",)"
                R"("insert":[5,5]}}]})");
  for (const auto& opened : {file, session}) {
    for (const int edits : {0, 1, 2, 5}) {
      INFO(opened << ", " << edits);
      bench.add_sample();
      const SampleId last = bench.editor.document().id(bench.editor.index().nearest({7, 8}, 0.5));
      std::uint64_t revision = bench.editor.document().revision();
      bench.files.open(opened);
      std::optional<DocumentFiles::Outcome> outcome;
      for (int edit = 0; !outcome; ++edit) {
        // Before each look the document changes once more.
        if (edit < edits) {
          bench.add_sample();
          revision = bench.editor.document().revision();
        }
        bench.wait_for_reading();
        outcome = bench.files.poll();
        CHECK(bench.files.would_lose_work() == (edit < edits));
        bench.files.give_up_work();
      }
      REQUIRE_FALSE(outcome->error);
      const Document& document = bench.editor.document();
      CHECK(document.sample_count() == (opened == file ? 2 : 3));
      CHECK(outcome->samples == document.sample_count());
      CHECK(document.revision() > revision);
      for (const SampleSlot slot : document.slots_in_input_order()) CHECK(document.id(slot) > last);
      CHECK_FALSE(bench.editor.is_modified());
      CHECK(bench.editor.can_undo() == (opened == session));
      CHECK(bench.editor.index().size() == document.sample_count());
      const SampleSlot found = bench.editor.index().nearest(document.position(SampleSlot{1}), 0.25);
      CHECK(found == SampleSlot{1});
      bench.editor.undo();
      CHECK(document.sample_count() == 2);
    }
  }
}

TEST_CASE("what is done while a file is read is not lost unless that is wanted") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 2 0 0\n1 2\n3 4\n");
  const Document& document = bench.editor.document();
  bench.add_sample();
  const auto read_while = [&](const std::filesystem::path& opened, const auto& work) {
    bench.files.open(opened);
    work();
    bench.wait_for_reading();
    return bench.files.poll();
  };
  const auto is_held_back = [&](const auto& work) {
    return !read_while(file, work) && bench.files.would_lose_work();
  };

  REQUIRE(is_held_back([&] { bench.add_sample(); }));
  CHECK(bench.files.is_reading());
  CHECK(bench.files.reading_name() == "a.poff");
  CHECK_FALSE(bench.files.poll());
  CHECK(document.sample_count() == 2);
  // It is refused.
  bench.files.cancel_reading();
  CHECK_FALSE(bench.files.is_reading());
  CHECK_FALSE(bench.files.would_lose_work());
  CHECK_FALSE(bench.files.poll());
  bench.editor.undo();
  CHECK(document.sample_count() == 1);
  bench.editor.redo();

  // Another one is opened instead.
  REQUIRE(is_held_back([&] { bench.add_ball(); }));
  CHECK(read_while(file, [] {})->samples == 2);
  CHECK(document.ball_count() == 0);
  CHECK_FALSE(bench.files.would_lose_work());

  // It is saved.
  REQUIRE(is_held_back([&] { bench.add_sample(); }));
  REQUIRE(bench.save_as(bench.folder / "b.poff"));
  CHECK_FALSE(bench.files.would_lose_work());
  CHECK(bench.files.poll()->samples == 2);
  CHECK(contents_of(bench.folder / "b.poff") == "POFF 3 0 0\n1 2\n3 4\n7 8\n");

  // It is taken back, or made new by `start_empty`.
  CHECK(read_while(file, [&] {
    bench.add_sample();
    bench.editor.undo();
  }));
  REQUIRE(is_held_back([&] { bench.add_sample(); }));
  bench.files.start_empty();
  CHECK_FALSE(bench.files.is_reading());
  CHECK(document.is_empty());

  // A lesson is work too; a file that cannot be read takes no place.
  CHECK(is_held_back([&] { bench.editor.set_lesson({.title = "words"}); }));
  const auto refused = read_while(bench.folder / "none.poff", [&] { bench.add_sample(); });
  REQUIRE(refused);
  CHECK(refused->error);
  CHECK(document.sample_count() == 1);
}

TEST_CASE("an evolution that plays on while a file is read is asked about once") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n1 2\n");
  bench.add_sample();
  const auto evolve = [&](double x) { REQUIRE(bench.editor.evolve(std::vector{Vec2{x, 8}}, {}, "evolution")); };
  const auto is_held_back = [&](const auto& work) {
    bench.files.open(file);
    work();
    bench.wait_for_reading();
    const bool is_taken = bench.files.poll().has_value();
    CHECK(is_taken != bench.files.would_lose_work());
    return !is_taken;
  };
  REQUIRE(is_held_back([&] {
    evolve(1);
    evolve(2);
  }));
  bench.files.give_up_work();
  evolve(3);
  CHECK_FALSE(bench.files.would_lose_work());
  bench.add_sample();
  CHECK(bench.files.would_lose_work());
  bench.editor.undo();
  CHECK_FALSE(bench.files.would_lose_work());
  CHECK(bench.files.poll());
  CHECK(bench.editor.document().sample_count() == 1);
  CHECK_FALSE(bench.editor.can_undo());
}

TEST_CASE("what an evolution changes while a file is read is asked about where nothing was to be lost before") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n1 2\n");
  bench.add_sample();
  const auto evolve = [&](double x) { REQUIRE(bench.editor.evolve(std::vector{Vec2{x, 8}}, {}, "evolution")); };
  evolve(1);
  REQUIRE(bench.save_as(bench.folder / "b.poff"));
  REQUIRE_FALSE(bench.editor.is_modified());
  bench.files.open(file);
  evolve(2);
  bench.wait_for_reading();
  CHECK_FALSE(bench.files.poll());
  CHECK(bench.files.would_lose_work());
  bench.files.give_up_work();
  evolve(3);
  CHECK_FALSE(bench.files.would_lose_work());
  CHECK(bench.files.poll());
}

TEST_CASE("samples that are added before each look do not put off for good what was read") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n1 2\n");
  bench.files.open(file);
  const std::vector<Vec2> many(70'000, Vec2{1, 1});
  std::optional<DocumentFiles::Outcome> outcome;
  int looks = 0;
  for (; !outcome && looks < 10; ++looks) {
    REQUIRE(bench.editor.insert(many, "many"));
    bench.files.give_up_work();
    bench.wait_for_reading();
    outcome = bench.files.poll();
  }
  REQUIRE(outcome);
  CHECK(looks == 2);
  CHECK(bench.editor.document().sample_count() == 1);
}

TEST_CASE("where ids run out, files are opened as long as there are some, and refused then") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 2 0 0\n1 2\n3 4\n");
  Document start = bench.editor.document().successor();
  // Each takes half of what remains.
  for (int i = 0; i < 22; ++i) start = successor_of(start, {.revisions = 1, .ids = ~std::uint32_t{0}});
  DocumentReplay replay(start);
  const auto none = std::make_shared<const SampleData>();
  REQUIRE(replay.begin(*none));
  PreparedDocument near_the_end(std::move(replay), none);
  bench.editor.load(near_the_end);
  int opened = 0;
  std::optional<Error> refusal;
  for (; opened < 100 && !refusal; ++opened) refusal = bench.open(file).error;
  CHECK(opened > 5);
  REQUIRE(refusal);
  CHECK(refusal->text.find("too many samples in one session") != std::string::npos);
  CHECK(bench.editor.document().sample_count() == 2);
}

TEST_CASE("more samples than numbers were left for are made while a file is read") {
  Bench bench;
  const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n1 2\n");
  bench.files.open(file);
  std::vector<Vec2> many(70'000);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = {static_cast<double>(i), 1};
  REQUIRE(bench.editor.insert(many, "many"));
  const Document& document = bench.editor.document();
  const SampleId last = document.id(bench.editor.index().nearest(many.back(), 0.5));
  bench.files.give_up_work();
  std::optional<DocumentFiles::Outcome> outcome;
  while (!outcome) outcome = bench.files.poll();
  REQUIRE_FALSE(outcome->error);
  REQUIRE(document.sample_count() == 1);
  CHECK(document.id(document.slots_in_input_order().front()) > last);
}

TEST_CASE("a reading says how far it is, and does not go back") {
  Bench bench;
  std::string samples = "POFF 40000 0 0\n";
  std::string balls = "WPOFF 40000 0 0\n";
  for (int i = 0; i < 40'000; ++i) {
    samples += std::to_string(i) + " 1\n";
    balls += std::to_string(i) + " 2 0.5\n";
  }
  bench.files.open(std::vector{bench.folder.write("a.poff", samples), bench.folder.write("a.wpoff", balls)});
  double before = 0.0;
  while (!bench.files.has_read()) {
    const double now = bench.files.reading_progress();
    REQUIRE(now >= before);
    before = now;
  }
  CHECK(bench.files.reading_progress() > 0.95);
  CHECK(bench.files.reading_progress() <= 1.0);
  CHECK(bench.files.poll()->balls == 40'000);
  CHECK(bench.files.reading_progress() == 0.0);
}

TEST_CASE("recovered work has no file and counts as unsaved") {
  Bench bench;
  const auto work =
      std::make_shared<const Session>(Session{.title = "x",
                                              .data = std::make_shared<SampleData>(SampleData{{{1, 2}}, {}, {}}),
                                              .entries = {TimelineEdit{.name = "more", .inserted = {{3, 4}}}}});
  // What is there stays if it is stopped, or edited meanwhile.
  bench.add_sample();
  bench.files.recover(work);
  bench.files.cancel_reading();
  CHECK_FALSE(bench.files.poll());
  bench.files.recover(work);
  bench.add_ball();
  bench.wait_for_reading();
  CHECK_FALSE(bench.files.poll());
  CHECK(bench.files.would_lose_work());
  CHECK(bench.editor.document().ball_count() == 1);

  bench.files.recover(work);
  const DocumentFiles::Outcome outcome = bench.outcome();
  REQUIRE_FALSE(outcome.error);
  CHECK(outcome.is_recovered);
  CHECK(outcome.session == work);
  CHECK(bench.editor.document().sample_count() == 2);
  CHECK(bench.editor.undo_name() == "more");
  CHECK(bench.files.title() == "x");
  CHECK(bench.files.file().empty());
  CHECK(bench.editor.is_modified());
  CHECK(bench.files.unsaved().samples);
  REQUIRE(bench.save_as(bench.folder.path() / "x.poff"));
  CHECK_FALSE(bench.editor.is_modified());
}

TEST_CASE("parts of recovered work that a file of samples does not hold stay unsaved") {
  const Annotations annotations{{.text = "here", .anchors = {{}}}};
  const Lesson lesson{.steps = {{.caption = "one"}}};
  for (const bool has_lesson : {false, true}) {
    for (const bool has_annotation : {false, true}) {
      Session work{.data = std::make_shared<SampleData>(SampleData{{{1, 2}}, {}, {}})};
      if (has_lesson) work.lesson = lesson;
      if (has_annotation) work.entries.push_back(TimelineEdit{.name = "Annotate", .annotations = annotations});
      Bench bench;
      const auto file = bench.folder.write("a.poff", "POFF 1 0 0\n1 2\n");
      bench.files.recover(std::make_shared<const Session>(work), SourceFile{file, fingerprint_of(contents_of(file))});
      REQUIRE_FALSE(bench.outcome().error);
      CHECK(bench.files.file() == file);
      CHECK(bench.editor.is_modified());
      REQUIRE(bench.save());
      CHECK(bench.files.unsaved().lesson == has_lesson);
      CHECK(bench.files.unsaved().annotations == has_annotation);
      CHECK_FALSE(bench.files.unsaved().samples);
      CHECK(bench.editor.is_modified() == (has_lesson || has_annotation));
      REQUIRE(bench.save_as(bench.folder / "a.json"));
      CHECK(bench.is_complete());
      CHECK_FALSE(bench.editor.is_modified());
    }
  }
}

TEST_CASE("recovered work is saved in the file in which it was kept, unless that has changed meanwhile") {
  for (const bool has_changed : {false, true}) {
    const test::TemporaryFolder folder;
    std::optional<SourceFile> kept;
    {
      Bench bench;
      bench.add_sample();
      CHECK_FALSE(bench.files.kept_in());
      REQUIRE(bench.save_as(folder.path() / "a.json"));
      kept = bench.files.kept_in();
      REQUIRE(kept);
      CHECK(kept->path == folder.path() / "a.json");
    }
    if (has_changed) folder.write("a.json", "{}");
    Bench bench;
    const auto work = std::make_shared<const Session>(
        Session{.title = "old", .data = std::make_shared<SampleData>(SampleData{{{1, 2}}, {}, {}})});
    bench.files.recover(work, kept);
    REQUIRE_FALSE(bench.outcome().error);
    CHECK(bench.files.title() == "a.json");
    CHECK(bench.files.has_session_file());
    CHECK(bench.editor.is_modified());
    bench.files.save();
    const auto saved = bench.files.finish_saving();
    REQUIRE(saved);
    CHECK_FALSE(saved->error);
    CHECK(saved->conflict.has_value() == has_changed);
    CHECK(bench.editor.is_modified() == has_changed);
    // By its ending this would be a file of samples, which would replace the session.
    bench.files.open(folder.write("a.session", write_session(*work)));
    REQUIRE_FALSE(bench.outcome().error);
    CHECK(bench.files.has_session_file());
    CHECK_FALSE(bench.files.kept_in());
  }
}

TEST_CASE("messages about a file that was opened name it once, without its folders") {
  std::vector<std::string> messages{"/home/a/map.json: one", "/home/a/map.json: two", "/home/a/map.json:3:4: three",
                                    "four"};
  name_briefly(messages, "/home/a/map.json");
  CHECK(messages == std::vector<std::string>{"map.json: one", "two", "map.json:3:4: three", "four"});
  // The option of the command line is not a matter of the window.
  Bench bench;
  const auto map = bench.folder.write(
      "a.geojson", R"({"type": "Polygon", "coordinates": [[[9, 50], [11, 50], [11, 51], [9, 51], [9, 50]]]})");
  const auto outcome = bench.open(map);
  REQUIRE_FALSE(outcome.error);
  CHECK(outcome.has_added_samples);
  for (const std::string& warning : outcome.warnings) CHECK_FALSE(warning.contains("--"));
}

TEST_CASE("a document is left although a file is still being waited for") {
  const test::TemporaryFolder folder;
  const auto pipe = folder / "pipe.poff";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  Bench bench;
  bench.files.open(pipe);
  CHECK(bench.files.is_reading());
  bench.files.open(pipe);
  bench.files.start_empty();
  CHECK_FALSE(bench.files.is_reading());
  bench.files.open(pipe);
}
