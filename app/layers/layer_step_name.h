// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a layer change in the Edit menu.
#pragma once

#include <string>

#include "app/layers/layer_stack.h"

namespace mes {

/// "Hide Voronoi", "Style of Curve", "Show 3 layers"; `before` and `after` differ as `difference` says, either way.
std::string name_of_change(const LayerStack& layers, const LayersChanged& before, const LayersChanged& after);

}  // namespace mes
