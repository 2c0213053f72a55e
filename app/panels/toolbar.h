// SPDX-License-Identifier: GPL-3.0-or-later
// The tools, and what one reaches for while drawing, as a strip of icons on the canvas.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// Draws the strip with its upper left corner at `at`, in as many columns as it needs to be no higher than `room`;
/// its width in screen coordinates.
float draw_toolbar(const PanelContext& context, ImVec2 at, float room);

}  // namespace mes
