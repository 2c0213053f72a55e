// SPDX-License-Identifier: GPL-3.0-or-later
// The slider of evolutions, in a strip over the canvas.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// Its lower left corner stands at `at`. Gives the height it takes.
float draw_evolution_strip(const PanelContext& context, ImVec2 at, float width);

}  // namespace mes
