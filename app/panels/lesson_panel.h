// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of the lesson: marked, put in order, with their captions.
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
  // What is being typed, and the step that it is about.
  std::string caption_;
  std::string title_;
  std::optional<std::size_t> caption_of_;
  Lesson shown_;
};

}  // namespace mes
