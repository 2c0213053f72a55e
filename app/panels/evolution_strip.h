// SPDX-License-Identifier: GPL-3.0-or-later
// The slider of evolutions, in a strip over the canvas.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/model/messages.h"
#include "app/playing/evolution_player.h"
#include "app/playing/step_events.h"
#include "app/ui/gui.h"

namespace mes {

struct EvolutionStrip {
  const Gui& gui;
  const ActionBindings& actions;
  EvolutionPlayer& evolution;
  Editor& editor;
  LayerStack& layers;
  const StepEvents& events;
  Messages& messages;

  /// Its lower left corner stands at `at`. Gives the height it takes.
  float draw(ImVec2 at, float width) const;
};

}  // namespace mes
