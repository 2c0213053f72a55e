// SPDX-License-Identifier: GPL-3.0-or-later
// The demo in the window: the same script as the video, computed live. An edit by hand takes over.
#pragma once

#include <optional>
#include <string>

#include "app/model/messages.h"
#include "app/model/view_fitter.h"
#include "app/playing/playback.h"
#include "app/ui/gui.h"
#include "app/window/workspace.h"
#include "core/io/session.h"

namespace mes {

/// What it guarantees: a step is taken when the picture of the one before is complete and has been seen for its time.
/// The demo ends with the layers and settings as they were before it. An edit by hand interrupts it: what is shown stays,
/// and can be edited on, until the demo is to go on from where it was, or to begin again. Threads: the window's.
class DemoRun : private Stage {
 public:
  DemoRun(Workspace& work, ViewFitter& fitter, Messages& messages)
      : work_(work), fitter_(fitter), messages_(messages) {}

  /// Plays it in the present document, which is empty.
  void start(const Session& session);
  /// `restore`: layers and settings become what they were, and nothing is left that would have to be saved.
  void end(bool restore);
  bool is_running() const { return run_ && !run_->is_interrupted; }
  /// Of the present step; empty while none runs.
  std::string caption() const { return is_running() ? run_->playback.caption() : std::string(); }
  /// When the next step is due, in seconds from `now`; nothing while none is going to be taken.
  std::optional<double> next_due(double now) const;

  /// Once a frame; `may_step`: the picture is complete. True when a step was taken.
  bool advance(double now, bool may_step);
  /// The caption, with its buttons, above `middle`. True when the demo is to begin again.
  bool draw(const Gui& gui, ImVec2 middle, float width);

 private:
  struct Run {
    Playback playback;
    std::size_t next = 0;
    bool is_paused = false;
    bool is_interrupted = false;  // by an edit
    double not_before = 0.0;      // seconds; the next step waits until then, and for the picture
    std::uint64_t document = 0;   // revision it left behind; another one means an edit by hand
    LayerConfiguration layers_before{};
    ComputationSettings settings_before{};
  };
  bool take_step(double now);
  /// Takes back what was edited since the interruption, as far as it can be.
  void go_on();
  Expected<void> change_document(const TimelineEntry& entry) override;
  void change_layers(const LayersChanged& change) override;
  void change_settings(const ComputationSettings& settings) override;
  void look_at(const Box2& box) override;

  Workspace& work_;
  ViewFitter& fitter_;
  Messages& messages_;
  std::optional<Run> run_;
};

}  // namespace mes
