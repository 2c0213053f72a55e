// SPDX-License-Identifier: GPL-3.0-or-later
// With a program in the place of xclip that keeps what it was given.
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "app/recording/picture_clipboard.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using test::TemporaryFolder;

namespace {

constexpr std::array kPng{std::byte{0x89}, std::byte{'P'}, std::byte{'N'}, std::byte{'G'}};

/// A folder that is all of the PATH, but for the shell's own.
struct OnlyPath {
  TemporaryFolder folder;
  std::string before = std::getenv("PATH");

  OnlyPath() { ::setenv("PATH", folder.path().c_str(), 1); }
  ~OnlyPath() { ::setenv("PATH", before.c_str(), 1); }
  OnlyPath(const OnlyPath&) = delete;
  OnlyPath& operator=(const OnlyPath&) = delete;

  void put_xclip(const std::string& script) const {
    std::ofstream(folder / "xclip") << "#!/bin/sh\nPATH='" << before << "'\n" << script;
    std::filesystem::permissions(folder / "xclip", std::filesystem::perms::owner_all);
  }
  std::string text(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
};

}  // namespace

TEST_CASE("xclip gets the picture as PNG for the clipboard") {
  const OnlyPath path;
  const std::string folder = path.folder.path().string();
  path.put_xclip("echo \"$@\" > '" + folder + "/words'\nfor file; do :; done\ncp \"$file\" '" + folder + "/got'\n");
  const auto done = copy_png(kPng, {});
  CHECK(done);
  CHECK(path.text("got") == "\x89PNG");
  CHECK(path.text("words").starts_with("-selection clipboard -target image/png -in "));
}

TEST_CASE("without xclip, or where it fails, the reason is one line") {
  const OnlyPath path;
  const auto missing = copy_png(kPng, {});
  REQUIRE_FALSE(missing);
  CHECK(missing.error().message() == "copying pictures needs the program xclip, which is not installed");
  path.put_xclip("echo 'Error: Cannot open display' >&2\nexit 1\n");
  const auto failed = copy_png(kPng, {});
  REQUIRE_FALSE(failed);
  CHECK(failed.error().message() == "xclip failed: Error: Cannot open display");
}
