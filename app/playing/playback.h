// SPDX-License-Identifier: GPL-3.0-or-later
// Plays the entries of a timeline on a stage: the common part of films, `mesecina play` and the demo.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/document/timeline/timeline.h"
#include "core/io/session/session.h"

namespace mes {

/// The display before the first entry of a timeline.
struct PlayStart {
  LayerConfiguration layers{};  ///< no layers: as at the start of the program
  ComputationSettings settings{};
  Box2 view{};  ///< empty: everything
};

/// The initial display: that of the program's start. A timeline of another program may not begin with its layers,
/// settings or view; then the last ones in it are used.
PlayStart start_of(const Session& session);

/// Consecutive entries without a picture between them, and the picture after them.
struct PlayStep {
  std::size_t first_entry = 0;
  std::size_t end_entry = 0;  ///< one past the last
  std::string_view what;      ///< kind of the entry that made the picture: "edit", "undo", "layers", ...
  double seconds = 0.0;       ///< duration in a video; 0: the usual one
};

/// Everything before the first action is the first step; then each visible entry is a step.
std::vector<PlayStep> steps_of(const TimelineLog& entries);

/// The target of a playback.
class Stage {
 public:
  virtual ~Stage() = default;
  /// Performs an edit, a gesture, a step of undo: every entry that no other function handles.
  virtual Expected<void> change_document(const TimelineEntry& entry) = 0;
  virtual void change_layers(const LayersChanged& change) = 0;
  virtual void change_settings(const ComputationSettings& settings) = 0;
  virtual void look_at(const Box2& box) = 0;
};

/// Guarantees: `perform` of the steps in order passes each entry to the stage once and in order; captions are kept
/// here. Cost: that of the stage. Threads: none.
///
/// Smallest use:
///     Playback playback(session.entries);
///     for (const PlayStep& step : playback.steps()) playback.perform(step, stage);
class Playback {
 public:
  explicit Playback(TimelineLog entries) : entries_(std::move(entries)), steps_(steps_of(entries_)) {}

  const std::vector<PlayStep>& steps() const { return steps_; }
  /// Error: the stage refuses an entry, which the error names; no later entry is passed on.
  Expected<void> perform(const PlayStep& step, Stage& stage);
  /// The same for the entries from `first` up to, not including, `end`.
  Expected<void> perform(std::size_t first, std::size_t end, Stage& stage);
  /// Caption of the last performed step; empty: none.
  const std::string& caption() const { return caption_; }

 private:
  Expected<void> perform(const TimelineEntry& entry, Stage& stage);

  TimelineLog entries_;
  std::vector<PlayStep> steps_;
  std::string caption_;
};

}  // namespace mes
