// SPDX-License-Identifier: GPL-3.0-or-later
// Places that the hand means when it is near them.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "app/editing/annotation_desk.h"
#include "app/editing/editor.h"
#include "app/editing/snap_settings.h"

namespace mes {

/// A place with what it is: "sample", "grid", ...
struct Snap {
  Vec2 place{};
  std::string_view name;
};

/// What it guarantees: of samples, centres and vertices within reach the nearest one is taken, else the nearest place on a
/// circle or a curve that samples were taken from, else a crossing of the grid or a place on one of its lines, else round
/// numbers that a pixel has. Coordinates of the grid, and of pixels, are the doubles nearest to the decimal numbers that the axes show, for steps from 1e-22 to 1e22.
///
/// Cost: a search among the samples near by; balls are looked at one by one. Threads: the window's.
class Snapper {
 public:
  /// Distances of lines at present, in units, each 1, 2 or 5 times a power of ten; 0 or less where there are none.
  struct Steps {
    double grid = 0.0;
    double pixel = 0.0;
  };
  /// All that is named outlives it.
  Snapper(const Editor& editor, const AnnotationDesk& vertices, const SnapSettings& settings,
          std::function<Steps()> steps)
      : editor_(editor), vertices_(vertices), settings_(settings), steps_(std::move(steps)) {}

  /// What places do not snap to: things that move with the pointer, and vertices of samples that move.
  struct Except {
    std::function<bool(SampleSlot)> sample{};  ///< empty: none
    std::function<bool(BallSlot)> ball{};
    bool vertices = false;
  };
  /// Nothing where snapping is off, or nothing is within `reach`, in units.
  std::optional<Snap> at(Vec2 p, double reach, const Except& except) const;

 private:
  std::optional<Snap> point_at(Vec2 p, double reach, const Except& except) const;
  std::optional<Snap> curve_at(Vec2 p, double reach) const;
  std::optional<Snap> circle_at(Vec2 p, double reach, const Except& except) const;
  static std::optional<Snap> lines_at(Vec2 p, double reach, double step);

  const Editor& editor_;
  const AnnotationDesk& vertices_;
  const SnapSettings& settings_;
  std::function<Steps()> steps_;
};

}  // namespace mes
