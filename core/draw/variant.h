// SPDX-License-Identifier: GPL-3.0-or-later
// Variants: the same layers computed in other ways beside the main computation, to be seen side by side.
//
// Variant 0 is the main computation, of the document with the user's settings. Another one has settings of its own,
// or a document of its own as well. It computes what differs, and shares the rest: with another number type, the
// Delaunay triangulation and the crust are there once.
//
// The layers of all variants are numbered in one row, so that one patch, one scene and one mirror hold them all: those
// of variant 1 follow those of variant 0. A layer that a variant shares has its number in variant 0.
#pragma once

#include <cstdint>

#include "core/base/slot.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

using VariantIndex = std::uint32_t;
inline constexpr VariantIndex kMainVariant = 0;

/// The number under which a layer of a variant is demanded, sent and drawn; `has_document` says that the variant has
/// samples and balls of its own.
inline LayerIndex layer_in(VariantIndex variant, bool has_document, LayerIndex layer) {
  const LayerDescriptor& descriptor = layer_descriptors()[layer];
  const bool is_shared = has_document ? descriptor.structures.empty() : !descriptor.follows_settings;
  return is_shared ? layer : variant * static_cast<LayerIndex>(layer_descriptors().size()) + layer;
}

/// The layer that a number stands for, whatever the variant.
inline LayerIndex plain_layer(LayerIndex layer) {
  return layer % static_cast<LayerIndex>(layer_descriptors().size());
}

}  // namespace mes
