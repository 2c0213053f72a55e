// SPDX-License-Identifier: GPL-3.0-or-later
// Every number that steers what is computed, with its meaning, its range and a way to let it run.
#pragma once

#include <string>

#include "app/model/computation_control.h"
#include "app/picture/picture.h"
#include "app/ui/gui.h"

namespace mes {

class ParametersPanel {
 public:
  ParametersPanel(const Gui& gui, ComputationControl& computation, const Picture& picture)
      : gui_(gui), computation_(computation), picture_(picture) {}

  void draw();
  void search(const std::string& text) { search_ = text; }

 private:
  void draw_parameter(Parameter parameter);
  void draw_value(const ParameterDescriptor& descriptor, double& value) const;
  void draw_animation(Parameter parameter);
  /// A length that no radius of what is drawn exceeds by much.
  double longest() const;

  const Gui& gui_;
  ComputationControl& computation_;
  const Picture& picture_;
  std::string search_;
};

}  // namespace mes
