// SPDX-License-Identifier: GPL-3.0-or-later
// The curves from which the samples were taken: sampling rule, density, and treatment of corners.
#pragma once

#include <optional>

#include "app/actions/action_bindings.h"
#include "app/editing/curves/curve_sampler.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// The samples follow a slider while it is dragged. Threads: the window's.
class CurvesPanel {
 public:
  CurvesPanel(const Gui& gui, const ActionBindings& actions, CurveSampler& sampler)
      : gui_(gui), actions_(actions), sampler_(sampler) {}

  void draw();

 private:
  void draw_none();
  void draw_rule(SamplingRequest& request);
  void draw_density(SamplingRequest& request);
  void draw_corners(SamplingRequest& request);
  void draw_jitter(SamplingRequest& request);
  void draw_facts();
  /// Draws a slider below its name.
  void number(const char* label, double& value, double low, double high, const char* format, bool is_logarithmic,
              const char* explanation);
  void count(SamplingRequest& request, const char* explanation);
  /// Measures length and extent of the curves, once per set of curves.
  void measure();

  const Gui& gui_;
  const ActionBindings& actions_;
  CurveSampler& sampler_;
  std::shared_ptr<const CurveSet> measured_;
  double extent_ = 1.0;
  std::size_t pieces_ = 0;
};

}  // namespace mes
