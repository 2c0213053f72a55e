// SPDX-License-Identifier: GPL-3.0-or-later
// File, Edit, View, Shapes, Tools, Help: every action of the table, and functions without a key.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/playing/evolution_player.h"
#include "app/settings/settings.h"
#include "app/store/lessons.h"
#include "app/store/sample_shapes.h"
#include "app/store/texts/layer_text.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct MenuBar {
  const Gui& gui;
  const ActionBindings& actions;
  Settings& settings;
  Editor& editor;
  LayerStack& layers;
  EvolutionPlayer& evolution;
  std::span<const SampleShape> shapes;
  std::function<void(const std::string&)> open_file;   ///< asks before unsaved work is lost
  std::function<void(const SampleShape&)> open_shape;  ///< the same
  std::span<const ShippedLesson> lessons;
  std::function<void(const ShippedLesson&)> open_lesson;        ///< the same
  std::function<void(const LayerTextFormat&)> export_geometry;  ///< exports the visible layers

  /// Draws across the window; returns its height in screen coordinates. `opens` opens the first menu.
  float draw(bool opens) const;
};

}  // namespace mes
