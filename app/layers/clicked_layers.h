// SPDX-License-Identifier: GPL-3.0-or-later
// Which layers a click is about that takes a sample or a ball.
#pragma once

#include <vector>

#include "app/layers/layer_stack.h"

namespace mes {

/// The sample or ball that a click on the canvas took.
struct Clicked {
  bool is_ball = false;
  /// On the dot that shows it, or on the circle: not merely near enough to take it.
  bool is_on_mark = false;
};

/// The visible layers, top first, whose elements such a click is about as well: all that are drawn over what was taken,
/// points also where they are drawn below it, and lines beside it where they alone are under the pointer. Where nothing
/// shows what was taken, all of them.
std::vector<LayerIndex> layers_of_click(const LayerStack& layers, const Clicked& clicked);

}  // namespace mes
