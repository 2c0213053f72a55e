// SPDX-License-Identifier: GPL-3.0-or-later
// Work that no file holds: noted on the timeline, kept in a journal, and offered again after a crash.
#pragma once

#include <functional>
#include <optional>

#include "app/editing/surroundings.h"
#include "app/model/messages.h"
#include "app/store/autosave.h"
#include "app/system/background_job.h"
#include "app/window/workspace.h"

namespace mes {

/// What it guarantees: what Autosave guarantees; looking for left work holds up nothing.
/// Threads: the window's; `wake` is called from others.
class WorkKeeper {
 public:
  /// `session_now` gives the document as it is to be kept. Begins to look for work that was left behind.
  WorkKeeper(Workspace& work, Messages& messages, std::function<Session()> session_now, Waker wake);

  struct Rest {
    bool controls = false;  ///< no control of a panel is held
    bool all = false;       ///< nor does anything move, or is being read
  };
  /// Once a frame. Surroundings are noted when they are at rest: a slider or a zoom under way is not yet what is meant.
  void follow(const Rest& rest, const Box2& view);
  /// The document was restored, and this view with it.
  void take_as_noted(const Box2& view);
  /// A file holds everything now.
  void note_saved() { autosave_.note_saved(); }
  /// What is unsaved was given up.
  void discard() { autosave_.discard(); }
  /// Waits until the journal has been written.
  void flush() { autosave_.flush(); }
  /// The journal is on the disk, with everything given so far.
  bool holds_all() { return autosave_.holds_all(); }

  /// What an earlier run has left behind, once, when it has been found.
  std::optional<FoundWork> take_left_work() { return left_work_.poll(); }

 private:
  Surroundings surroundings(const Box2& view) const { return {work_.computation().settings(), view}; }

  Workspace& work_;
  Messages& messages_;
  std::function<Session()> session_now_;
  SurroundingsNotes notes_;
  Autosave autosave_;
  BackgroundJob<FoundWork> left_work_;
};

}  // namespace mes
