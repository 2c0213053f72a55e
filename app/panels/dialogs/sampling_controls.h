// SPDX-License-Identifier: GPL-3.0-or-later
// The common part of the dialogs that sample curves: sampling options and preview.
#pragma once

#include "app/ui/screen/gui.h"
#include "core/shapes/shape.h"

namespace mes {

/// Number, jitter and seed of samples.
class SamplingControls {
 public:
  void draw(const Gui& gui);
  ShapeSampling sampling() const;

 private:
  double samples_ = 400.0;
  bool has_samples_ = false;  // false: the default number
  double jitter_ = 0.0;
  double seed_ = 1.0;
};

/// Draws samples, contours and balls, fitted into the remaining area of the window.
void draw_sample_preview(const Gui& gui, const SampleData* data);

}  // namespace mes
