// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "core/io/files/atomic_file.h"
#include "temporary_folder.h"

using namespace mes;
using test::contents_of;

TEST_CASE("a new file and a replaced file hold what was written, and nothing else is left") {
  const test::TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder / "a", "first").has_value());
  CHECK(contents_of(folder / "a") == "first");
  REQUIRE(write_file_atomically(folder / "a", std::string(3'000'000, 'x')).has_value());
  CHECK(contents_of(folder / "a").size() == 3'000'000);
  REQUIRE(write_file_atomically(folder / "a", "").has_value());
  CHECK(contents_of(folder / "a").empty());
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a failed write leaves the old file and nothing else") {
  const test::TemporaryFolder folder;
  const auto written = write_file_atomically(folder / "no" / "such" / "folder.txt", "x");
  REQUIRE_FALSE(written.has_value());
  CHECK(written.error().code == ErrorCode::cannot_write);
  CHECK_THAT(written.error().message(), Catch::Contains("folder.txt: cannot be written: No such file or directory"));
  CHECK_FALSE(check_writable(folder / "no" / "such").has_value());

  CHECK_FALSE(write_file_atomically(folder.path(), "x").has_value());
  CHECK_FALSE(write_file_atomically("", "x").has_value());
  CHECK_FALSE(write_file_atomically(folder / (std::string(300, 'n')), "x").has_value());

  // A full device.
  const auto full = write_file_atomically("/dev/full", "x");
  REQUIRE_FALSE(full.has_value());
  CHECK_THAT(full.error().text, Catch::Contains("No space left"));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a file keeps its permissions and a link stays a link") {
  const test::TemporaryFolder folder;
  folder.write("target", "old");
  REQUIRE(::chmod((folder / "target").c_str(), 0640) == 0);
  std::filesystem::create_symlink("target", folder / "link");
  REQUIRE(write_file_atomically(folder / "link", "new").has_value());
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(contents_of(folder / "target") == "new");
  struct stat status {};
  REQUIRE(::stat((folder / "target").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777U) == 0640U);

  std::filesystem::create_symlink("later", folder / "dangling");
  REQUIRE(write_file_atomically(folder / "dangling", "made").has_value());
  CHECK(contents_of(folder / "later") == "made");
  std::filesystem::create_symlink("loop", folder / "loop");
  CHECK_FALSE(write_file_atomically(folder / "loop", "x").has_value());
}

TEST_CASE("a device is written to, not replaced") {
  REQUIRE(write_file_atomically("/dev/null", "x").has_value());
  CHECK(std::filesystem::is_character_file("/dev/null"));
}
