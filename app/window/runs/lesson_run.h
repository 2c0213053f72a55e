// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson in the window: presented instead of the document, which returns when the lesson ends.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/panels/on_canvas/cards/lesson_card.h"
#include "app/playing/lesson_editor.h"
#include "app/playing/lesson_presenter.h"
#include "app/window/work/drawing_board.h"
#include "app/window/work/workspace.h"

namespace mes {

/// Guarantees: those of LessonPresenter; view, selection and clicked elements follow the lesson. Saving, opening or
/// leaving the document ends it first. Threads: the window's.
class LessonRun {
 public:
  LessonRun(Workspace& work, DrawingBoard& board, Messages& messages);

  /// The Page keys step through the lesson while it runs, and keep their earlier bindings otherwise.
  void bind(ActionBindings& actions);
  /// Shows the first step of the session's lesson, or reports why that is not possible.
  void start(const Session& session);
  void end();
  bool is_running() const { return presenter_.is_running(); }
  const LessonPresenter& presenter() const { return presenter_; }
  /// Shows another step of the running lesson.
  void go_to(std::size_t step);
  /// Makes a lesson from the document.
  LessonEditor& lesson_editor() { return lesson_editor_; }
  /// Caption of the present step; empty while none runs.
  std::string caption() const { return is_running() ? presenter_.caption() : std::string(); }
  /// Number of the present step: "2 of 8".
  std::string place() const;

  std::optional<double> next_due(double now) const { return presenter_.next_due(now); }
  /// Call it once per frame; `may_step`: the picture is complete. Returns true when an edit was played.
  bool advance(double now, bool may_step) { return presenter_.advance(now, may_step); }
  /// Fits again because the area of the drawing changed when the lesson began or ended.
  void fit_again() { look_at(looked_at_); }
  /// Draws the lesson at the bottom of this area, below the drawing, or its title over the area. Returns the height
  /// that it takes of the drawing.
  float draw(const Gui& gui, const ActionBindings& actions, const PanelArea& area);

 private:
  void leave_title();
  bool has_title() const { return !presenter_.lesson().title.empty(); }
  /// Discards the selection and the clicked elements, which belong to another step.
  void leave_step();
  void say(const Expected<void>& done);
  void look_at(const Box2& box);

  Workspace& work_;
  DrawingBoard& board_;
  Messages& messages_;
  LessonPresenter presenter_;
  LessonEditor lesson_editor_;
  bool shows_title_ = false;  // before the first step
  Box2 view_before_;
  Box2 looked_at_;  // the last requested view; empty: everything
};

}  // namespace mes
