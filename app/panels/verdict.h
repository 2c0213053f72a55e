// SPDX-License-Identifier: GPL-3.0-or-later
// Number type and theorem light: always in view, at the end of the status bar.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// Width that `draw_verdict` takes.
float verdict_width(const PanelContext& context);

/// Draws in the present window at the present place: a choice of number types, and the light, which opens the list of
/// reasons; a click on a reason shows its place.
void draw_verdict(const PanelContext& context);

}  // namespace mes
