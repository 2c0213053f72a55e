// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <optional>
#include <thread>

#include "core/io/files/read_file.h"
#include "core/io/format.h"
#include "temporary_folder.h"

using namespace mes;
namespace fs = std::filesystem;

namespace {

fs::path make_pipe(const test::TemporaryFolder& folder, const std::string& name) {
  const fs::path out = folder / name;
  REQUIRE(::mkfifo(out.c_str(), 0600) == 0);
  return out;
}

// Waits for a reader.
void feed(const fs::path& pipe, std::string_view text) {
  const int end = ::open(pipe.c_str(), O_WRONLY | O_CLOEXEC);
  for (const char c : text) static_cast<void>(!::write(end, &c, 1));
  ::close(end);
}

}  // namespace

TEST_CASE("a pipe beside a file of samples is not read") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.poff", "POFF 3 0 0\n0 0\n1 0\n0 1\n");
  make_pipe(folder, "a.contours");
  const auto loaded = read_sample_file(file);
  REQUIRE(loaded);
  CHECK(loaded->data.positions.size() == 3);
  REQUIRE(loaded->warnings.size() == 1);
  CHECK_THAT(loaded->warnings[0], Catch::Contains("a.contours: cannot be read: not a regular file"));
}

TEST_CASE("a folder or a device beside a file of samples is not read") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.poff", "POFF 1 0 0\n0 0\n");
  fs::create_directory(folder / "a.contours");
  auto loaded = read_sample_file(file);
  REQUIRE(loaded);
  CHECK(loaded->warnings.size() == 1);
  fs::remove(folder / "a.contours");
  fs::create_symlink("/dev/zero", folder / "a.contours");
  loaded = read_sample_file(file);
  REQUIRE(loaded);
  CHECK(loaded->warnings.size() == 1);
}

TEST_CASE("a file beside others is refused by its size if that makes no sense") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.poff", "POFF 3 0 0\n0 0\n1 0\n0 1\n");
  const fs::path beside = folder.write("a.contours", "3\n");
  CHECK(read_sample_file(file)->data.contours.size() == 1);
  fs::resize_file(beside, std::uintmax_t{3} << 30U);  // takes no room on the disk
  const auto loaded = read_sample_file(file);
  REQUIRE(loaded);
  CHECK(loaded->data.positions.size() == 3);
  REQUIRE(loaded->warnings.size() == 1);
  CHECK_THAT(loaded->warnings[0], Catch::Contains("a.contours: it is too large to read; the order of the curve"));
}

TEST_CASE("samples are read from a pipe given by name, however slowly they come") {
  const test::TemporaryFolder folder;
  const fs::path pipe = make_pipe(folder, "pipe");
  std::thread writer([&] { feed(pipe, "POFF 2 0 0\n0 0\n1 2\n"); });
  const auto loaded = read_sample_file(pipe);
  writer.join();
  REQUIRE(loaded);
  CHECK(loaded->data.positions == std::vector<Vec2>{{0, 0}, {1, 2}});
  // What is gone when it has been read cannot be compared with later.
  CHECK(loaded->sources.empty());
}

TEST_CASE("waiting for a pipe ends with the request to stop, with and without a writer") {
  const test::TemporaryFolder folder;
  const fs::path pipe = make_pipe(folder, "pipe");
  for (const bool has_writer : {false, true}) {
    std::optional<Expected<LoadedFile>> result;
    std::jthread reader([&](const std::stop_token& stop) {
      JobControl job(stop);
      result = read_sample_file(pipe, {}, &job);
    });
    // Opening to write waits for the reader.
    const int end = has_writer ? ::open(pipe.c_str(), O_WRONLY | O_CLOEXEC) : -1;
    reader.request_stop();
    reader.join();
    if (end >= 0) ::close(end);
    REQUIRE(result.has_value());
    REQUIRE_FALSE(result->has_value());
    CHECK(result->error().code == ErrorCode::cancelled);
  }
}

TEST_CASE("what never ends is not read for ever") {
  const auto zeros = read_sample_file("/dev/zero");
  REQUIRE_FALSE(zeros);
  CHECK(zeros.error().code == ErrorCode::bad_input);
  const auto limited = read_whole("/dev/zero", {.most_bytes = 1'000'000});
  REQUIRE_FALSE(limited);
  CHECK_THAT(limited.error().message(), Catch::Contains("/dev/zero: it is too large to read"));
}
