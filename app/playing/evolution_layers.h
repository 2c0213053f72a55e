// SPDX-License-Identifier: GPL-3.0-or-later
// Which layers show what an evolution does.
#pragma once

#include <optional>
#include <vector>

#include "app/insight/persistence_table.h"
#include "app/layers/layer_stack.h"
#include "core/evolutions/evolution.h"

namespace mes {

/// Layers that would show the evolution, none of which is visible; empty: some layer that follows it is.
std::vector<LayerIndex> layers_to_show(const Evolution& evolution, const LayerStack& layers,
                                       const Document& document);

/// What grows additively in the layers that are shown: `preferred`, if that is among it, or else the first; nothing: none.
std::optional<GrowthOf> shown_growth(const LayerStack& layers, GrowthOf preferred);

}  // namespace mes
