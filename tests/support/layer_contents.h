// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a consumer of patches: all instances of every layer, for comparison.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include "core/draw/patch.h"

namespace mes::test {

class LayerContents {
 public:
  /// Applies a patch like a drawing buffer, and requires it to be well formed.
  void apply(const FramePatch& patch) {
    for (std::size_t i = 0; i < patch.layer_count; ++i) {
      const LayerPatch& layer = patch.layers[i];
      for (const PrimitiveKind kind : kAllPrimitiveKinds) apply(layer[kind], kind, layers_[layer.layer]);
    }
  }

  /// The sorted instances; segments and lines have no direction.
  std::vector<std::vector<double>> sorted(VariantLayer layer) const {
    std::vector<std::vector<double>> out;
    const auto found = layers_.find(layer);
    if (found == layers_.end()) return out;
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      const auto& data = found->second[static_cast<std::size_t>(kind)];
      const std::size_t stride = stride_of(kind);
      for (std::size_t at = 0; at < data.size(); at += stride) {
        std::vector<double> instance{static_cast<double>(kind)};
        instance.insert(instance.end(), data.begin() + static_cast<std::ptrdiff_t>(at),
                        data.begin() + static_cast<std::ptrdiff_t>(at + stride));
        if (kind == PrimitiveKind::segment &&
            std::pair(instance[3], instance[4]) < std::pair(instance[1], instance[2])) {
          std::swap(instance[1], instance[3]);
          std::swap(instance[2], instance[4]);
        }
        if (kind == PrimitiveKind::line && std::pair(instance[3], instance[4]) < std::pair(0.0, 0.0)) {
          instance[3] = -instance[3];
          instance[4] = -instance[4];
        }
        if (kind == PrimitiveKind::triangle) {
          // Rotate the smallest corner to the front.
          while (std::min(std::pair(instance[3], instance[4]), std::pair(instance[5], instance[6])) <
                 std::pair(instance[1], instance[2]))
            std::rotate(instance.begin() + 1, instance.begin() + 3, instance.begin() + 7);
        }
        out.push_back(std::move(instance));
      }
    }
    std::ranges::sort(out);
    return out;
  }

  std::size_t count(VariantLayer layer, PrimitiveKind kind) const {
    const auto found = layers_.find(layer);
    return found == layers_.end() ? 0 : found->second[static_cast<std::size_t>(kind)].size() / stride_of(kind);
  }

 private:
  using Kinds = std::array<std::vector<double>, kPrimitiveKinds>;

  static void apply(const KindPatch& patch, PrimitiveKind kind, Kinds& kinds) {
    if (patch.is_empty()) return;
    const std::size_t stride = stride_of(kind);
    auto& data = kinds[static_cast<std::size_t>(kind)];
    for (const double value : patch.data)
      if (!std::isfinite(value)) FAIL("a patch holds a number that is not finite");
    if (patch.reset) {
      if (patch.data.size() != patch.count * stride || !patch.index.empty()) FAIL("a reset patch has the wrong size");
      data = patch.data;
      return;
    }
    if (patch.data.size() != patch.index.size() * stride) FAIL("a patch has the wrong size");
    // Instances may be written beyond the final count before the buffer shrinks.
    for (std::size_t i = 0; i < patch.index.size(); ++i) {
      const std::size_t at = patch.index[i] * stride;
      if (data.size() < at + stride) data.resize(at + stride, -1e99);
      std::copy_n(patch.data.begin() + static_cast<std::ptrdiff_t>(i * stride), stride,
                  data.begin() + static_cast<std::ptrdiff_t>(at));
    }
    if (data.size() < patch.count * stride) FAIL("a patch leaves instances without contents");
    data.resize(patch.count * stride);
  }

  std::map<VariantLayer, Kinds> layers_;
};

}  // namespace mes::test
