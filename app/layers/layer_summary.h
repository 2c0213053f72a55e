// SPDX-License-Identifier: GPL-3.0-or-later
// A summary of a layer: counts and sums over its instances.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/sum.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/primitive_values.h"

namespace mes {

struct LayerSummary {
  std::array<std::uint64_t, kPrimitiveKinds> count{};  ///< zero-length segments not counted
  std::uint64_t zero_length = 0;                       ///< segments whose ends are equal
  std::uint64_t not_finite = 0;                        ///< lengths and areas too large for a double, not in the sums
  double length = 0.0;                                 ///< total length of segments and arcs
  double radius_sum = 0.0;                             ///< total radius of circles and disks
  double area = 0.0;                                   ///< total area of the triangles
};

/// Adds up the pieces of a layer.
class LayerTally {
 public:
  /// `values` are instances as in `InstancePiece`.
  void add(PrimitiveKind kind, std::span<const double> values);
  LayerSummary summary() const;

 private:
  LayerSummary counts_;
  Sum length_;
  Sum radius_sum_;
  Sum area_;
};

LayerSummary summarise(const LayerMirror& mirror, LayerIndex layer);

/// "points", "disks", ...
std::string_view plural_of(PrimitiveKind kind);

}  // namespace mes
