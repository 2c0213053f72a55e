// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and times of every active structure.
#pragma once

#include "app/picture/picture.h"
#include "app/ui/screen/frame_times.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct StatisticsPanel {
  const Gui& gui;
  const Picture& picture;
  const FrameTimes& times;

  void draw() const;
};

}  // namespace mes
