// SPDX-License-Identifier: GPL-3.0-or-later
// What the program has said since it was started.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

void draw_log(const PanelContext& context);

}  // namespace mes
