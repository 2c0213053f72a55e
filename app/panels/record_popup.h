// SPDX-License-Identifier: GPL-3.0-or-later
// How frames and snapshots are made: a button, and what opens from it.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// `size` of the button in screen units.
void draw_record_popup(const PanelContext& context, float size);

}  // namespace mes
