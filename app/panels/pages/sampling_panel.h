// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling density: its problems and their locations, and buttons that insert or remove samples until it is
// sufficient.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/canvas/canvas.h"
#include "app/editing/curves/resample_job.h"
#include "app/picture/picture.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Every location is a button that shows it. Threads: the window's.
class SamplingPanel {
 public:
  struct Uses {
    const Gui& gui;
    const ActionBindings& actions;
    ResampleJob& job;
    Canvas& canvas;
    const Document& document;
    const Engine& engine;
    const Picture& picture;
    Messages& messages;
  };
  explicit SamplingPanel(const Uses& uses) : uses_(uses) {}

  void draw();

 private:
  void draw_wishes();
  void draw_findings();
  void draw_report();
  /// Draws buttons in lines, as many as there is room for.
  void draw_places(std::span<const Vec2> places, std::int64_t count);

  Uses uses_;
};

}  // namespace mes
