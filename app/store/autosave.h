// SPDX-License-Identifier: GPL-3.0-or-later
// Protects work that no file holds yet against a crash.
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/editing/editor.h"
#include "core/io/session/session.h"

namespace mes {

/// Guarantees:
///  1. A little more than a second after an edit, a journal in the folder holds it, whatever happens to the program
///     or to the machine after that. An edit within a gesture waits for the gesture's end.
///  2. Whenever writing is interrupted, the journal can be read up to the last complete line.
///  3. Nothing is written while nothing is edited. An unchanged document has no journal.
///  4. `follow` takes time proportional to the new edits. A separate thread writes.
///  5. Journals of running programs are not touched: each program locks its journal before others could take it for
///     left behind. Where locking fails, no journal is kept, and a problem is reported.
///
/// Smallest use:
///     Autosave autosave(default_autosave_folder(), [] {});
///     ... each frame: autosave.follow(editor, [&] { return session_without_timeline(); });
///     autosave.discard();  // everything is saved, or was given up by the user
///
/// Threads: the window's; `wake` is called from the writer's.
class Autosave {
 public:
  /// Does nothing if the folder is empty. Edits within `gather` are written together.
  Autosave(std::filesystem::path folder, std::function<void()> wake,
           std::chrono::milliseconds gather = std::chrono::milliseconds(1000));
  /// Leaves the journal as it is; a regular end of the program calls `discard` first.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// `file` gives the file in which the document is kept, if there is one.
  void follow(const Editor& editor, const std::function<Session()>& head,
              const std::function<std::optional<SourceFile>()>& file = {});
  /// Tells the autosave that everything is saved, in this file if one is given.
  void note_saved(const std::optional<SourceFile>& file = {});
  void discard();
  /// The reason why work is not protected, given once.
  std::string take_problem();
  /// Waits until everything given so far has been written or has failed to be.
  void flush();
  /// True if a journal on the disk holds everything given so far. If not, `wake` is called once it may be true.
  bool holds_all();

 private:
  struct Work {
    bool begins = false;  // a new journal
    bool renews = false;  // the first line has changed for the same work: a new journal replaces this one
    bool ends = false;    // the journal is not needed any more
    bool saved = false;
    Session head;
    std::optional<SourceFile> file;
    std::vector<TimelineEntry> entries;
    std::size_t saved_entries = 0;  // number of these that a file holds
    bool is_lesson_saved = false;
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
  std::size_t saved_ = 0;  // number of entries that a file holds
  bool has_journal_ = false;

  std::mutex mutex_;
  std::condition_variable_any condition_;
  std::vector<Work> queue_;
  bool is_writing_ = false;
  bool hurry_ = false;
  bool has_failed_ = false;  // the last write is not on the disk
  bool is_awaited_ = false;  // `holds_all` waits for it
  std::string problem_;
  std::jthread thread_;
};

/// $XDG_DATA_HOME/mesecina/autosave or ~/.local/share/mesecina/autosave; empty when no home folder is known.
std::filesystem::path default_autosave_folder();

/// Work left behind by a program that did not end in order. While this object lives, no other process is offered the
/// work.
class LeftWork {
 public:
  LeftWork(std::filesystem::path file, int lock, Journaled journal);
  ~LeftWork();
  LeftWork(LeftWork&& other) noexcept;
  LeftWork& operator=(LeftWork&& other) noexcept;

  const Session& session() const { return *session_; }
  const std::shared_ptr<const Session>& shared_session() const { return session_; }
  /// Time of the last write in the local time zone: "2026-11-21 10:15".
  const std::string& when() const { return when_; }
  std::size_t edits() const { return edits_; }
  /// The file in which the document was kept, and its content then.
  const std::optional<SourceFile>& file() const { return kept_in_; }
  /// Name for the user: that of the file, else the title.
  std::string name() const;
  /// Deletes the journal because the work was taken over or rejected. A partly readable one is kept as a file all the
  /// same.
  void remove();

 private:
  std::filesystem::path file_;
  int lock_ = -1;
  std::shared_ptr<const Session> session_;
  std::size_t edits_ = 0;
  std::optional<SourceFile> kept_in_;
  bool is_partial_ = false;
  std::string when_;
};

struct FoundWork {
  std::vector<LeftWork> works;  ///< newest first
  std::string message;          ///< about unreadable journals that were set aside; empty if there are none
};
/// Finds left work. Removes journals without unsaved edits, and renames unreadable ones to `.broken`. Throws
/// `Cancelled` on a stop; the next call finds the works again.
FoundWork find_left_work(const std::filesystem::path& folder, const std::stop_token& stop = {});

}  // namespace mes
