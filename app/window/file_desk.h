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
#include "core/io/session.h"

namespace mes {

/// What it guarantees:
///  1. Reading happens on a thread of its own; until it ends well the document stays as it is, and a file that cannot
///     be read leaves it so for good.
///  2. Saving is atomic, and writes a session, POFF or WPOFF, whatever was read. A session holds everything. A POFF
///     file holds samples and a WPOFF file balls, so a document of both has two files; until each holds what the
///     document holds, it counts as modified.
///
/// Smallest use:
///     desk.open("a.poff");
///     ... each frame: if (auto outcome = desk.poll()) show(*outcome);
///
/// Threads: the window's; `wake` is called from the reader's.
class FileDesk {
 public:
  /// `session_now` gives what a session file is to hold.
  FileDesk(Editor& editor, std::function<Session()> session_now, std::function<void()> wake);
  ~FileDesk();

  /// Begins to read; a reading under way is given up. Of several files those are opened together that bring something
  /// else each: a file of samples and a file of balls are one document again.
  void open(const std::vector<std::filesystem::path>& files);
  void open(const std::filesystem::path& file) { open(std::vector{file}); }
  /// The same for a built-in shape: it has a title, but saving asks for a file.
  void open_shape(const std::filesystem::path& file, const std::string& title);
  void cancel_reading();
  bool is_reading() const { return reading_ != nullptr; }
  std::string reading_name() const;

  struct Outcome {
    std::filesystem::path file;                ///< the first one, or the one to blame
    std::vector<std::filesystem::path> files;  ///< that were opened
    std::size_t left_out = 0;                  ///< files that would have replaced what the first brought
    bool is_shape = false;
    std::shared_ptr<const Session> session;  ///< if it was one; the document is the session's already
    std::string format;
    std::size_t samples = 0;
    std::size_t balls = 0;
    std::vector<std::string> warnings;
    std::optional<Error> error;
  };
  /// What became of the reading, once, when it has ended.
  std::optional<Outcome> poll();

  void start_empty();
  /// Takes over work that a crash left behind: no file holds it.
  Expected<void> recover(const Session& session);
  /// Writes the session, or samples and balls, to the files they have. Error: one cannot be written.
  Expected<void> save();
  /// Writes everything when the name ends in .json, the balls when it ends in .wpoff, else the samples. That is their
  /// file from now on.
  Expected<void> save_as(const std::filesystem::path& file);
  /// What of the document no file holds as it is now.
  struct Unsaved {
    bool samples = false;
    bool balls = false;
  };
  Unsaved unsaved() const;

  /// The file opened or saved last, if Save can write it; empty when a name must be asked for.
  const std::filesystem::path& file() const { return file_; }
  const std::filesystem::path& sample_file() const { return sample_file_; }
  const std::filesystem::path& ball_file() const { return ball_file_; }
  bool has_session_file() const { return !session_file_.empty(); }
  /// Of the window: "a.poff", "Elephant", "Untitled".
  const std::string& title() const { return title_; }

 private:
  struct Reading {
    std::vector<std::filesystem::path> files;
    std::string title;  // of a shape
    std::atomic<bool> is_done = false;
    std::vector<Expected<LoadedFile>> results;  // up to the first that failed
    std::jthread thread;                        // last: it ends before what it writes to
  };
  void begin(const std::vector<std::filesystem::path>& files, const std::string& shape_title);
  static void read(Reading& reading);
  void note_all_as_saved();
  void forget_files();
  Expected<void> write_samples();
  Expected<void> write_balls();
  Expected<void> write_session_file();
  Expected<void> take_over(const Session& session, const std::string& name);

  Editor& editor_;
  std::function<Session()> session_now_;
  std::function<void()> wake_;
  std::filesystem::path file_;
  std::filesystem::path sample_file_;  // empty: none yet
  std::filesystem::path ball_file_;
  std::filesystem::path session_file_;
  std::uint64_t saved_samples_ = 0;  // digests of what files hold
  std::uint64_t saved_balls_ = 0;
  std::string title_ = "Untitled";
  std::unique_ptr<Reading> reading_;
  std::vector<std::unique_ptr<Reading>> given_up_;  // a reader cannot be stopped, only not waited for
};

}  // namespace mes
