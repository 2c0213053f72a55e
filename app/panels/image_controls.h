// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done with the picture to trace: which one it is, where it lies and how large it is.
#pragma once

#include "app/panels/panel_context.h"

namespace mes {

/// Changes the picture of the layer stack.
void draw_image_controls(const PanelContext& context);

}  // namespace mes
