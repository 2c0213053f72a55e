// SPDX-License-Identifier: GPL-3.0-or-later
// The elements to which positions snap. Plain data.
#pragma once

namespace mes {

struct SnapSettings {
  bool is_on = false;
  bool samples = true;
  bool centers = true;   ///< centres of own balls
  bool vertices = true;  ///< vertices of the Voronoi diagram: centres of circles through three samples
  bool circles = true;   ///< circles of own balls
  bool curves = true;    ///< curves that samples were taken from
  bool grid = true;      ///< lines of the grid, and their crossings
  bool pixels = false;   ///< round numbers, at most a pixel of the screen apart
  friend bool operator==(const SnapSettings&, const SnapSettings&) = default;
};

}  // namespace mes
