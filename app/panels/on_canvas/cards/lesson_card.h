// SPDX-License-Identifier: GPL-3.0-or-later
// The card below the drawing during the presentation of a lesson: caption of the step, and buttons to move on; and the
// title before the first step.
#pragma once

#include <cstdint>
#include <utility>

#include "app/actions/action_bindings.h"
#include "app/playing/lesson_presenter.h"
#include "app/ui/screen/gui.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/color.h"

namespace mes {

struct LessonCard {
  const Gui& gui;
  const ActionBindings& actions;
  LessonPresenter& presenter;
  Rgb canvas;  ///< background colour

  enum class Wish : std::uint8_t { none, back, on, restore, end };
  /// Draws the card at the bottom of the area, as high as the caption needs. Returns the clicked button and the height.
  std::pair<Wish, float> draw(const PanelArea& area) const;
  /// Covers the area with the title of the lesson; returns `on` when it is clicked.
  Wish draw_title(const PanelArea& area) const;

 private:
  float draw_caption(const PanelArea& area) const;
  Wish draw_buttons(const PanelArea& area) const;
};

}  // namespace mes
