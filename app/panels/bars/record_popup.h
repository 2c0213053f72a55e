// SPDX-License-Identifier: GPL-3.0-or-later
// The options for frames and snapshots: a button and its popup.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/picture/picture.h"
#include "app/recording/window_recorder.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct RecordPopup {
  const Gui& gui;
  const ActionBindings& actions;
  const WindowRecorder& record;
  const Picture& picture;
  RecordSettings& settings;

  /// `size` of the button in screen units.
  void draw(float size) const;
};

}  // namespace mes
