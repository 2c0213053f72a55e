// SPDX-License-Identifier: GPL-3.0-or-later
// The appearance of a layer. Changing a style never recomputes geometry and uploads nothing.
#pragma once

#include <string>

#include "core/base/color.h"

namespace mes {

struct LayerStyle {
  Rgb color{};
  double opacity = 1.0;        ///< [0, 1], multiplies the layer
  double point_size_px = 5.0;  ///< diameter of points, logical pixels, [0.5, 64]
  double line_width_px = 1.0;  ///< width of segments, rays, lines, circles, logical pixels, [0.1, 64]
  bool dashed = false;         ///< segments, rays, lines and circles are drawn dashed
  bool flat = false;           ///< draw the layer as one group, so that overlaps do not darken
  std::string color_map{};     ///< name of the map that colours by the layer's scalar; empty: `color` alone
  bool range_locked = false;   ///< the map spans the range below; otherwise the range of the visible values
  double range_low = 0.0;      ///< scalar at the first colour of the map, in its unit
  double range_high = 1.0;     ///< scalar at the last colour; not below `range_low`
  bool thin_when_dense =
      true;  ///< points and lines are drawn thinner than set above where samples are closer than pixels
  friend bool operator==(const LayerStyle&, const LayerStyle&) = default;
};

}  // namespace mes
