// SPDX-License-Identifier: GPL-3.0-or-later
// The lower right panel, with a page at a time: statistics, parameters, log.
#pragma once

#include "app/panels/panel_context.h"
#include "app/panels/parameters_panel.h"

namespace mes {

class DetailsPanel {
 public:
  void draw(const PanelContext& context, const PanelArea& area);

 private:
  ParametersPanel parameters_;
};

}  // namespace mes
