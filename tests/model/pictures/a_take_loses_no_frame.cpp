// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <semaphore>
#include <set>
#include <thread>

#include "app/recording/frame_writer.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/eventually.h"
#include "tests/support/golden_image.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

render::Image picture(int width, int height, int number) {
  render::Image out{width, height, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width * height), 255)};
  for (int x = 0; x < width; ++x) out.rgba[out.offset(x, number % height)] = static_cast<std::uint8_t>(number);
  return out;
}

// Noise: as large on the disk as in memory.
render::Image noise(int width, int height) {
  render::Image out = picture(width, height, 0);
  std::uint32_t state = 1;
  for (std::uint8_t& value : out.rgba)
    value = static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24U);
  return out;
}

Take take_in(const TemporaryFolder& folder, int width = 64, int height = 48) {
  auto take = begin_take(folder.path(), {width, height, 25.0});
  REQUIRE(take);
  return *take;
}

// Every file with the name of a frame can be decoded; how many.
int whole_frames(const fs::path& folder) {
  int out = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".png") continue;
    INFO(entry.path());
    CHECK(read_png(entry.path()).width > 0);
    ++out;
  }
  return out;
}

}  // namespace

TEST_CASE("every frame pushed is a file, and the manifest tells what it is of") {
  const TemporaryFolder folder;
  const Take take = take_in(folder);
  FrameWriter writer(take, {.threads = 3});
  for (int i = 1; i <= 40; ++i) REQUIRE(writer.push({picture(64, 48, i), {"Step " + std::to_string(i), 7}}));
  REQUIRE(writer.finish());
  CHECK(writer.written() == 40);
  CHECK(writer.pending() == 0);
  for (int i = 1; i <= 40; ++i)
    CHECK(read_png(take.folder / frame_name(static_cast<std::uint64_t>(i))) == picture(64, 48, i));
  const auto read = read_take(take.folder);
  REQUIRE(read);
  CHECK(read->complete);
  CHECK(read->format.fps == 25.0);
  CHECK(read->format.width == 64);
  REQUIRE(read->frames.size() == 40);
  CHECK(read->frames[39].what == "Step 40");
  CHECK(read->frames[39].document == 7);
  CHECK_FALSE(writer.push({picture(64, 48, 41), {}}));
}

TEST_CASE("what graphics hands out is turned over and freed of its alpha") {
  const render::RawImage raw{1, 2, {10, 20, 30, 255, 64, 32, 0, 128}};
  const render::Image image = render::to_image(raw);
  CHECK(image.rgba == std::vector<std::uint8_t>{128, 64, 0, 128, 10, 20, 30, 255});
  const TemporaryFolder folder;
  const Take take = take_in(folder, 1, 2);
  FrameWriter writer(take);
  REQUIRE(writer.push({raw, {}}));
  REQUIRE(writer.finish());
  CHECK(read_png(take.folder / frame_name(1)) == image);
}

TEST_CASE("takes and files of the same second have names of their own") {
  const TemporaryFolder folder;
  const auto now = std::chrono::system_clock::now();
  std::set<fs::path> names;
  for (int i = 0; i < 3; ++i) {
    const auto take = begin_take(folder.path() / "new" / "takes", {1, 1, 30.0}, now);
    REQUIRE(take);
    names.insert(take->folder);
    const auto file = claim_file(folder.path(), "mesecina", "png", now);
    REQUIRE(file);
    names.insert(*file);
  }
  CHECK(names.size() == 6);
  CHECK(names.begin()->filename().string().starts_with("mesecina-2"));
  folder.write("plain", "");
  const auto refused = begin_take(folder / "plain", {1, 1, 30.0});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == ErrorCode::cannot_write);
  CHECK_FALSE(claim_file(folder / "plain", "a", "png"));
}

TEST_CASE("a slow disk holds up who records: nothing is dropped, and the queue keeps its bound") {
  const TemporaryFolder folder;
  const Take take = take_in(folder, 1920, 1080);
  constexpr std::size_t kFrames = 500;
  constexpr std::size_t kMost = 4;
  const render::Image frame = picture(1920, 1080, 3);
  std::atomic<std::size_t> files = 0;
  std::size_t most_held = 0;
  FrameWriter writer(take, {.most_frames = 64,
                            .most_bytes = kMost * frame.rgba.size(),
                            .threads = 2,
                            .write = [&](const fs::path& file, std::string_view) -> Expected<void> {
                              if (file.extension() != ".png") return {};
                              std::this_thread::sleep_for(std::chrono::milliseconds(2));
                              ++files;
                              return {};
                            }});
  for (std::size_t i = 0; i < kFrames; ++i) {
    REQUIRE(writer.push({frame, {}}));
    most_held = std::max(most_held, writer.pending());
  }
  CHECK(most_held > 1);
  CHECK(most_held <= kMost);
  REQUIRE(writer.finish());
  CHECK(files == kFrames);
  CHECK(writer.written() == kFrames);
}

TEST_CASE("a picture larger than the whole queue is let in alone") {
  const TemporaryFolder folder;
  FrameWriter writer(take_in(folder), {.most_bytes = 10});
  CHECK_FALSE(writer.has_room(1, 64 * 48 * 4));
  for (int i = 0; i < 3; ++i) REQUIRE(writer.push({picture(64, 48, i), {}}));
  REQUIRE(writer.finish());
  CHECK(writer.written() == 3);
}

