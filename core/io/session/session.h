// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions as JSON: the data, everything that happened to them, and the state of the view.
//
// A session file is one JSON object. A journal, for recovery after a crash, has a session without timeline on its first
// line and a timeline entry on each further line; its last line may be torn.
//
// Guarantees:
//  1. A written session reads back equal, every double bit for bit; equal sessions give equal bytes.
//  2. Readers skip unknown keys and unknown kinds of entries, so that they can open files of later versions; the
//     positions of a lesson count the remaining entries. Entries that change the document or can be undone are never
//     skipped: a new kind of these comes with a new `schema`, which earlier versions refuse; an unknown kind of
//     annotation is refused, too. A file states the lowest schema that its contents need: 4 with ends of centre lines,
//     3 with a map in a system or projection that schema 1 does not have, 2 with highlights or annotations that follow
//     balls, otherwise 1. Journals state the highest.
//  3. Any other nonsense is an error with its position; nothing crashes. Reading takes less memory than twelve times
//     the text, the text included, whatever the text contains.
//
// Smallest use:
//     auto session = read_session(text, "a.json");
//     DocumentReplay replay;
//     auto done = replay_session(*session, replay, "a.json");
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/base/jobs/job_control.h"
#include "core/document/settings/pane_choice.h"
#include "core/document/timeline/lesson.h"
#include "core/document/timeline/timeline.h"
#include "core/io/files/file_fingerprint.h"

namespace mes {

/// Version of the keys of a session file. A file with a greater version is refused.
inline constexpr std::uint64_t kSessionSchema = 4;

/// State of the evolution slider.
struct SessionEvolution {
  std::string id{};  ///< empty: no evolution is chosen
  std::uint64_t seed = 1;
  std::uint64_t step = 0;  ///< current step of the document; the steps are the last of undo
  std::vector<std::pair<std::string, double>> parameters{};  ///< public ids and values
  friend bool operator==(const SessionEvolution&, const SessionEvolution&) = default;
};

/// Limit of the parameters of a session's evolution, and of the unknown ones of its settings.
inline constexpr std::size_t kMostSessionParameters = 1000;

struct Session {
  std::string title{};  ///< as in the window's title, without the file
  std::shared_ptr<const SampleData> data = std::make_shared<const SampleData>();
  TimelineLog entries{};
  LayerConfiguration layers{};  ///< current layers; empty: as at the start of the program
  ComputationSettings settings{};
  SessionEvolution evolution{};
  Box2 view{};                      ///< visible part in document units; empty: everything
  Lesson lesson{};                  ///< refers to the entries; no steps: no lesson
  std::vector<PaneChoice> panes{};  ///< panes beside the main one; at most `kMostPanesBeside`
  /// The visible part in each of these, like `view`; empty: all panes show one view.
  std::vector<Box2> pane_views{};
};

std::string write_session(const Session& session);
/// Compressed, as pictures and figures carry it (core/base/carried_session.h); nothing if it is longer than they may
/// carry. Throws std::bad_alloc.
std::optional<std::string> packed_session(const Session& session);
/// Error: `bad_input` with file, and line and column if it is not JSON.
/// Throws `Cancelled`, if there is a job.
Expected<Session> read_session(std::string_view text, const std::string& file, JobControl* job = nullptr,
                               double done = 0.0);
/// Whether the beginning of the text is that of a session.
bool looks_like_session(std::string_view text);

/// Brings the document of the session to its last state. Error: `bad_input`, naming the entry. Throws `Cancelled` if
/// there is a job; the job is polled before the data and before each entry: between two polls there is one edit, which
/// takes no longer than replacing all samples.
Expected<void> replay_session(const Session& session, DocumentReplay& replay, const std::string& file,
                              JobControl* job = nullptr);

/// One line of a journal, with its line end.
std::string write_journal_head(const Session& session);
std::string write_journal_line(const TimelineEntry& entry);
/// The journal line that marks everything before it as saved, in this file if one is given.
std::string write_journal_saved(const std::optional<SourceFile>& file = {});
/// The journal line that marks the edits before it as saved, but not the lesson.
std::string write_journal_edits_saved();
/// The journal line that names the file in which the document is kept, and its content when read or saved.
std::string write_journal_file(const SourceFile& file);
struct Journaled {
  Session session;  ///< with the last layers, settings and view
  /// Entries since the last save that changed the document, or changed layers by hand; an unsaved lesson alone counts
  /// as one.
  std::size_t unsaved_edits = 0;
  std::optional<SourceFile> file{};  ///< the last one that a line names
  bool is_torn = false;              ///< the text ends within a line, as after a crash
  std::string complaint;             ///< about the line at which reading stopped early; empty: all was read
};
/// Reads as many valid lines as possible. Error: the first line is invalid. Throws `Cancelled` when `job` is stopped.
Expected<Journaled> read_journal(std::string_view text, const std::string& file, JobControl* job = nullptr);

}  // namespace mes
