// SPDX-License-Identifier: GPL-3.0-or-later
// With a program in the place of ffmpeg, which is not there on every machine.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/recording/frame_writer.h"
#include "app/recording/video.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/bell.h"
#include "tests/support/eventually.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

class Path {
 public:
  explicit Path(const std::string& value) : before_(std::getenv("PATH")) { setenv("PATH", value.c_str(), 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

struct Studio {
  TemporaryFolder folder;
  Take take = *begin_take(folder.path(), {2, 2, 30.0});
  Studio() {
    FrameWriter writer(take);
    for (int i = 0; i < 3; ++i) writer.push({render::Image{2, 2, std::vector<std::uint8_t>(16, 200)}, {}});
    REQUIRE(writer.finish());
  }
  void program(const std::string& script) const {
    const fs::path file = folder.write("ffmpeg", "#!/bin/sh\n" + script);
    ::chmod(file.c_str(), 0755);
  }
};

// The last argument without "file:".
const std::string kOutput = "for last; do :; done; out=\"${last#file:}\"\n";

}  // namespace

TEST_CASE("the program gets the frames, the rate and a place to write, and the video appears whole") {
  const Studio studio;
  studio.program(kOutput + "[ -f 00003.png ] || exit 2\necho \"$@\" > \"$out\"\n");
  const Path path(studio.folder.path().string() + ":/usr/bin:/bin");
  REQUIRE(has_video_maker());
  const fs::path video = studio.folder / "a film.mp4";
  REQUIRE(make_video(studio.take.folder, 24.0, video));
  const std::string words = contents_of(video);
  CHECK_THAT(words,
             Catch::Contains("-framerate 24 ") && Catch::Contains("-frames:v 3 ") && Catch::Contains("libx264"));
  REQUIRE(make_video(studio.take.folder, 24.0, studio.folder / "film.webm"));
  CHECK_THAT(contents_of(studio.folder / "film.webm"), Catch::Contains("libvpx-vp9"));
}

TEST_CASE("in real time each frame is seen as long as it was recorded") {
  const Studio studio;
  Manifest manifest{.format = {4, 4, 30.0}, .complete = true};
  for (const double seconds : {0.5, 2.0, 2.01}) manifest.frames.push_back({.what = "", .seconds = seconds});
  std::ofstream(studio.take.folder / kManifestName) << manifest_text(manifest);
  studio.program(kOutput + "cat frames.ffconcat > \"$out\"\necho \"$@\" >> \"$out\"\n");
  const Path path(studio.folder.path().string() + ":/usr/bin:/bin");
  const fs::path video = studio.folder / "film.mp4";
  REQUIRE(make_video(studio.take.folder, 25.0, video, {}, {.pace = VideoPace::real_time}));
  const std::string words = contents_of(video);
  CHECK_THAT(words, Catch::Contains("file 00001.png\nduration 1.500000\nfile 00002.png\nduration 0.040000\n"
                                    "file 00003.png\nduration 1.000000\n-"));
  CHECK_THAT(words, Catch::Contains("-f concat ") && Catch::Contains("fps=25,") && Catch::Contains(" -t 2.540000 ") &&
                        !Catch::Contains("-framerate"));
  CHECK_FALSE(fs::exists(studio.take.folder / "frames.ffconcat"));
  // A take without times has a steady pace.
  fs::remove(studio.take.folder / kManifestName);
  studio.program(kOutput + "echo \"$@\" > \"$out\"\n");
  REQUIRE(make_video(studio.take.folder, 25.0, video, {}, {.pace = VideoPace::real_time}));
  CHECK_THAT(contents_of(video), Catch::Contains("-framerate 25 "));
}

TEST_CASE("what the program complains of is reported in one line, and nothing is left behind") {
  const Studio studio;
  studio.program(kOutput + "echo half > \"$out\"\necho first >&2\necho 'No such encoder' >&2\nexit 1\n");
  const Path path(studio.folder.path().string() + ":/usr/bin:/bin");
  const std::size_t before = studio.folder.file_count();
  const auto done = make_video(studio.take.folder, 30.0, studio.folder / "film.mp4");
  REQUIRE_FALSE(done);
  CHECK_THAT(done.error().message(), Catch::Contains("film.mp4: ffmpeg could not make the video: No such encoder"));
  CHECK(studio.folder.file_count() == before);
  CHECK_FALSE(make_video(studio.folder / "nowhere", 30.0, studio.folder / "film.mp4"));
}

TEST_CASE("without the program there is one line") {
  const Studio studio;
  const Path path(studio.folder.path().string());
  CHECK_FALSE(has_video_maker());
  const auto done = make_video(studio.take.folder, 30.0, studio.folder / "film.mp4");
  REQUIRE_FALSE(done);
  CHECK(done.error().code == ErrorCode::cannot_write);
  CHECK_THAT(done.error().message(), Catch::Contains("ffmpeg"));
}

TEST_CASE("a video being made can be cancelled") {
  const Studio studio;
  studio.program(kOutput + "echo half > \"$out\"\nexec sleep 1000\n");
  const Path path(studio.folder.path().string() + ":/usr/bin:/bin");
  const std::size_t before = studio.folder.file_count();
  Bell bell;
  VideoJob job(bell.ring());
  job.start(studio.take.folder, 30.0, studio.folder / "film.mp4");
  REQUIRE(eventually([&] { return studio.folder.file_count() != before; }));
  CHECK_FALSE(job.take_result().has_value());
  job.cancel();
  std::optional<Expected<void>> result;
  bell.wait_until([&] { return (result = job.take_result()).has_value(); });
  REQUIRE_FALSE(result->has_value());
  CHECK(result->error().code == ErrorCode::cancelled);
  CHECK_FALSE(job.is_running());
  CHECK(studio.folder.file_count() == before);
}

TEST_CASE("the program writes to a new file that no link leads to, and a target that is a link stays one") {
  const Studio studio;
  // It tells where it writes, and whether that was there before, empty and a file.
  studio.program(kOutput +
                 "[ -f \"$out\" ] && [ ! -L \"$out\" ] && [ ! -s \"$out\" ] || exit 3\n"
                 "echo \"$out\" > \"$out\"\n");
  const Path path(studio.folder.path().string() + ":/usr/bin:/bin");
  const fs::path video = studio.folder / "film.mp4";
  fs::create_directory(studio.folder / "elsewhere");
  fs::create_symlink("elsewhere/real.mp4", video);
  REQUIRE(make_video(studio.take.folder, 30.0, video));
  CHECK(fs::is_symlink(video));
  const std::string first = contents_of(studio.folder / "elsewhere" / "real.mp4");
  CHECK(fs::path(first).parent_path() == fs::canonical(studio.folder / "elsewhere"));
  REQUIRE(make_video(studio.take.folder, 30.0, video));
  // Another name each time.
  CHECK(contents_of(video) != first);
  CHECK(std::distance(fs::directory_iterator(studio.folder / "elsewhere"), {}) == 1);
}

TEST_CASE("a program that puts another file in the place of the one it was given is not believed") {
  const Studio studio;
  studio.program(kOutput + "rm \"$out\"\nln -s /etc/hostname \"$out\"\n");
  const Path path(studio.folder.path().string() + ":/usr/bin:/bin");
  CHECK_FALSE(make_video(studio.take.folder, 30.0, studio.folder / "film.mp4"));
  CHECK_FALSE(fs::exists(studio.folder / "film.mp4"));
}

TEST_CASE("a video that cannot be written is refused before it is made") {
  const Studio studio;
  studio.program(kOutput + "touch " + (studio.folder / "was-run").string() + "\n");
  const Path path(studio.folder.path().string() + ":/usr/bin:/bin");
  REQUIRE(check_video(studio.folder / "film.mp4"));
  CHECK_FALSE(fs::exists(studio.folder / "film.mp4"));
  fs::create_directory(studio.folder / "folder.mp4");
  REQUIRE(::mkfifo((studio.folder / "pipe.mp4").c_str(), 0600) == 0);
  for (const fs::path& target :
       {studio.folder / "no" / "film.mp4", studio.folder / "folder.mp4", studio.folder / "pipe.mp4"}) {
    const auto checked = check_video(target);
    REQUIRE_FALSE(checked);
    CHECK(checked.error().code == ErrorCode::cannot_write);
    CHECK_FALSE(make_video(studio.take.folder, 30.0, target));
  }
  CHECK_FALSE(fs::exists(studio.folder / "was-run"));
}
