// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions, and journals, which are sessions line by line.
#include "core/io/session/session.h"
#include "tests/fuzz/sample_files.h"

using namespace mes;
using namespace mes::fuzz;

namespace {

bool are_equal(const Session& a, const Session& b) {
  return a.title == b.title && mes::fuzz::are_equal(*a.data, *b.data) && a.entries == b.entries &&
         a.layers == b.layers && a.settings == b.settings && a.view == b.view && a.lesson == b.lesson &&
         // One without a name is none.
         (a.evolution == b.evolution || (a.evolution.id.empty() && b.evolution.id.empty()));
}

void check_written(const Session& session) {
  const std::string text = write_session(session);
  require(looks_like_session(text), "what is written looks like a session");
  const Session again = require_read(read_session(text, "again.json"));
  require(are_equal(again, session), "what is written reads back equal");
  require(write_session(again) == text, "equal sessions are equal bytes");
}

void check_session(std::string_view text) {
  const auto session = read_session(text, "a.json");
  if (!session) return require_error(session.error(), text);
  check_written(*session);
  DocumentReplay replay;
  if (const auto done = replay_session(*session, replay, "a.json"); !done)
    require_error(done.error(), text);
  else
    check_sample_file(text, "a.json", "session");
}

void check_journal(std::string_view text) {
  const auto journal = read_journal(text, "a.journal");
  if (!journal) return require_error(journal.error(), text);
  if (!journal->complaint.empty()) require_message(journal->complaint);
  check_written(journal->session);
  DocumentReplay replay;
  if (!replay_session(journal->session, replay, "a.journal")) return;  // the first line had a timeline of its own
  // Written again line by line it says the same, with nothing to complain about.
  Session head = journal->session;
  std::string lines = write_journal_head(head);
  for (const TimelineEntry& entry : journal->session.entries) lines += write_journal_line(entry);
  const Journaled again = require_read(read_journal(lines, "again.journal"));
  require(again.complaint.empty() && !again.is_torn, "what is written is read to its end: " + again.complaint);
  require(again.session.entries == journal->session.entries, "what is written reads back equal");
}

}  // namespace

void mes::fuzz::run_session(std::string_view text) {
  check_session(text);
  require_little_memory(text.size());
  require_little_work(text.size(), kPlainWork);
  check_journal(text);
}
