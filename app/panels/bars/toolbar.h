// SPDX-License-Identifier: GPL-3.0-or-later
// The tools, and other frequent actions, as a strip of icons on the canvas.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/panels/bars/record_popup.h"
#include "app/settings/settings.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct Toolbar {
  const Gui& gui;
  const ActionBindings& actions;
  const Canvas& canvas;
  Settings& settings;
  RecordPopup record;

  /// Draws the strip with its upper left corner at `at`, in as many columns as it needs to be no higher than `room`.
  /// Returns its width in screen coordinates.
  float draw(ImVec2 at, float room) const;

 private:
  void draw_spray() const;
  void draw_brush() const;
};

}  // namespace mes
