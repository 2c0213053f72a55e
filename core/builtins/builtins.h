// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own structures, layers, parameters, evolutions, shapes and file formats, as a registry.
#pragma once

#include "core/graph/registry.h"

namespace mes {

/// Adds them to an empty registry, which may take others afterwards.
void add_builtins(Registry& registry);

/// A registry of these alone, made at the first call.
const Registry& builtins();

/// Every layer, in default stacking order: first = bottom.
inline std::span<const LayerDescriptor> layer_descriptors() {
  return builtins().layers();
}

/// Registry position of a public id, or kNoLayer.
inline LayerIndex find_layer(std::string_view id) {
  return builtins().find_layer(id);
}

/// Null: there is none with that public id.
inline std::shared_ptr<const Evolution> find_evolution(std::string_view id) {
  return builtins().evolutions().find(id);
}

/// The layer that a variant shows: its own, or that of the main computation where they share it. `has_document` says
/// that the variant has samples and balls of its own.
inline VariantLayer layer_in(VariantIndex variant, bool has_document, LayerIndex layer) {
  const LayerDescriptor& descriptor = layer_descriptors()[layer];
  const bool is_shared = has_document ? descriptor.structures.empty() : !descriptor.follows_settings;
  return {is_shared ? kMainVariant : variant, layer};
}

}  // namespace mes
