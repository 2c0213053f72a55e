// SPDX-License-Identifier: GPL-3.0-or-later
// The card beside the drawing during the presentation of a lesson: caption of the step, and buttons to move on.
#pragma once

#include <cstdint>

#include "app/actions/action_bindings.h"
#include "app/playing/lesson_presenter.h"
#include "app/ui/gui.h"
#include "app/ui/widgets.h"
#include "core/base/color.h"

namespace mes {

struct LessonCard {
  const Gui& gui;
  const ActionBindings& actions;
  LessonPresenter& presenter;
  Rgb canvas;  ///< background colour

  enum class Wish : std::uint8_t { none, back, on, restore, end };
  /// The preferred width if this much is available.
  float width(float room) const;
  /// Draws the card; returns the button that was clicked.
  Wish draw(const PanelArea& area) const;

 private:
  void draw_caption(const PanelArea& area) const;
  Wish draw_buttons(const PanelArea& area) const;
};

}  // namespace mes
