// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/runs/lesson_run.h"

#include <fmt/core.h>
#include <memory>
#include <utility>

namespace mes {

LessonRun::LessonRun(Workspace& work, DrawingBoard& board, Messages& messages)
    : work_(work),
      board_(board),
      messages_(messages),
      presenter_({work.live_registry(), work.editor(), work.layers(),
                  [&work] { return work.computation().settings(); },
                  [&work](const ComputationSettings& settings) { work.computation().set(settings); },
                  [this](const Box2& box) { look_at(box); }}),
      lesson_editor_(work.editor(), [&work, &board] {
        return LessonEditor::Look{work.layers().configuration(), work.computation().settings(),
                                  board.view().free_box()};
      }) {}

void LessonRun::bind(ActionBindings& actions) {
  const auto bind_step = [&](ActionId id, Expected<void> (LessonPresenter::*step)(), bool is_arrow) {
    ActionBindings::Binding binding = actions.binding(id);
    const ActionBindings::Binding otherwise = binding;
    binding.run = [this, step, is_arrow, otherwise] {
      // An arrow moves what is selected, in a lesson too.
      if (!is_running() || (is_arrow && otherwise.enabled.holds())) return otherwise.run();
      if (shows_title_) return leave_title();
      shows_title_ = step == &LessonPresenter::go_back && presenter_.step() == 0 && has_title();
      leave_step();
      say((presenter_.*step)());
    };
    binding.enabled = otherwise.enabled.unless([this] { return is_running(); });
    actions.bind(id, std::move(binding));
  };
  bind_step(ActionId::next_bundle, &LessonPresenter::go_on, false);
  bind_step(ActionId::previous_bundle, &LessonPresenter::go_back, false);
  bind_step(nth(ActionId::first_nudge, 0), &LessonPresenter::go_back, true);
  bind_step(nth(ActionId::first_nudge, 1), &LessonPresenter::go_on, true);
  // Steps of undo do not affect the lesson, which takes its own changes back.
  ActionBindings::Binding undo = actions.binding(ActionId::undo);
  undo.enabled =
      undo.enabled.after({[this, holds = undo.enabled] { return holds.holds() || !lesson_editor_.can_take_back(); },
                          "the arrow of the panel Lesson takes back its last change"});
  actions.bind(ActionId::undo, std::move(undo));
  actions.bind(ActionId::mark_step,
               {[this] { lesson_editor_.mark(); },
                {{[this] { return !is_running(); }, "a lesson is being presented"},
                 {[this] { return !work_.editor().in_gesture(); }, "a gesture is under way"},
                 {[this] { return !lesson_editor_.is_full(); }, "the lesson has as many steps as there may be"}}});
}

void LessonRun::start(const Session& session) {
  end();
  work_.release_hold();
  work_.computation().give_back();
  work_.evolution().cancel();
  // A document that has just been opened has no view yet.
  view_before_ = board_.fitter().is_wanted() ? Box2{} : board_.view().free_box();
  leave_step();
  messages_.clear();
  say(presenter_.start(std::make_shared<const Session>(session), 0));
  shows_title_ = is_running() && has_title();
}

void LessonRun::end() {
  if (!is_running()) return;
  work_.computation().give_back();
  work_.evolution().cancel();
  leave_step();
  presenter_.end();
  work_.take_family_of_layers();
  look_at(view_before_);
}

void LessonRun::go_to(std::size_t step) {
  if (!is_running()) return;
  leave_step();
  if (shows_title_) leave_title();
  say(presenter_.go_to(step));
}

std::string LessonRun::place() const {
  return is_running() ? fmt::format("{} of {}", presenter_.step() + 1, presenter_.step_count()) : std::string();
}

void LessonRun::leave_step() {
  board_.canvas().cancel_gesture();
  board_.provenance().clear();
  work_.editor().selection().clear();
  work_.annotations().close();
}

// The caption takes room of the drawing.
void LessonRun::leave_title() {
  shows_title_ = false;
  fit_again();
}

void LessonRun::say(const Expected<void>& done) {
  work_.take_family_of_layers();
  if (!done) messages_.problem(done.error().message());
}

void LessonRun::look_at(const Box2& box) {
  looked_at_ = box;
  if (!box.is_empty()) board_.fitter().set_target(box);
  board_.fitter().want(ViewFitter::How::glide);
}

float LessonRun::draw(const Gui& gui, const ActionBindings& actions, const PanelArea& area) {
  if (!is_running()) return 0.0F;
  const LessonCard card{gui, actions, presenter_, board_.picture().canvas()};
  if (shows_title_) {
    if (card.draw_title(area) == LessonCard::Wish::on) leave_title();
    return 0.0F;
  }
  const auto [wish, height] = card.draw(area);
  switch (wish) {
    case LessonCard::Wish::none: break;
    case LessonCard::Wish::back: actions.run(ActionId::previous_bundle); break;
    case LessonCard::Wish::on: actions.run(ActionId::next_bundle); break;
    case LessonCard::Wish::restore:
      leave_step();
      say(presenter_.restore());
      break;
    case LessonCard::Wish::end: end(); break;
  }
  return height;
}

}  // namespace mes
