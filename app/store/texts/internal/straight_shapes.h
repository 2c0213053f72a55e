// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the instances of a layer to points, chains and polygons.
#pragma once

#include <optional>
#include <vector>

#include "app/store/texts/layer_text.h"
#include "core/base/geometry/disk.h"

namespace mes {

enum class StraightKind : std::uint8_t { point, chain, polygon };

/// One shape.
struct StraightShape {
  StraightKind kind = StraightKind::point;
  PrimitiveKind of = PrimitiveKind::point;
  std::vector<Vec2> corners;     ///< for a polygon counter-clockwise, with the first repeated
  std::optional<Disk> circle{};  ///< the circle that the shape approximates
  std::optional<double> scalar{};
  std::vector<double> scalars{};           ///< one per side of a chain of segments, if its layer has scalars
  std::vector<std::vector<Vec2>> holes{};  ///< of a polygon, clockwise, with the first point repeated
};

/// All shapes of a layer, with segments and parabolas joined into chains; a closed chain ends at its first point.
/// Rays and lines are counted in `left_out`.
std::vector<StraightShape> straight_shapes_of(const LayerGeometry& geometry, LayerIndex layer,
                                              std::uint64_t& left_out);

/// The areas that the lines of a layer enclose, by the even-odd rule (`areas_of`); other kinds as above. Counts what is
/// left out in `out`.
std::vector<StraightShape> area_shapes_of(const LayerGeometry& geometry, LayerIndex layer, LayerText& out);

}  // namespace mes
