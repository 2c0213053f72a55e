// SPDX-License-Identifier: GPL-3.0-or-later
// One line at the foot of the window: what to do or what happened, what is being computed, counts, coordinates.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// Height in screen coordinates.
float status_bar_height(const Gui& gui);
void draw_status_bar(const PanelContext& context, const PanelArea& area);

/// A problem stands over the canvas until it is closed.
void draw_problem(const PanelContext& context, ImVec2 at, float width);

}  // namespace mes
