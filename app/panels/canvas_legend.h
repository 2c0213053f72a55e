// SPDX-License-Identifier: GPL-3.0-or-later
// The colour bars of visible layers, above the canvas.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// With its lower right corner at `corner`, no higher than `room`. Its size in screen coordinates; nothing while no
/// visible layer has a colour map.
ImVec2 draw_canvas_legend(const PanelContext& context, ImVec2 corner, float room);

}  // namespace mes