TEST_CASE("a folder that goes away ends the take with one problem") {
  const TemporaryFolder folder;
  const Take take = take_in(folder);
  FrameWriter writer(take);
  REQUIRE(writer.push({picture(64, 48, 1), {}}));
  REQUIRE(eventually([&] { return writer.written() != 0; }));
  fs::rename(take.folder, folder / "elsewhere");
  bool refused = false;
  while (!refused) refused = !writer.push({picture(64, 48, 2), {}});
  const auto done = writer.finish();
  REQUIRE_FALSE(done);
  CHECK(done.error().code == ErrorCode::cannot_write);
  CHECK_THAT(done.error().message(), Catch::Contains("No such file or directory"));
  CHECK(writer.pending() == 0);
  CHECK(whole_frames(folder / "elsewhere") == 1);
}

TEST_CASE("a full disk ends the take there, and its earlier frames can be used") {
  const TemporaryFolder folder;
  const Take take = take_in(folder);
  std::size_t left = 10;
  FrameWriter writer(take,
                     {.threads = 1, .write = [&](const fs::path& file, std::string_view bytes) -> Expected<void> {
                        if (left == 0)
                          return std::unexpected(Error{ErrorCode::cannot_write, "No space left", file.string()});
                        --left;
                        return write_file_atomically(file, bytes);
                      }});
  for (int i = 0; i < 100; ++i) static_cast<void>(writer.push({picture(64, 48, i), {}}));
  const auto done = writer.finish();
  REQUIRE_FALSE(done);
  CHECK_THAT(done.error().message(), Catch::Contains("No space left"));
  CHECK(whole_frames(take.folder) == 10);
  const auto read = read_take(take.folder);
  REQUIRE(read);
  CHECK_FALSE(read->complete);
  CHECK(read->frames.size() == 10);
}

TEST_CASE("the manifest of a take that broke off lists the frames before the one that is missing, and says why") {
  const TemporaryFolder folder;
  const Take take = take_in(folder);
  std::binary_semaphore third_is_written{0};
  {
    // The second frame fails when the third is written already.
    FrameWriter writer(take,
                       {.threads = 2, .write = [&](const fs::path& file, std::string_view bytes) -> Expected<void> {
                          if (file.filename() == frame_name(2)) {
                            third_is_written.acquire();
                            return std::unexpected(Error{ErrorCode::cannot_write, "No space left", file.string()});
                          }
                          auto done = write_file_atomically(file, bytes);
                          if (file.filename() == frame_name(3)) third_is_written.release();
                          return done;
                        }});
    for (int i = 1; i <= 3; ++i) REQUIRE(writer.push({picture(64, 48, i), {"Step " + std::to_string(i)}}));
    CHECK_FALSE(writer.finish());
    CHECK(writer.written() == 2);
  }
  const auto manifest = nlohmann::json::parse(contents_of(take.folder / kManifestName));
  CHECK_FALSE(manifest["complete"].get<bool>());
  CHECK_THAT(manifest["problem"].get<std::string>(), Catch::Contains("No space left"));
  REQUIRE(manifest["frames"].size() == 1);
  CHECK(manifest["frames"][0]["interaction"] == "Step 1");
}

TEST_CASE("what a limit of the system cuts off is no frame") {
  const TemporaryFolder folder;
  const Take take = take_in(folder, 200, 200);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{60'000, 60'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    FrameWriter writer(take, {.threads = 1});
    for (int i = 0; i < 5; ++i) static_cast<void>(writer.push({picture(200, 200, i), {}}));
    static_cast<void>(writer.push({noise(200, 200), {}}));
    const auto done = writer.finish();
    _exit(!done && done.error().text.find("File too large") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(whole_frames(take.folder) == 5);
}

TEST_CASE("a program that is killed leaves whole frames only, and a take that can be read") {
  const TemporaryFolder folder;
  const Take take = take_in(folder, 400, 300);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    FrameWriter writer(take, {.threads = 2, .manifest_interval = std::chrono::milliseconds(1)});
    const render::Image frame = noise(400, 300);
    while (writer.push({frame, {"Move"}})) {
    }
    _exit(1);
  }
  const auto has_twelve = [&] {
    const auto read = read_take(take.folder);
    return read && read->frames.size() >= 12 && read->frames.front().what == "Move";
  };
  REQUIRE(eventually(has_twelve));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  CHECK(whole_frames(take.folder) >= 12);
  const auto read = read_take(take.folder);
  REQUIRE(read);
  CHECK_FALSE(read->complete);
  CHECK(read->frames.size() >= 12);
  CHECK(read->frames.front().what == "Move");
  CHECK(read->format.width == 400);
}

TEST_CASE("what is no take is refused in one line") {
  const TemporaryFolder folder;
  CHECK_FALSE(read_take(folder.path()));
  CHECK_FALSE(read_take(folder / "nowhere"));
  folder.write(frame_name(1), "");
  CHECK(read_take(folder.path())->frames.size() == 1);
  for (const std::string bad : {"", "[]", "{", R"({"schema": 2})"}) {
    folder.write(kManifestName, bad);
    CHECK_FALSE(read_take(folder.path()));
  }
  folder.write(kManifestName, R"({"schema": 1, "frames": [3, {"interaction": 4}], "width": "x"})");
  CHECK(read_take(folder.path())->frames.size() == 1);
}
