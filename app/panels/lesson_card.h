// SPDX-License-Identifier: GPL-3.0-or-later
// Beside the drawing while a lesson is presented: the caption of the step, and the buttons that lead on.
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
  Rgb canvas;  ///< what it is drawn on

  enum class Wish : std::uint8_t { none, back, on, restore, end };
  /// How wide it would like to be in a room of this width.
  float width(float room) const;
  /// What was clicked.
  Wish draw(const PanelArea& area) const;

 private:
  void draw_caption(const PanelArea& area) const;
  Wish draw_buttons(const PanelArea& area) const;
};

}  // namespace mes
