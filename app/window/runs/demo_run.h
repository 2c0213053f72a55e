// SPDX-License-Identifier: GPL-3.0-or-later
// The demo in the window: the script of the video, computed live. An edit by hand interrupts it.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/actions/messages.h"
#include "app/panes/view_fitter.h"
#include "app/playing/playback.h"
#include "app/ui/screen/gui.h"
#include "app/window/work/workspace.h"
#include "core/io/session/session.h"

namespace mes {

/// Guarantees: a step is taken when the picture of the previous step is complete and has been shown for its time. The
/// demo ends with the layers and settings from before it. An edit by hand interrupts it: the drawing stays and can be
/// edited until the user continues the demo or starts it again. Threads: the window's.
class DemoRun : private Stage {
 public:
  DemoRun(Workspace& work, ViewFitter& fitter, Messages& messages)
      : work_(work), fitter_(fitter), messages_(messages) {}

  /// Plays the demo in the present document, which is empty.
  void start(const Session& session);
  /// `restore`: restores layers and settings, and leaves nothing that would have to be saved.
  void end(bool restore);
  /// Ends it at its last step or by the user, so that the document from before can come back.
  void finish();
  /// Whether it was finished since the last call, and its drawing was not edited.
  bool take_finished() { return std::exchange(is_finished_, false); }
  bool is_running() const { return run_ && !run_->is_interrupted; }
  /// Caption of the present step; empty while the demo does not run.
  std::string caption() const { return is_running() ? run_->playback.caption() : std::string(); }
  /// Seconds from `now` until the next step is due; nothing if none is planned.
  std::optional<double> next_due(double now) const;

  /// Call it once per frame; `may_step`: the picture is complete. Returns true if a step was taken.
  bool advance(double now, bool may_step);
  /// Draws the caption and its buttons above `middle`. Returns true if the demo is to start again.
  bool draw(const Gui& gui, ImVec2 middle, float width);

 private:
  struct Run {
    Playback playback;
    std::size_t next = 0;
    bool is_paused = false;
    bool is_interrupted = false;  // an edit has interrupted it
    double not_before = 0.0;      // earliest time of the next step in seconds; it also waits for the picture
    std::uint64_t document = 0;   // revision after the last step; another one means an edit by hand
    LayerConfiguration layers_before{};
    ComputationSettings settings_before{};
  };
  bool take_step(double now);
  /// Undoes the edits since the interruption, as far as possible.
  void go_on();
  Expected<void> change_document(const TimelineEntry& entry) override;
  void change_layers(const LayersChanged& change) override;
  void change_settings(const ComputationSettings& settings) override;
  void look_at(const Box2& box) override;

  Workspace& work_;
  ViewFitter& fitter_;
  Messages& messages_;
  std::optional<Run> run_;
  bool is_finished_ = false;
};

}  // namespace mes
