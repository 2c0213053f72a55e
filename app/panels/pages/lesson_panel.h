// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of the lesson: set, ordered and captioned here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/playing/lesson_desk.h"
#include "app/ui/gui.h"

namespace mes {

class LessonPanel {
 public:
  LessonPanel(const Gui& gui, const ActionBindings& actions, LessonDesk& desk)
      : gui_(gui), actions_(actions), desk_(desk) {}

  void draw();

 private:
  void draw_head();
  void draw_steps(float height);
  void draw_chosen(float height);
  void draw_buttons();

  const Gui& gui_;
  const ActionBindings& actions_;
  LessonDesk& desk_;
  // The text being typed, and the step that it belongs to.
  std::string caption_;
  std::string title_;
  std::optional<std::size_t> caption_of_;
  Lesson shown_;
};

}  // namespace mes
