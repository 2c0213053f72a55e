// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <chrono>

#include "core/io/files/atomic_file.h"
#include "core/io/format.h"
#include "temporary_folder.h"

using namespace mes;
using test::contents_of;
namespace fs = std::filesystem;

TEST_CASE("a fingerprint is that of the bytes, wherever they are") {
  const test::TemporaryFolder folder;
  for (const std::size_t size : {0U, 1U, 7U, 8U, 9U, 262'143U, 262'144U, 262'145U, 600'001U}) {
    std::string bytes(size, 'x');
    const FileFingerprint fingerprint = fingerprint_of(bytes);
    CHECK(fingerprint_of_file(folder.write("a", bytes)) == fingerprint);
    CHECK(fingerprint_of(bytes + 'x') != fingerprint);
    for (std::size_t at = 0; at < size; at += 1 + size / 7) {
      bytes[at] = 'y';
      CHECK(fingerprint_of(bytes) != fingerprint);
      bytes[at] = 'x';
    }
  }
  CHECK_FALSE(fingerprint_of_file(folder.path()));
  CHECK_FALSE(fingerprint_of_file(folder / "nothing"));
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_FALSE(fingerprint_of_file(folder / "pipe"));
}

TEST_CASE("a file is replaced while it holds what was expected, and otherwise left alone") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a", "old");
  const FileFingerprint old = fingerprint_of("old");
  REQUIRE(replace_file(file, "new", old).value() == Replaced::done);
  CHECK(contents_of(file) == "new");

  // As long as before, and with the time of before.
  const auto time = fs::last_write_time(file);
  folder.write("a", "New");
  fs::last_write_time(file, time);
  REQUIRE(replace_file(file, "mine", fingerprint_of("new")).value() == Replaced::changed);
  CHECK(contents_of(file) == "New");
  CHECK(folder.file_count() == 1);

  // Only the time is another one.
  fs::last_write_time(file, time + std::chrono::hours(1));
  REQUIRE(replace_file(file, "mine", fingerprint_of("New")).value() == Replaced::done);
  CHECK(contents_of(file) == "mine");

  fs::remove(file);
  REQUIRE(replace_file(file, "again", old).value() == Replaced::done);
  CHECK(contents_of(file) == "again");
}

TEST_CASE("what took the place of a file is not written to") {
  const test::TemporaryFolder folder;
  const FileFingerprint old = fingerprint_of("old");
  fs::create_directory(folder / "folder");
  const auto refused = replace_file(folder / "folder", "x", old);
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().message(), Catch::Contains("Is a directory"));
  // Opening it would wait for a reader.
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK(replace_file(folder / "pipe", "x", old).value() == Replaced::changed);

  folder.write("a", "old");
  folder.write("b", "other");
  fs::create_symlink("a", folder / "link");
  REQUIRE(replace_file(folder / "link", "old", old).value() == Replaced::done);
  fs::remove(folder / "link");
  fs::create_symlink("b", folder / "link");
  CHECK(replace_file(folder / "link", "mine", old).value() == Replaced::changed);
  CHECK(contents_of(folder / "b") == "other");
  CHECK(fs::is_symlink(folder / "link"));
}

TEST_CASE("what was read is known by its fingerprint, with what lies beside it") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.poff", "POFF 3 0 0\n0 0\n1 0\n0 1\n");
  const fs::path beside = folder.write("a.contours", "3\n");
  const auto loaded = read_sample_file(file);
  REQUIRE(loaded);
  REQUIRE(loaded->sources.size() == 2);
  for (const SourceFile& source : loaded->sources) CHECK(fingerprint_of_file(source.path) == source.fingerprint);
  CHECK(loaded->sources[0].path == beside);
  CHECK(loaded->sources[1].path == file);
}
