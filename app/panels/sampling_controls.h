// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialogs that make samples of curves have in common: how they are sampled, and how they look.
#pragma once

#include "app/ui/gui.h"
#include "core/shapes/shape.h"

namespace mes {

/// Number, jitter and seed of samples.
class SamplingControls {
 public:
  void draw(const Gui& gui);
  ShapeSampling sampling() const;

 private:
  double samples_ = 400.0;
  bool has_samples_ = false;  // else as many as is usual
  double jitter_ = 0.0;
  double seed_ = 1.0;
};

/// Samples, contours and balls, fitted into what is left of the window.
void draw_sample_preview(const Gui& gui, const SampleData* data);

}  // namespace mes
