// SPDX-License-Identifier: GPL-3.0-or-later
// Variants: the same layers, computed in other ways beside the main computation for comparison.
//
// Variant 0 is the main computation, of the document with the user's settings. Another variant has its own settings, or
// its own document as well. It computes the parts that differ, and shares the rest: with another number type, there is
// only one Delaunay triangulation and one crust.
//
// One patch, one scene and one mirror hold the layers of all variants. A layer that a variant shares exists once, as
// that of variant 0.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/ids.h"

namespace mes {

using VariantIndex = std::uint32_t;
inline constexpr VariantIndex kMainVariant = 0;

/// A layer of a variant. Layers are demanded, sent and drawn by this key.
struct VariantLayer {
  VariantIndex variant = kMainVariant;
  LayerIndex layer = 0;

  constexpr VariantLayer() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a layer without more is that of the main computation
  constexpr VariantLayer(LayerIndex of_main) : layer(of_main) {}
  constexpr VariantLayer(VariantIndex of, LayerIndex which) : variant(of), layer(which) {}
  friend constexpr auto operator<=>(const VariantLayer&, const VariantLayer&) = default;
};

/// The given layers, in the main computation.
inline std::vector<VariantLayer> main_layers(std::span<const LayerIndex> layers) {
  return {layers.begin(), layers.end()};
}

/// A `T` for each layer of each variant, by variant and layer.
template <class T>
class LayerTable {
 public:
  /// Creates the entry if necessary, and all before it.
  T& operator[](VariantLayer at) {
    if (variants_.size() <= at.variant) variants_.resize(at.variant + std::size_t{1});
    std::vector<T>& layers = variants_[at.variant];
    if (layers.size() <= at.layer) layers.resize(at.layer + std::size_t{1});
    return layers[at.layer];
  }
  /// Returns null if there is no entry.
  const T* find(VariantLayer at) const {
    if (at.variant >= variants_.size() || at.layer >= variants_[at.variant].size()) return nullptr;
    return &variants_[at.variant][at.layer];
  }
  T* find(VariantLayer at) { return const_cast<T*>(std::as_const(*this).find(at)); }
  template <class Visit>
  void for_each(Visit visit) {
    for (VariantIndex variant = 0; variant < variants_.size(); ++variant)
      for (LayerIndex layer = 0; layer < variants_[variant].size(); ++layer)
        visit(VariantLayer(variant, layer), variants_[variant][layer]);
  }

 private:
  std::vector<std::vector<T>> variants_;
};

}  // namespace mes
