// SPDX-License-Identifier: GPL-3.0-or-later
// All parameters of the computation, with their meaning, range and animation.
#pragma once

#include <string>

#include "app/actions/messages.h"
#include "app/editing/editor.h"
#include "app/insight/computation_control.h"
#include "app/insight/critical_values.h"
#include "app/insight/latest_persistence.h"
#include "app/insight/parameter_sweep.h"
#include "app/insight/scale_events.h"
#include "app/layers/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/screen/gui.h"
#include "app/ui/widgets/mark_band.h"

namespace mes {

class ParametersPanel {
 public:
  ParametersPanel(const Gui& gui, ComputationControl& computation, const Picture& picture, const Editor& editor,
                  const LayerStack& layers, ScaleEvents& events, CriticalValues& critical,
                  LatestPersistence& persistence, SweepJob& sweep, Messages& messages)
      : gui_(gui),
        computation_(computation),
        picture_(picture),
        editor_(editor),
        layers_(layers),
        scale_events_(events),
        critical_values_(critical),
        persistence_(persistence),
        sweep_(sweep),
        messages_(messages) {}

  void draw();
  /// Lists the parameters with this name; the number of the first can be typed at once.
  void search(const std::string& text) {
    search_ = text;
    gives_keyboard_ = true;
  }

 private:
  void draw_parameter(const Parameter& parameter);
  /// Clamps a typed number to the range, and reports if it was outside.
  void take_within(const Parameter& descriptor, double& value) const;
  void draw_value(const Parameter& descriptor, double& value);
  void draw_animation(const Parameter& parameter);
  /// Begins or gives up the table of the visible layers for the values of the animation.
  void draw_sweep(const Parameter& parameter);
  /// The band below a slider.
  MarkBand band(const char* id) const;
  /// Marks the factors where the grown union changes its topology, while the scale axis is shown; a click sets the
  /// factor.
  void draw_scale_events(double& factor);
  /// Marks critical values of lambda while one of its layers is shown; a click sets the limit.
  void draw_critical_values(double& limit);
  /// Marks births and deaths while a layer of the alpha complex is shown; a click sets the radius.
  void draw_alpha_events(double& radius);
  /// A length that no radius in the drawing exceeds by much.
  double longest() const;

  const Gui& gui_;
  ComputationControl& computation_;
  const Picture& picture_;
  const Editor& editor_;
  const LayerStack& layers_;
  ScaleEvents& scale_events_;
  CriticalValues& critical_values_;
  LatestPersistence& persistence_;
  SweepJob& sweep_;
  Messages& messages_;
  std::string search_;
  bool gives_keyboard_ = false;
};

}  // namespace mes
