// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the layers that a click on a sample or a ball refers to.
#pragma once

#include <vector>

#include "app/layers/layer_stack.h"

namespace mes {

/// The sample or ball that a click on the canvas took.
struct Clicked {
  bool is_ball = false;
  /// True on the dot or the circle that shows the element, not merely near enough to take it.
  bool is_on_mark = false;
};

/// The visible layers, top first, to which such a click refers as well: all layers drawn over the taken element;
/// layers of points also if drawn below it; and layers of lines beside it if the pointer is on them alone. If no
/// layer shows the taken element, all visible layers.
std::vector<LayerIndex> layers_of_click(const LayerStack& layers, const Clicked& clicked);

}  // namespace mes
