// SPDX-License-Identifier: GPL-3.0-or-later
// Every number that steers what is computed, with its meaning, its range and a way to let it run.
#pragma once

#include <string>

#include "app/model/computation_control.h"
#include "app/ui/gui.h"

namespace mes {

class ParametersPanel {
 public:
  ParametersPanel(const Gui& gui, ComputationControl& computation) : gui_(gui), computation_(computation) {}

  void draw();
  void search(const std::string& text) { search_ = text; }

 private:
  void draw_parameter(Parameter parameter);
  void draw_animation(Parameter parameter);

  const Gui& gui_;
  ComputationControl& computation_;
  std::string search_;
};

}  // namespace mes
