// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and times of every structure that is in use.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

void draw_statistics(const PanelContext& context);

}  // namespace mes
