// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the status bar that shows the work in progress: reading, writing, recording, compiling, computing.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/editing/update_hold.h"
#include "app/experiments/experiment_list.h"
#include "app/insight/parameter_sweep.h"
#include "app/recording/lesson_export.h"
#include "app/recording/window_recorder.h"
#include "app/store/document_files.h"
#include "app/ui/screen/gui.h"
#include "core/engine/engine.h"

namespace mes {

struct WorkInProgress {
  const Gui& gui;
  const ActionBindings& actions;
  const Engine& engine;
  DocumentFiles& files;
  WindowRecorder& record;
  LessonExport& lesson;
  const UpdateHold& hold;
  SweepJob& sweep;
  const ExperimentList& experiments;

  /// Draws a red dot and the number of frames during a recording.
  void draw_recording() const;
  /// Draws the present task with a way to stop it; returns false if there is none.
  bool draw() const;
  /// Draws the experiment that is being compiled or tried; returns false if there is none.
  bool draw_compilation() const;
};

}  // namespace mes
