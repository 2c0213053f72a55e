// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the layers that show the effect of an evolution.
#pragma once

#include <optional>
#include <vector>

#include "app/insight/persistence_table.h"
#include "app/layers/layer_stack.h"
#include "core/evolutions/evolution.h"

namespace mes {

/// Layers that would show the evolution, if none of its layers is visible; else empty.
std::vector<LayerIndex> layers_to_show(const Evolution& evolution, const LayerStack& layers,
                                       const Document& document);

/// The additively growing family in the visible layers: `preferred` if it is among them, else the first; nothing if
/// there is none.
std::optional<GrowthOf> shown_growth(const LayerStack& layers, GrowthOf preferred);

}  // namespace mes
