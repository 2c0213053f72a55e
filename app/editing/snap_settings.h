// SPDX-License-Identifier: GPL-3.0-or-later
// What places under the hand snap to. Plain data.
#pragma once

namespace mes {

struct SnapSettings {
  bool is_on = false;
  bool samples = true;
  bool centers = true;   ///< of own balls
  bool vertices = true;  ///< of the Voronoi diagram: centres of circles through three samples
  bool circles = true;   ///< of own balls
  bool curves = true;    ///< that samples were taken from
  bool grid = true;      ///< lines of the grid, and where they cross
  bool pixels = false;   ///< round numbers, at most a pixel of the screen apart
  friend bool operator==(const SnapSettings&, const SnapSettings&) = default;
};

}  // namespace mes
