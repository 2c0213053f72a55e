// SPDX-License-Identifier: GPL-3.0-or-later
// The instances of a layer as points, chains and polygons.
#pragma once

#include <optional>
#include <vector>

#include "app/store/layer_text.h"
#include "core/base/disk.h"

namespace mes {

enum class StraightKind : std::uint8_t { point, chain, polygon };

/// One shape.
struct StraightShape {
  StraightKind kind = StraightKind::point;
  PrimitiveKind of = PrimitiveKind::point;
  std::vector<Vec2> corners;     ///< of a polygon counter-clockwise, and the first is repeated
  std::optional<Disk> circle{};  ///< what it stands for
  std::optional<double> scalar{};
  std::vector<double> scalars{};  ///< of the sides of a chain of segments, where its layer has scalars
};

/// All shapes of a layer, with segments joined to chains; a closed chain ends where it begins. Rays and lines are counted
/// in `left_out`.
std::vector<StraightShape> straight_shapes_of(const LayerGeometry& geometry, LayerIndex layer,
                                              std::uint64_t& left_out);

}  // namespace mes
