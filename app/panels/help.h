// SPDX-License-Identifier: GPL-3.0-or-later
// Every key and gesture on one page, from the action table.
#pragma once

#include "app/ui/gui.h"

namespace mes {

/// Draws the page over the window while `*open`; a click beside it or on its cross closes it.
void draw_help(const Gui& gui, bool* open);

}  // namespace mes
