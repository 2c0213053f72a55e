// SPDX-License-Identifier: GPL-3.0-or-later
// A desk of files in a folder of its own, and ways to wait for what it reads and writes.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <vector>

#include "app/store/file_desk.h"
#include "core/builtins/builtins.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/bell.h"

namespace mes::test {

struct DeskBench {
  TemporaryFolder folder;
  Bell bell;
  Editor editor{{}};
  FileDesk desk{builtins(), editor,
                [this] { return Session{.data = editor.timeline().data(), .entries = editor.timeline().entries()}; },
                bell.ring()};

  FileDesk::Outcome open(const std::filesystem::path& file) { return open(std::vector{file}); }
  FileDesk::Outcome open(const std::vector<std::filesystem::path>& files,
                         MapDegrees degrees = MapDegrees::projected) {
    desk.open(files, degrees);
    return outcome();
  }
  /// Of what is being read.
  FileDesk::Outcome outcome() {
    std::optional<FileDesk::Outcome> out;
    bell.wait_until([&] { return (out = desk.poll()).has_value(); });
    return *out;
  }
  void wait_for_reading() {
    bell.wait_until([&] { return desk.has_read(); });
  }
  Expected<void> save() {
    desk.save();
    return saved();
  }
  Expected<void> save_as(const std::filesystem::path& file) {
    desk.save_as(file);
    return saved();
  }
  Expected<void> saved() {
    const auto out = desk.finish_saving();
    REQUIRE(out);
    CHECK_FALSE(desk.is_saving());
    if (out->error) return std::unexpected(*out->error);
    return {};
  }
  void add_sample() { REQUIRE(editor.insert(std::vector{Vec2{7, 8}}, "sample")); }
  void add_ball() { REQUIRE(editor.insert_balls(std::vector{Disk{{1, 2}, 3}}, "ball")); }
  bool is_complete() const { return !desk.unsaved().any(); }
};

}  // namespace mes::test
