// SPDX-License-Identifier: GPL-3.0-or-later
// A copy of the drawing in plain memory: every instance of every layer, kept up to date by patches.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/draw/layer_digest.h"
#include "core/draw/patch.h"

namespace mes {

/// Follows the complete result by its changes; for the command line and tests.
///
/// Guarantees:
///  1. After `apply`, `instances(layer, kind)` holds `count(layer, kind)` instances of `stride_of(kind)` doubles
///     each, in the order of the drawing buffer.
///  2. A patch that breaks its promises is refused by an assertion: data of the wrong size, growth without data, an
///     unannounced change of count, a value that is not finite, a negative radius, a ray or line without direction,
///     instances left in an old drawing frame, layers of a stopped run.
///
/// Smallest use:
///     LayerMirror mirror;
///     while (auto patch = engine.sync()) { mirror.apply(*patch); engine.recycle(std::move(patch)); }
///     mirror.count(registry.find_layer("medial-axis"), PrimitiveKind::segment);
///
/// Cost: O(size of the patch). Threads: several may read while none applies a patch.
class LayerMirror {
 public:
  void apply(const FramePatch& patch);

  std::uint32_t count(VariantLayer layer, PrimitiveKind kind) const;
  std::span<const double> instances(VariantLayer layer, PrimitiveKind kind) const;
  /// Digest of the layer's drawing, without scalars that are names. O(1): `apply` keeps it up to date.
  LayerDigest digest(VariantLayer layer) const;
  /// The frame of the last patch.
  const DrawingFrame& frame() const { return frame_; }
  std::uint64_t document_revision() const { return document_revision_; }

 private:
  struct Instances {
    std::vector<double> values;
    LayerDigest digest;  // the sum over the instances
  };
  void leave_frame(const FramePatch& patch);
  void apply(const KindPatch& patch, PrimitiveKind kind, bool with_scalars, Instances& instances);

  LayerTable<std::array<Instances, kPrimitiveKinds>> layers_;
  std::vector<bool> written_;  // during `apply`: the instances that a growing patch has written
  DrawingFrame frame_;
  std::uint64_t document_revision_ = 0;
};

}  // namespace mes
