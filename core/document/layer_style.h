// SPDX-License-Identifier: GPL-3.0-or-later
// How a layer looks. Changing a style never recomputes geometry and uploads nothing.
#pragma once

#include "core/base/color.h"

namespace mes {

struct LayerStyle {
  Rgb color{};
  double opacity = 1.0;        ///< [0, 1], multiplies the layer
  double point_size_px = 5.0;  ///< diameter of points, logical pixels, [0.5, 64]
  double line_width_px = 1.0;  ///< width of segments, rays, lines, circles, logical pixels, [0.1, 64]
  bool dashed = false;         ///< segments, rays, lines and circles are drawn dashed
  bool flat = false;           ///< draw the layer as one group, so that overlaps do not darken
  friend bool operator==(const LayerStyle&, const LayerStyle&) = default;
};

}  // namespace mes
