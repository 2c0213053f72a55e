// SPDX-License-Identifier: GPL-3.0-or-later
// The slider for evolutions, in a strip over the canvas.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/playing/evolution_player.h"
#include "app/playing/step_events.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct EvolutionStrip {
  const Gui& gui;
  const ActionBindings& actions;
  EvolutionPlayer& evolution;
  Editor& editor;
  LayerStack& layers;
  const StepEvents& events;
  Messages& messages;

  /// Draws with the lower left corner at `at`. Returns the height used.
  float draw(ImVec2 at, float width) const;
};

}  // namespace mes
