// SPDX-License-Identifier: GPL-3.0-or-later
// The brush: it erases samples, thins them out, or makes them denser along the curve.
#pragma once

#include <map>
#include <set>
#include <utility>

#include "app/editing/editor.h"
#include "app/editing/tools/brush_settings.h"

namespace mes {

/// One stroke of the brush, from press to release.
///
/// Guarantees: a stroke thins out and refines each part of the curve once, however often it passes over it. The curve
/// is the one-step crust of the samples within three radii, or within more if these are few, but of at most
/// `kMostSamples`. A new sample is put between two neighbours if the brush covers both or the point between them; it
/// lies on an arc with the mean of the curvatures at both neighbours. If they are also neighbours on a contour of the
/// document, the new sample is inserted between them there when the stroke ends. Each touch is one command, and so is
/// the end of a stroke along contours; the caller opens the gesture.
///
/// Cost: per touch, the crust of the nearby samples; at the end, O(samples on contours). Threads: the window's.
class BrushStroke {
 public:
  static constexpr std::size_t kMostSamples = 2000;

  explicit BrushStroke(Editor& editor) : editor_(editor) {}

  /// Error: that of the edit; or `cannot_compute`, once per stroke, if there are too many samples nearby to find a
  /// curve.
  Expected<void> touch(Vec2 at, double radius, BrushMode mode);
  /// Call it after the last touch, within the gesture. Error: that of the edit.
  Expected<void> finish();

 private:
  using Pair = std::pair<SampleId, SampleId>;
  Expected<void> erase(Vec2 at, double radius);
  Expected<void> along_curve(Vec2 at, double radius, BrushMode mode);

  Editor& editor_;
  bool is_refused_ = false;
  std::set<SampleId> kept_;           // samples that thinning keeps
  std::set<Pair> refined_;            // neighbours that get no more samples between them
  std::map<Pair, SampleId> between_;  // the sample put between these neighbours
};

}  // namespace mes
