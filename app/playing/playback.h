// SPDX-License-Identifier: GPL-3.0-or-later
// Plays the entries of a timeline on a stage: what films, `mesecina play` and the demo share.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/box2.h"
#include "core/base/error.h"
#include "core/document/timeline.h"
#include "core/io/session/session.h"

namespace mes {

/// What is shown before the first entry of a timeline.
struct PlayStart {
  LayerConfiguration layers{};  ///< no layers: as at the start of the program
  ComputationSettings settings{};
  Box2 view{};  ///< empty: everything
};

/// Nothing but what the program starts with; but of a timeline that does not begin with its layers, settings or view,
/// which other hands made, those that were there last.
PlayStart start_of(const Session& session);

/// What follows each other without a picture of its own between, and the picture after it.
struct PlayStep {
  std::size_t first_entry = 0;
  std::size_t end_entry = 0;  ///< one past the last
  std::string_view what;      ///< of the entry that made the picture: "edit", "undo", "layers", ...
  double seconds = 0.0;       ///< how long it stays in a video; 0: as long as any
};

/// Everything before the first thing that was done is the first step, then each entry that can be seen is one.
std::vector<PlayStep> steps_of(const TimelineLog& entries);

/// Where a timeline is played.
class Stage {
 public:
  virtual ~Stage() = default;
  /// An edit, a gesture, a step of undo: every entry that none of the others takes.
  virtual Expected<void> change_document(const TimelineEntry& entry) = 0;
  virtual void change_layers(const LayersChanged& change) = 0;
  virtual void change_settings(const ComputationSettings& settings) = 0;
  virtual void look_at(const Box2& box) = 0;
};

/// What it guarantees: `perform` of the steps in order hands each entry to the stage once, in its order; captions are
/// kept here. Cost: that of the stage. Threads: none.
///
/// Smallest use:
///     Playback playback(session.entries);
///     for (const PlayStep& step : playback.steps()) playback.perform(step, stage);
class Playback {
 public:
  explicit Playback(TimelineLog entries) : entries_(std::move(entries)), steps_(steps_of(entries_)) {}

  const std::vector<PlayStep>& steps() const { return steps_; }
  /// Error: the stage refuses an entry, which the error names; no entry after it is handed on.
  Expected<void> perform(const PlayStep& step, Stage& stage);
  /// The same for the entries from `first` up to, not including, `end`.
  Expected<void> perform(std::size_t first, std::size_t end, Stage& stage);
  /// Of the last step that was performed; empty: none.
  const std::string& caption() const { return caption_; }

 private:
  Expected<void> perform(const TimelineEntry& entry, Stage& stage);

  TimelineLog entries_;
  std::vector<PlayStep> steps_;
  std::string caption_;
};

}  // namespace mes
