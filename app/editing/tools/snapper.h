// SPDX-License-Identifier: GPL-3.0-or-later
// Snaps positions to elements near the pointer.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "app/editing/editor.h"
#include "app/editing/tools/annotation_editor.h"
#include "app/editing/tools/snap_settings.h"

namespace mes {

/// A position with the kind of its element: "sample", "grid", ...
struct Snap {
  Vec2 place{};
  std::string_view name;
};

/// Guarantees: takes the nearest of the samples, centres and vertices within reach; else the nearest point on a
/// circle or on a curve that samples were taken from; else a crossing or a line of the grid; else round numbers
/// within the pixel. Coordinates of the grid and of pixels are the doubles nearest to the decimal numbers on the
/// axes, for steps from 1e-22 to 1e22.
///
/// Cost: a search among nearby samples; balls are searched one by one. Threads: the window's.
class Snapper {
 public:
  /// The present distances of lines, in units, each 1, 2 or 5 times a power of ten; 0 or less if there are no lines.
  struct Steps {
    double grid = 0.0;
    double pixel = 0.0;
  };
  /// All arguments must outlive it.
  Snapper(const Editor& editor, const AnnotationEditor& vertices, const SnapSettings& settings,
          std::function<Steps()> steps)
      : editor_(editor), vertices_(vertices), settings_(settings), steps_(std::move(steps)) {}

  /// The elements to ignore: those that move with the pointer, and vertices of moving samples.
  struct Except {
    std::function<bool(SampleSlot)> sample{};  ///< empty: ignores none
    std::function<bool(BallSlot)> ball{};
    bool vertices = false;
  };
  /// Nothing if snapping is off, or nothing is within `reach`, in units.
  std::optional<Snap> at(Vec2 p, double reach, const Except& except) const;

 private:
  std::optional<Snap> point_at(Vec2 p, double reach, const Except& except) const;
  std::optional<Snap> curve_at(Vec2 p, double reach) const;
  std::optional<Snap> circle_at(Vec2 p, double reach, const Except& except) const;
  static std::optional<Snap> lines_at(Vec2 p, double reach, double step);

  const Editor& editor_;
  const AnnotationEditor& vertices_;
  const SnapSettings& settings_;
  std::function<Steps()> steps_;
};

}  // namespace mes
