// SPDX-License-Identifier: GPL-3.0-or-later
// Binds the actions of the table that work on the document, its layers and its computation.
#include <algorithm>

#include "app/window/work/workspace.h"
#include "core/io/text/text_numbers.h"

namespace mes {

void Workspace::bind(ActionBindings& actions, Settings& settings) {
  bind_editing(actions);
  bind_evolution(actions, settings);
  bind_computation(actions);
  bind_bundles(actions);
}

void Workspace::bind_editing(ActionBindings& actions) {
  using Condition = ActionBindings::Condition;
  const Condition has_something{[this] { return !document().is_empty(); }, "there are neither samples nor balls"};
  const Condition has_samples{[this] { return editor_.selection().sample_count() != 0; }, "no sample is selected"};
  const Condition has_two{[this] { return document().sample_count() > 1; }, "there are fewer than two samples"};
  actions.bind(ActionId::undo, {[this] {
                                  editor_.note_layers();
                                  messages_.remark("Undone: " + editor_.undo_name());
                                  editor_.undo();
                                },
                                {[this] { return editor_.can_undo(); }, "there is nothing to undo"}});
  actions.bind(ActionId::redo, {[this] {
                                  editor_.note_layers();
                                  messages_.remark("Redone: " + editor_.redo_name());
                                  editor_.redo();
                                },
                                {[this] { return editor_.can_redo(); }, "nothing was undone last"}});
  actions.bind(ActionId::add_pane, {[this] { panes_.add(next_choice(panes_, computation_.settings())); },
                                    {[this] { return !panes_.is_full(); }, "there is no room for another pane"}});
  actions.bind(ActionId::toggle_free_cameras, {[this] { panes_.set_free_cameras(!panes_.has_free_cameras()); },
                                               {[this] { return !panes_.is_empty(); }, "there is no second pane"},
                                               [this] { return panes_.has_free_cameras(); }});
  actions.bind(ActionId::close_panes,
               {[this] { panes_.close_all(); }, {[this] { return !panes_.is_empty(); }, "there is no second pane"}});
  actions.bind(ActionId::select_all, {[this] { editor_.selection().select_all(document()); }, has_something});
  actions.bind(ActionId::invert_selection, {[this] { editor_.selection().invert(document()); }, has_something});
  const auto bind_along_curve = [&](ActionId id, CurveSelector::Wish wish) {
    actions.bind(id, {[this, wish] { curve_selector_.begin(wish); }, has_samples});
  };
  actions.bind(ActionId::curves_of_samples, {[this] { curve_sampler_.want_curves_of_samples(); }, has_two});
  actions.bind(ActionId::mark_corners, {[this] { report(curve_sampler_.mark_corners()); },
                                        {[this] { return !curve_sampler_.corners().empty(); },
                                         "the samples were taken from no curves with corners"}});
  bind_along_curve(ActionId::select_curve, CurveSelector::Wish::whole);
  bind_along_curve(ActionId::grow_selection, CurveSelector::Wish::grow);
  bind_along_curve(ActionId::shrink_selection, CurveSelector::Wish::shrink);
  for (std::size_t i = 0; i < kContourChanges; ++i)
    actions.bind(
        nth(ActionId::first_contour_change, i),
        {[this, i] { report_remark(contour_commands_.change(static_cast<ContourChange>(i))); }, has_samples});
  actions.bind(ActionId::contours_along_crust, {[this] { contour_commands_.begin_along_crust(); }, has_two});
  const auto bind_resampling = [&](ActionId id, ResampleJob::Wish wish) {
    actions.bind(id, {[this, wish] { resampling_.begin(wish); },
                      {{[this] { return document().sample_count() != 0; }, "there are no samples"},
                       {[this] { return !resampling_.is_under_way(); }, "the sampling is being changed already"}}});
  };
  bind_resampling(ActionId::repair_sampling, ResampleJob::Wish::repair);
  bind_resampling(ActionId::decimate_sampling, ResampleJob::Wish::decimate);
  actions.bind(ActionId::delete_selection,
               {[this] {
                  if (annotations_.current() != nullptr) {
                    report(annotations_.erase());
                    return;
                  }
                  const Selection& selection = editor_.selection();
                  const std::string what = counted(selection.sample_count(), selection.ball_count());
                  const Expected<void> done = editor_.remove_selection();
                  report(done);
                  if (done) messages_.remark("Deleted " + what);
                },
                {[this] { return !editor_.selection().is_empty() || annotations_.current() != nullptr; },
                 "nothing is selected"}});
}

void Workspace::bind_evolution(ActionBindings& actions, Settings& settings) {
  using Direction = EvolutionPlayer::Direction;
  // A step by a key shows the slider, so that the user sees the new state.
  const auto bind = [&](ActionId id, auto act) {
    actions.bind(id, {[this, &settings, act] {
                        settings.show_evolution = true;
                        release_hold();
                        act();
                      },
                      {{[this] { return !document().is_empty(); }, "there are neither samples nor balls"},
                       {[this] { return !editor_.in_gesture(); }, "a gesture is under way"}}});
  };
  bind(ActionId::evolution_first, [this] {
    evolution_.play(Direction::none);
    evolution_.step_to(0);
  });
  bind(ActionId::evolution_back, [this] { evolution_.step_back(); });
  bind(ActionId::evolution_forward, [this] { evolution_.step_forward(); });
  bind(ActionId::evolution_previous, [this] { evolution_.choose_next(-1); });
  bind(ActionId::evolution_next, [this] { evolution_.choose_next(1); });
  bind(ActionId::evolution_play, [this] { evolution_.play(Direction::forward); });
  bind(ActionId::evolution_play_back, [this] { evolution_.play(Direction::backward); });
  actions.bind(ActionId::evolution_stop,
               {[this] { evolution_.cancel(); },
                {[this] { return evolution_.is_waiting() || evolution_.direction() != Direction::none; },
                 "no evolution is running"}});
}

void Workspace::bind_computation(ActionBindings& actions) {
  // A running animation would begin its next computation, and between two pictures there may be no computation to
  // cancel.
  const auto plays = [this] {
    return evolution_.is_waiting() || evolution_.direction() != EvolutionPlayer::Direction::none ||
           computation_.animation().is_running();
  };
  actions.bind(ActionId::cancel_computation,
               {[this, plays] {
                  const bool is_computing = engine_.status().busy || plays();
                  evolution_.cancel();
                  computation_.animation().stop();
                  engine_.cancel();
                  if (!is_computing) insight_.sweep.give_up();
                },
                {[this, plays] { return engine_.status().busy || plays() || insight_.sweep.is_under_way(); },
                 "nothing is being computed"}});
  actions.bind(ActionId::resume_computation,
               {[this] { engine_.resume(); },
                {[this] { return engine_.status().cancelled; }, "no computation was cancelled"}});
  actions.bind(ActionId::hold_update, {[this] {
                                         is_held_by_action_ = !is_held_by_action_;
                                         if (!is_held_by_action_) release_hold();
                                       },
                                       {},
                                       [this] { return is_held_by_action_; }});
  for (const PrecisionDescriptor& descriptor : kPrecisionDescriptors) {
    const Precision precision = descriptor.precision;
    const auto id = static_cast<ActionId>(static_cast<std::size_t>(ActionId::precision_naive) +
                                          static_cast<std::size_t>(precision));
    actions.bind(id, {[this, precision] {
                        ComputationSettings settings = computation_.settings();
                        settings.precision = precision;
                        computation_.set(settings);
                      },
                      {},
                      [this, precision] { return computation_.settings().precision == precision; }});
  }
  const auto bind_switch = [&](ActionId id, const Parameter& parameter) {
    const auto is_on = [this, parameter] { return computation_.settings().is_on(parameter); };
    actions.bind(id, {[this, parameter, is_on] { computation_.set(parameter, is_on() ? 0.0 : 1.0); }, {}, is_on});
  };
  bind_switch(ActionId::toggle_union_shortcut, Parameter::union_shortcut);
  bind_switch(ActionId::toggle_pole_propagation, Parameter::pole_propagation);
}

void Workspace::bind_bundles(ActionBindings& actions) {
  for (std::size_t index = 0; index < kNumberedBundles; ++index) {
    actions.bind(nth(ActionId::first_bundle, index),
                 {[this, index] { choose_bundle(index); },
                  {[this, index] { return index < bundles_.bundles().size(); }, "there is no such bundle"},
                  [this, index] { return bundles_.current() == index; }});
  }
  const auto bind_step = [&](ActionId id, bool is_forward) {
    actions.bind(id, {[this, is_forward] {
                        const std::size_t last = bundles_.bundles().size() - 1;
                        const auto now = bundles_.current();
                        const std::size_t next = !now         ? 0
                                                 : is_forward ? std::min(*now + 1, last)
                                                              : *now - std::min<std::size_t>(*now, 1);
                        choose_bundle(next);
                      },
                      {[this] { return !bundles_.bundles().empty(); }, "there are no bundles"}});
  };
  bind_step(ActionId::next_bundle, true);
  bind_step(ActionId::previous_bundle, false);
  for (const FamilyKind family : kBallFamilies)
    actions.bind(
        nth(ActionId::balls_inner, static_cast<std::size_t>(family)),
        {[this, family] { choose_family(family); }, {}, [this, family] { return this->family() == family; }});
  actions.bind(ActionId::undo_bundles, {[this] { report(bundles_.undo()); },
                                        {[this] { return bundles_.can_undo(); }, "no bundle was changed"}});
}

}  // namespace mes
