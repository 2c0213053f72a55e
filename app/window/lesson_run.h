// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson in the window: presented in place of the document, which comes back when it ends.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/panels/lesson_card.h"
#include "app/playing/lesson_desk.h"
#include "app/playing/lesson_presenter.h"
#include "app/window/drawing_board.h"
#include "app/window/workspace.h"

namespace mes {

/// What it guarantees: what LessonPresenter guarantees; view, selection and what was clicked follow. Whatever saves,
/// opens or leaves the document ends it first. Threads: the window's.
class LessonRun {
 public:
  LessonRun(Workspace& work, DrawingBoard& board, Messages& messages);

  /// The Page keys lead to steps while it runs, and otherwise to what they are bound to already.
  void bind(ActionBindings& actions);
  /// Shows the first step of the session's lesson; says why where that is not possible.
  void start(const Session& session);
  void end();
  bool is_running() const { return presenter_.is_running(); }
  /// Where a lesson is made of the document.
  LessonDesk& desk() { return desk_; }
  /// Caption of the present step; empty while none runs.
  std::string caption() const { return is_running() ? presenter_.caption() : std::string(); }
  /// "2 of 8".
  std::string place() const;

  std::optional<double> next_due(double now) const { return presenter_.next_due(now); }
  /// Once a frame; `may_step`: the picture is complete. True when an edit was played.
  bool advance(double now, bool may_step) { return presenter_.advance(now, may_step); }
  /// The room of the drawing has changed because it began or ended.
  void fit_again() { look_at(looked_at_); }
  /// Beside the drawing, at the left of this area; the width that it takes.
  float draw(const Gui& gui, const ActionBindings& actions, const PanelArea& area);

 private:
  /// What was selected or clicked belongs to another step.
  void leave_step();
  void say(const Expected<void>& done);
  void look_at(const Box2& box);

  Workspace& work_;
  DrawingBoard& board_;
  Messages& messages_;
  LessonPresenter presenter_;
  LessonDesk desk_;
  Box2 view_before_;
  Box2 looked_at_;  // last; empty: everything
};

}  // namespace mes
