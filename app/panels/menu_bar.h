// SPDX-License-Identifier: GPL-3.0-or-later
// File, Edit, View, Shapes, Tools, Help: every action of the table, and what has no key.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// Draws the menu bar across the window; its height in screen coordinates.
float draw_menu_bar(const PanelContext& context);

}  // namespace mes
