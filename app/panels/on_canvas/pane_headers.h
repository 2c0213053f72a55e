// SPDX-License-Identifier: GPL-3.0-or-later
// The header in the lower left corner of each pane: its contents, with a menu to change them; and the frames around
// the panes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/panes/pane_list.h"
#include "app/panes/pane_places.h"
#include "app/playing/evolution_player.h"
#include "app/store/looks/window_bundles.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct PaneHeaders {
  const Gui& gui;
  const ActionBindings& actions;
  PaneList& panes;
  const WindowBundles& bundles;
  std::span<const Parameter> parameters;  ///< all existing parameters
  const ComputationSettings& settings;
  const std::vector<std::string>& words;  ///< description of each pane, the main one first
  const EvolutionPlayer& evolution;
  double pixel_ratio = 1.0;  ///< framebuffer pixels per unit of screen coordinates

  /// Draws nothing if there is only the main pane.
  void draw(const PanePlaces& places) const;

 private:
  void draw_header(std::size_t pane, const PanePlace& place) const;
  void draw_menu(std::size_t pane) const;
  void draw_value(std::size_t pane) const;
  void draw_step(std::size_t pane) const;
};

}  // namespace mes
