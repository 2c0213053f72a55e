// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps unsaved work: notes it on the timeline, writes it to a journal, and offers it again after a crash.
#pragma once

#include <functional>
#include <optional>

#include "app/actions/messages.h"
#include "app/editing/surroundings.h"
#include "app/store/autosave.h"
#include "app/system/background_job.h"
#include "app/window/work/workspace.h"

namespace mes {

/// Guarantees: those of Autosave; the search for left work blocks nothing. Threads: the window's; `wake` is called
/// from others.
class WorkKeeper {
 public:
  /// `session_now` returns the document to keep, and `kept_in` the file that holds it when saved. Begins to search for
  /// work left behind.
  WorkKeeper(Workspace& work, Messages& messages, std::function<Session()> session_now,
             std::function<std::optional<SourceFile>()> kept_in, Waker wake);

  struct Rest {
    bool controls = false;  ///< no control of a panel is held
    bool all = false;       ///< in addition nothing moves or is being read
  };
  /// Called once per frame. Layers, settings and view are noted only at rest: a slider or zoom in motion is not final
  /// yet.
  void follow(const Rest& rest, const Box2& view);
  /// Notes that the document was restored together with this view.
  void take_as_noted(const Box2& view);
  /// Notes that a file now holds everything.
  void note_saved() { autosave_.note_saved(kept_in_()); }
  /// Notes that the unsaved work was given up.
  void discard() { autosave_.discard(); }
  /// Waits until the journal has been written.
  void flush() { autosave_.flush(); }
  /// True if the journal is on the disk and holds everything given so far.
  bool holds_all() { return autosave_.holds_all(); }

  /// The work left by an earlier run, given once when it has been found.
  std::optional<FoundWork> take_left_work() { return left_work_.poll(); }

 private:
  Surroundings surroundings(const Box2& view) const { return {work_.computation().settings(), view}; }

  Workspace& work_;
  Messages& messages_;
  std::function<Session()> session_now_;
  std::function<std::optional<SourceFile>()> kept_in_;
  SurroundingsNotes notes_;
  Autosave autosave_;
  BackgroundJob<FoundWork> left_work_;
};

}  // namespace mes
