// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions: the data, everything that happened to them, and how they are looked at, as JSON.
//
// A session file is one JSON object. A journal, for recovery after a crash, is a session without timeline on its
// first line and an entry of the timeline on each line after it; its last line may be torn.
//
// What it guarantees:
//  1. What is written reads back equal, every double bit for bit; equal sessions give equal bytes.
//  2. Keys and kinds of entries that are not known are skipped, so that a later version's files can be opened; the
//     positions of a lesson count what is left. What changes the document or can be undone is never skipped: with a new
//     kind of it comes another `schema`, which earlier versions refuse, and a kind of annotation that is not known is
//     refused, too. A file says the least schema that its contents need: 2 with highlights or annotations that follow
//     balls, otherwise 1. Journals say the greatest.
//  3. Anything else that makes no sense is an error that says where; nothing crashes. Reading takes less memory than
//     twelve times the text, the text included, whatever it holds.
//
// Smallest use:
//     auto session = read_session(text, "a.json");
//     DocumentReplay replay;
//     auto done = replay_session(*session, replay, "a.json");
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/box2.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/document/lesson.h"
#include "core/document/pane_choice.h"
#include "core/document/timeline.h"

namespace mes {

/// Version of the keys of a session file. A file with a greater one is refused.
inline constexpr std::uint64_t kSessionSchema = 2;

/// The slider of evolutions.
struct SessionEvolution {
  std::string id{};  ///< empty: none was chosen
  std::uint64_t seed = 1;
  std::uint64_t step = 0;  ///< that the document is in; its steps are the last of undo
  std::vector<std::pair<std::string, double>> parameters{};  ///< public ids and values
  friend bool operator==(const SessionEvolution&, const SessionEvolution&) = default;
};

/// Parameters of the evolution of a session, and those of its settings that are not known.
inline constexpr std::size_t kMostSessionParameters = 1000;

struct Session {
  std::string title{};  ///< as in the window's title, without the file
  std::shared_ptr<const SampleData> data = std::make_shared<const SampleData>();
  TimelineLog entries{};
  LayerConfiguration layers{};  ///< now; no layers: as at the start of the program
  ComputationSettings settings{};
  SessionEvolution evolution{};
  Box2 view{};                      ///< what is to be seen, document units; empty: everything
  Lesson lesson{};                  ///< made of the entries; no steps: none
  std::vector<PaneChoice> panes{};  ///< beside the main one; `kMostPanesBeside` at most
  /// What is to be seen in each of these, as `view`; none: all panes show one view.
  std::vector<Box2> pane_views{};
};

std::string write_session(const Session& session);
/// Error: `bad_input` with file, and line and column if it is not JSON.
/// Throws `Cancelled`, if there is a job.
Expected<Session> read_session(std::string_view text, const std::string& file, JobControl* job = nullptr,
                               double done = 0.0);
/// Whether text is meant to be a session, from how it begins.
bool looks_like_session(std::string_view text);

/// Brings the document of the session to its last state. Error: `bad_input`, naming the entry. Throws `Cancelled` if there
/// is a job, which is looked at before the data and before each entry: between two looks there is one edit, which takes
/// no longer than all samples take to be replaced.
Expected<void> replay_session(const Session& session, DocumentReplay& replay, const std::string& file,
                              JobControl* job = nullptr);

/// One line of a journal, with its end.
std::string write_journal_head(const Session& session);
std::string write_journal_line(const TimelineEntry& entry);
/// Says that a file holds everything up to here.
std::string write_journal_saved();
struct Journaled {
  Session session;  ///< with layers, settings and view as they were last
  /// Entries since the last save that changed the document, or the layers by hand; a lesson alone that no file holds is
  /// one.
  std::size_t unsaved_edits = 0;
  bool is_torn = false;   ///< ends within a line, as after a crash
  std::string complaint;  ///< about the line at which reading ended early; empty: all was read
};
/// Reads as far as it makes sense. Error: the first line does not. Throws `Cancelled` when `job` is asked to stop.
Expected<Journaled> read_journal(std::string_view text, const std::string& file, JobControl* job = nullptr);

}  // namespace mes
