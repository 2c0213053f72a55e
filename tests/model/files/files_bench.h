// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a document in a folder of their own, and ways to wait until they are read and written.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <vector>

#include "app/store/document_files.h"
#include "core/builtins/builtins.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/bell.h"

namespace mes::test {

struct FilesBench {
  TemporaryFolder folder;
  Bell bell;
  Editor editor{{}};
  DocumentFiles files{
      builtins(), editor,
      [this] { return Session{.data = editor.timeline().data(), .entries = editor.timeline().entries()}; },
      bell.ring()};

  DocumentFiles::Outcome open(const std::filesystem::path& file) { return open(std::vector{file}); }
  DocumentFiles::Outcome open(const std::vector<std::filesystem::path>& paths,
                              MapDegrees degrees = MapDegrees::projected) {
    files.open(paths, degrees);
    return outcome();
  }
  /// Waits until the files that are being read are there.
  DocumentFiles::Outcome outcome() {
    std::optional<DocumentFiles::Outcome> out;
    bell.wait_until([&] { return (out = files.poll()).has_value(); });
    return *out;
  }
  void wait_for_reading() {
    bell.wait_until([&] { return files.has_read(); });
  }
  Expected<void> save() {
    files.save();
    return saved();
  }
  Expected<void> save_as(const std::filesystem::path& file) {
    files.save_as(file);
    return saved();
  }
  Expected<void> saved() {
    const auto out = files.finish_saving();
    REQUIRE(out);
    CHECK_FALSE(files.is_saving());
    if (out->error) return std::unexpected(*out->error);
    return {};
  }
  void add_sample() { REQUIRE(editor.insert(std::vector{Vec2{7, 8}}, "sample")); }
  void add_ball() { REQUIRE(editor.insert_balls(std::vector{Disk{{1, 2}, 3}}, "ball")); }
  bool is_complete() const { return !files.unsaved().any(); }
};

}  // namespace mes::test
