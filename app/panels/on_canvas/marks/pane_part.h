// SPDX-License-Identifier: GPL-3.0-or-later
// The pane in which marks are drawn.
#pragma once

#include "app/ui/screen/gui.h"
#include "render/camera.h"

namespace mes {

struct PanePart {
  const render::Camera& camera;  ///< camera of a window in which this pane has the position of the main one (Canvas)
  ImVec2 shift{};                ///< shift from the main pane to this one, in screen coordinates
};

}  // namespace mes
