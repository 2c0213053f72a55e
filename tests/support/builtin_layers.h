// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own registry, for tests that need no other one.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/builtins/builtins.h"
#include "core/evolutions/evolution.h"

namespace mes {

/// Every layer, in default stacking order: first = bottom.
inline std::span<const LayerDescriptor> layer_descriptors() {
  return builtins().layers();
}

/// The index of a layer by public id, or kNoLayer.
inline LayerIndex find_layer(std::string_view id) {
  return builtins().find_layer(id);
}

/// The evolution with that public id; null if there is none.
inline std::shared_ptr<const Evolution> find_evolution(std::string_view id) {
  return builtins().evolutions().find(id);
}

/// The layer that a variant shows (`Registry::layer_in`).
inline VariantLayer layer_in(VariantIndex variant, bool has_document, LayerIndex layer) {
  return builtins().layer_in(variant, has_document, layer);
}

}  // namespace mes
