// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "app/export/lessons/lesson_files.h"
#include "app/recording/lesson_export.h"
#include "core/builtins/builtins.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using mes::test::contents_of;
using mes::test::TemporaryFolder;

namespace {

Session lesson_of_three() {
  Session session;
  session.title = "Square";
  session.data = std::make_shared<const SampleData>(SampleData{.positions = {{0, 0}, {4, 0}, {4, 3}, {0, 3}}});
  const LayerStyle style;
  session.lesson = {"Square",
                    {{.caption = "# One", .layers = {{{"points", true, style}}, {}}, .seconds = 0.5},
                     {.caption = "# Two", .layers = {{{"voronoi", true, style}}, {}}, .seconds = 0.5},
                     {.caption = "# Three", .layers = {{{"points", true, style}}, {}}, .seconds = 0.5}}};
  return session;
}

/// Exports as the window does, and waits for the end as it does.
struct ExportBench {
  std::atomic<int> wakes = 0;
  LessonExport lesson{Waker([this] {
    ++wakes;
    wakes.notify_all();
  })};

  void begin(const std::filesystem::path& file) {
    lesson.begin(std::shared_ptr<const Registry>(std::shared_ptr<const Registry>(), &builtins()),
                 std::make_shared<const Session>(lesson_of_three()), file);
  }
  LessonExport::Done done() {
    for (;;) {
      const int seen = wakes;
      if (auto out = lesson.take_done()) return std::move(*out);
      wakes.wait(seen);
    }
  }
};

/// A program in the place of ffmpeg, which is not on every machine. It counts the pictures in the folder of the list.
struct VideoMakerOnPath {
  TemporaryFolder folder;
  std::string before = std::getenv("PATH");

  VideoMakerOnPath() {
    const std::string file =
        folder.write("ffmpeg",
                     "#!/bin/sh\n"
                     "for word; do case \"$previous\" in -i) input=$word;; esac; previous=$word; done\n"
                     "ls \"$(dirname \"$input\")\" | grep -c 'png$' > \"$(dirname \"$0\")/pictures\"\n"
                     "echo made > \"${previous#file:}\"\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("PATH", (folder.path().string() + ':' + before).c_str(), 1);
  }
  ~VideoMakerOnPath() { setenv("PATH", before.c_str(), 1); }
};

LessonExport::Done exported(ExportBench& bench, const std::filesystem::path& file) {
  bench.begin(file);
  LessonExport::Done out = bench.done();
  if (!out.outcome) UNSCOPED_INFO(out.outcome.error().message());
  return out;
}

}  // namespace

TEST_CASE("the window exports the same bytes as the command line") {
  const TemporaryFolder folder;
  folder.write("square.json", write_session(lesson_of_three()));
  for (const std::string extension : {"pdf", "html"}) {
    INFO(extension);
    ExportBench bench;
    const std::string file = folder / ("window." + extension);
    bench.begin(file);
    CHECK(bench.lesson.file() == file);
    const LessonExport::Done done = bench.done();
    REQUIRE(done.outcome);
    CHECK(done.remarks.empty());
    CHECK_FALSE(bench.lesson.is_under_way());
    const std::string other = folder / ("command." + extension);
    REQUIRE(mes::test::run({"lesson", folder / "square.json", "--" + extension, other}).exit_code == 0);
    REQUIRE_FALSE(contents_of(other).empty());
    CHECK(contents_of(file) == contents_of(other));
  }
}

TEST_CASE("a lesson is exported as a video of a picture per step, and leaves nothing else") {
  const VideoMakerOnPath maker;
  const TemporaryFolder folder;
  ExportBench bench;
  REQUIRE(exported(bench, folder / "square.webm").outcome);
  CHECK(contents_of(folder / "square.webm") == "made\n");
  CHECK(folder.file_count() == 1);
  CHECK(contents_of(maker.folder / "pictures") == "3\n");
}

TEST_CASE("what cannot be written gives one line, and no file") {
  const TemporaryFolder folder;
  for (const char* const name : {"square.txt", "square", "no-such-folder/square.pdf", "no-such-folder/square.mp4"}) {
    INFO(name);
    ExportBench bench;
    bench.begin(folder / name);
    const LessonExport::Done done = bench.done();
    REQUIRE_FALSE(done.outcome);
    CHECK(done.outcome.error().message().find(name) != std::string::npos);
    CHECK(done.outcome.error().message().find('\n') == std::string::npos);
    CHECK(folder.file_count() == 0);
  }
}

TEST_CASE("an export that is cancelled ends at once, and its file is complete or not there") {
  const Session session = lesson_of_three();
  for (std::size_t last = 0; last < 3; ++last) {
    std::stop_source stop;
    std::size_t begun = 0;
    const auto made = make_lesson_files(builtins(), session, {.steps = {0, 1, 2}, .wants_pdf = true},
                                        {.show =
                                             [&](const std::string&, double) {
                                               if (begun++ == last) stop.request_stop();
                                             },
                                         .stop = stop.get_token()});
    REQUIRE_FALSE(made);
    CHECK(made.error().code == ErrorCode::cancelled);
    CHECK(begun == last + 1);
  }
  // A computation that is stopped is no step either.
  std::stop_source stopped;
  stopped.request_stop();
  auto printer = LessonPrinter::make(builtins(), session, {});
  REQUIRE(printer);
  const auto page = printer->page(1, stopped.get_token());
  REQUIRE_FALSE(page);
  CHECK(page.error().code == ErrorCode::cancelled);

  const TemporaryFolder folder;
  ExportBench bench;
  bench.begin(folder / "square.html");
  bench.lesson.cancel();
  const LessonExport::Done done = bench.done();
  if (!done.outcome) CHECK(done.outcome.error().code == ErrorCode::cancelled);
  CHECK(std::filesystem::exists(folder / "square.html") == done.outcome.has_value());
  // The next one is not cancelled with it.
  bench.begin(folder / "square.html");
  CHECK(bench.done().outcome);
  CHECK(contents_of(folder / "square.html").ends_with("</html>\n"));
}
