// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of the lesson: set, ordered and captioned here, and listed while it is presented.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/playing/lesson_editor.h"
#include "app/playing/lesson_presenter.h"
#include "app/ui/screen/gui.h"
#include "app/ui/widgets/wrapped_field.h"

namespace mes {

/// The current step stays in view: the chosen one, or the one that is presented. Threads: the window's.
class LessonPanel {
 public:
  /// `go_to` shows a step of the lesson, which is presented from then on.
  LessonPanel(const Gui& gui, const ActionBindings& actions, LessonEditor& lesson_editor,
              const LessonPresenter& presenter, std::function<void(std::size_t)> go_to)
      : gui_(gui),
        actions_(actions),
        lesson_editor_(lesson_editor),
        presenter_(presenter),
        go_to_(std::move(go_to)) {}

  void draw();
  /// Chooses a step, or shows it while the lesson is presented.
  void step(std::ptrdiff_t rows);

 private:
  void draw_head();
  /// Draws the steps of a lesson, and returns the one that is clicked.
  std::optional<std::size_t> draw_steps(const Lesson& lesson, std::optional<std::size_t> current, float height);
  void draw_chosen(float height);
  void draw_buttons();

  const Gui& gui_;
  const ActionBindings& actions_;
  LessonEditor& lesson_editor_;
  const LessonPresenter& presenter_;
  std::function<void(std::size_t)> go_to_;
  // The text being typed, and the step that it belongs to.
  std::string caption_;
  WrappedField caption_field_;
  std::string title_;
  std::optional<std::size_t> caption_of_;
  Lesson shown_;
  // When one of these changes, the list scrolls to the current step.
  struct Listed {
    std::optional<std::size_t> current;
    std::size_t steps = 0;
    float height = 0.0F;
    friend bool operator==(const Listed&, const Listed&) = default;
  };
  Listed listed_;
};

}  // namespace mes
