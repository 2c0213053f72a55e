// SPDX-License-Identifier: GPL-3.0-or-later
// The pane that marks are drawn into.
#pragma once

#include "app/ui/gui.h"
#include "render/camera.h"

namespace mes {

struct PanePart {
  const render::Camera& camera;  ///< as Canvas has it: of a window in which the pane lies where the main one does
  ImVec2 shift{};                ///< from the main pane to this one, in screen coordinates
};

}  // namespace mes
