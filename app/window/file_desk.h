// SPDX-License-Identifier: GPL-3.0-or-later
// Which file the document belongs to; reading and writing it.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/editor.h"
#include "core/io/format.h"

namespace mes {

/// What it guarantees:
///  1. Reading happens on a thread of its own; until it ends well the document stays as it is, and a file that cannot
///     be read leaves it so for good.
///  2. Saving is atomic, and writes POFF whatever was read.
///
/// Smallest use:
///     desk.open("a.poff");
///     ... each frame: if (auto outcome = desk.poll()) show(*outcome);
///
/// Threads: the window's; `wake` is called from the reader's.
class FileDesk {
 public:
  FileDesk(Editor& editor, std::function<void()> wake);
  ~FileDesk();

  /// Begins to read; a reading under way is given up.
  void open(const std::filesystem::path& file);
  /// The same for a built-in shape: it has a title, but saving asks for a file.
  void open_shape(const std::filesystem::path& file, const std::string& title);
  void cancel_reading();
  bool is_reading() const { return reading_ != nullptr; }
  std::string reading_name() const;

  struct Outcome {
    std::filesystem::path file;
    bool is_shape = false;
    std::string format;
    std::size_t samples = 0;
    std::vector<std::string> warnings;
    std::optional<Error> error;
  };
  /// What became of the reading, once, when it has ended.
  std::optional<Outcome> poll();

  void start_empty();
  Expected<void> save_as(const std::filesystem::path& file);

  /// The file that Save writes; empty when it must be asked for.
  const std::filesystem::path& file() const { return file_; }
  /// Of the window: "a.poff", "Elephant", "Untitled".
  const std::string& title() const { return title_; }

 private:
  struct Reading {
    std::filesystem::path file;
    std::string title;  // of a shape
    std::atomic<bool> is_done = false;
    Expected<LoadedFile> result{};
    std::jthread thread;  // last: it ends before what it writes to
  };
  void begin(const std::filesystem::path& file, const std::string& shape_title);

  Editor& editor_;
  std::function<void()> wake_;
  std::filesystem::path file_;
  std::string title_ = "Untitled";
  std::unique_ptr<Reading> reading_;
  std::vector<std::unique_ptr<Reading>> given_up_;  // a reader cannot be stopped, only not waited for
};

}  // namespace mes
