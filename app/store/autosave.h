// SPDX-License-Identifier: GPL-3.0-or-later
// Work that no file holds yet survives a crash.
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/editing/editor.h"
#include "core/io/session.h"

namespace mes {

/// What it guarantees:
///  1. A second after an edit, and a fraction more, a journal in the folder has it, whatever happens to the program
///     or to the machine after that. An edit within a gesture has to wait for the gesture's end.
///  2. Whenever it is interrupted, the journal can be read up to the last line that was finished.
///  3. Nothing is written while nothing is edited. An unchanged document has no journal.
///  4. `follow` costs as much as what is new. Writing is done by a thread of its own.
///  5. Journals of programs that still run are not touched: each holds a lock on its own from before the moment it
///     can be seen as left behind. Without locks no journal is kept, and a problem says so.
///
/// Smallest use:
///     Autosave autosave(default_autosave_folder(), [] {});
///     ... each frame: autosave.follow(editor, [&] { return session_without_timeline(); });
///     autosave.discard();  // everything is saved, or was given up by the user
///
/// Threads: the window's; `wake` is called from the writer's.
class Autosave {
 public:
  /// With an empty folder it does nothing. What comes within `gather` is written together.
  Autosave(std::filesystem::path folder, std::function<void()> wake,
           std::chrono::milliseconds gather = std::chrono::milliseconds(1000));
  /// Leaves the journal as it is; a regular end of the program calls `discard` first.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  void follow(const Editor& editor, const std::function<Session()>& head);
  /// A file holds everything now.
  void note_saved();
  void discard();
  /// Why work is not protected, once.
  std::string take_problem();
  /// Waits until everything given so far has been written, or could not be.
  void flush();
  /// There is a journal, and everything given so far is in it, on the disk. If not, `wake` is called once it may be.
  bool holds_all();

 private:
  struct Work {
    bool begins = false;  // a new journal
    bool renews = false;  // the same work has another first line: a new journal takes the place of this one
    bool ends = false;    // the journal is not needed any more
    bool saved = false;
    Session head;
    std::vector<TimelineEntry> entries;
    bool is_empty() const { return !begins && !renews && !ends && !saved && entries.empty(); }
  };
  struct Journal;
  void write_on(const std::stop_token& stop);
  void write(Work& work, Journal& journal);

  std::filesystem::path folder_;
  std::function<void()> wake_;
  std::chrono::milliseconds gather_;
  std::uint64_t generation_ = 0;
  std::uint64_t lesson_revision_ = 0;
  std::size_t told_ = 0;
  bool has_journal_ = false;

  std::mutex mutex_;
  std::condition_variable_any condition_;
  std::vector<Work> queue_;
  bool is_writing_ = false;
  bool hurry_ = false;
  bool has_failed_ = false;  // what was written last is not on the disk
  bool is_awaited_ = false;  // by `holds_all`
  std::string problem_;
  std::jthread thread_;
};

/// $XDG_DATA_HOME/mesecina/autosave or ~/.local/share/mesecina/autosave; empty when no home folder is known.
std::filesystem::path default_autosave_folder();

/// What a program left behind that did not end in order. No other process is offered it while this lives.
class LeftWork {
 public:
  LeftWork(std::filesystem::path file, int lock, Journaled journal);
  ~LeftWork();
  LeftWork(LeftWork&& other) noexcept;
  LeftWork& operator=(LeftWork&& other) noexcept;

  const Session& session() const { return *session_; }
  const std::shared_ptr<const Session>& shared_session() const { return session_; }
  /// Of the last write, in the computer's time zone: "2026-11-21 10:15".
  const std::string& when() const { return when_; }
  std::size_t edits() const { return edits_; }
  /// It is in other hands now, or not wanted. What could be read in part only is kept as a file all the same.
  void remove();

 private:
  std::filesystem::path file_;
  int lock_ = -1;
  std::shared_ptr<const Session> session_;
  std::size_t edits_ = 0;
  bool is_partial_ = false;
  std::string when_;
};

struct FoundWork {
  std::vector<LeftWork> works;  ///< newest first
  std::string message;          ///< about journals that could not be read and were set aside; empty: none
};
/// Journals without unsaved edits are removed on the way; what cannot be read is kept as `.broken`. Throws `Cancelled`
/// when it is asked to stop; works that were found until then are found again the next time.
FoundWork find_left_work(const std::filesystem::path& folder, const std::stop_token& stop = {});

}  // namespace mes
