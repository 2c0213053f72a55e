// SPDX-License-Identifier: GPL-3.0-or-later
// Every number that steers what is computed, with its meaning, its range and a way to let it run.
#pragma once

#include <optional>
#include <string>

#include "app/panels/panel_context.h"

namespace mes {

class ParametersPanel {
 public:
  void draw(const PanelContext& context);

 private:
  void draw_parameter(const PanelContext& context, Parameter parameter);
  void draw_animation(const PanelContext& context, Parameter parameter);

  std::string search_;
};

}  // namespace mes
