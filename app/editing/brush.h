// SPDX-License-Identifier: GPL-3.0-or-later
// Samples under a brush: erased, thinned out, or made denser along the curve.
#pragma once

#include <map>
#include <set>
#include <utility>

#include "app/editing/brush_settings.h"
#include "app/editing/editor.h"

namespace mes {

/// What one stroke of the brush does, from press to release.
///
/// What it guarantees: a stroke thins out and refines each part of the curve once, however often it passes over it. The
/// curve is the one-step crust of the samples within three radii, or farther where these are few, at most `kMostSamples`
/// of them. A sample is put between two neighbours where the brush is on both or on the place between them; it lies on
/// an arc with the curvature that the curve has at both neighbours. Where these are neighbours on a contour of the document,
/// too, the new sample is between them there once the stroke is finished. Each touch is one command, and so is the end of a
/// stroke along contours; the caller opens the gesture.
///
/// Cost of a touch: that of the crust of the samples near by; of the end: O(samples on contours). Threads: the window's.
class BrushStroke {
 public:
  static constexpr std::size_t kMostSamples = 2000;

  explicit BrushStroke(Editor& editor) : editor_(editor) {}

  /// Error: that of the edit, or once in a stroke `cannot_compute`, where there are too many samples near by to find a
  /// curve.
  Expected<void> touch(Vec2 at, double radius, BrushMode mode);
  /// After the last touch, within the gesture. Error: that of the edit.
  Expected<void> finish();

 private:
  using Pair = std::pair<SampleId, SampleId>;
  Expected<void> erase(Vec2 at, double radius);
  Expected<void> along_curve(Vec2 at, double radius, BrushMode mode);

  Editor& editor_;
  bool is_refused_ = false;
  std::set<SampleId> kept_;           // of those that thinning leaves
  std::set<Pair> refined_;            // neighbours that nothing more comes between
  std::map<Pair, SampleId> between_;  // what came between these
};

}  // namespace mes
