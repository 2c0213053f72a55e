// SPDX-License-Identifier: GPL-3.0-or-later
// What to do with an empty canvas.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// Some lines about `middle`, with the keys of the action table; nothing once the document holds anything, above a
/// picture to trace, or while the pointer is drawing.
void draw_empty_hint(const PanelContext& context, ImVec2 middle);

}  // namespace mes
