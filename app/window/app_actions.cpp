// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of the table do here.
#include "app/window/app.h"

namespace mes {
namespace {

constexpr double kFitMargin = 40.0;  // logical pixels
constexpr double kKeyZoom = 1.4;

}  // namespace

void App::bind_actions() {
  bind_file_actions();
  bind_edit_actions();
  bind_view_actions();
  bind_bundle_actions();
  bind_record_actions();
  bind_evolution_actions();
}

void App::bind_file_actions() {
  actions_.bind(ActionId::new_document, {[this] {
                  with_saved_work([this] {
                    end_demo(true);
                    files_.start_empty();
                    leave_document();
                    messages_.clear_problem();
                  });
                }});
  actions_.bind(ActionId::open, {[this] { with_saved_work([this] { browser_.ask_open(browse_folder()); }); }});
  actions_.bind(ActionId::trace_picture, {[this] { ask_picture(); }});
  actions_.bind(ActionId::save, {[this] { save(); }});
  actions_.bind(ActionId::save_as, {[this] { ask_save_as(); }});
  actions_.bind(ActionId::quit, {[this] { with_saved_work([this] { is_closing_ = true; }); }});
  actions_.bind(ActionId::demo, {[this] { with_saved_work([this] { start_demo(); }); }});
  actions_.bind(ActionId::help, {[this] { show_help_ = !show_help_; }});
}

void App::bind_edit_actions() {
  const auto has_something = [this] { return !editor_.document().is_empty(); };
  const auto has_selection = [this] { return !editor_.selection().is_empty(); };
  const auto by_hand = [this](auto change) {
    return [this, change] {
      change();
      frames_wanted_ = 1;
    };
  };
  actions_.bind(ActionId::undo, {by_hand([this] {
                                   editor_.note_layers();
                                   messages_.remark("Undone: " + editor_.undo_name());
                                   editor_.undo();
                                 }),
                                 [this] { return editor_.can_undo(); }});
  actions_.bind(ActionId::redo, {by_hand([this] {
                                   editor_.note_layers();
                                   messages_.remark("Redone: " + editor_.redo_name());
                                   editor_.redo();
                                 }),
                                 [this] { return editor_.can_redo(); }});
  actions_.bind(ActionId::select_all,
                {by_hand([this] { editor_.selection().select_all(editor_.document()); }), has_something});
  actions_.bind(ActionId::invert_selection,
                {by_hand([this] { editor_.selection().invert(editor_.document()); }), has_something});
  actions_.bind(ActionId::deselect, {by_hand([this] {
                  if (demo_) {
                    end_demo(true);
                    return;
                  }
                  if (!canvas_.cancel_gesture() && !provenance_.clear()) editor_.selection().clear();
                })});
  actions_.bind(ActionId::delete_selection, {by_hand([this] {
                                               const std::string what = counted(editor_.selection().sample_count(),
                                                                                editor_.selection().ball_count());
                                               if (auto done = editor_.remove_selection(); !done)
                                                 report(done.error());
                                               else
                                                 messages_.remark("Deleted " + what);
                                             }),
                                             has_selection});
  const auto bind_nudge = [&](ActionId id, double x, double y) {
    actions_.bind(id, {[this, x, y] { nudge(x, y); }, has_selection});
  };
  bind_nudge(ActionId::nudge_left, -1, 0);
  bind_nudge(ActionId::nudge_right, 1, 0);
  bind_nudge(ActionId::nudge_up, 0, 1);
  bind_nudge(ActionId::nudge_down, 0, -1);
  bind_nudge(ActionId::nudge_left_far, -10, 0);
  bind_nudge(ActionId::nudge_right_far, 10, 0);
  bind_nudge(ActionId::nudge_up_far, 0, 10);
  bind_nudge(ActionId::nudge_down_far, 0, -10);
  const auto bind_tool = [&](ActionId id, ToolId tool) {
    actions_.bind(
        id, {[this, tool] { canvas_.choose_tool(tool); }, {}, [this, tool] { return canvas_.tool_id() == tool; }});
  };
  bind_tool(ActionId::tool_select, ToolId::select);
  bind_tool(ActionId::tool_insert, ToolId::insert);
  bind_tool(ActionId::tool_spray, ToolId::spray);
  bind_tool(ActionId::tool_ball, ToolId::ball);
}

void App::bind_view_actions() {
  actions_.bind(ActionId::zoom_in, {[this] { canvas_.view().zoom_at(canvas_.zoom_center(), kKeyZoom); }});
  actions_.bind(ActionId::zoom_out, {[this] { canvas_.view().zoom_at(canvas_.zoom_center(), 1.0 / kKeyZoom); }});
  actions_.bind(ActionId::fit, {[this] { fit_wanted_ = Fit::glide; }});
  actions_.bind(ActionId::fit_selection, {[this] {
                                            Box2 box;
                                            for (const Slot slot : editor_.selection().slots())
                                              box.add(editor_.document().position(slot));
                                            for (const Slot slot : editor_.selection().ball_slots())
                                              box.add(bounding_box_of(editor_.document().disk(slot)));
                                            canvas_.view().fit(box, kFitMargin * canvas_.content_scale());
                                          },
                                          [this] { return !editor_.selection().is_empty(); }});
  actions_.bind(ActionId::previous_view,
                {[this] { canvas_.view().back(); }, [this] { return canvas_.view().can_go_back(); }});
  const auto bind_toggle = [&](ActionId id, bool& value) {
    actions_.bind(id, {[&value] { value = !value; }, {}, [&value] { return value; }});
  };
  bind_toggle(ActionId::toggle_evolution, settings_.show_evolution);
  bind_toggle(ActionId::toggle_panels, show_panels_);
  bind_toggle(ActionId::toggle_layers, settings_.show_layers);
  const auto bind_page = [&](ActionId id, DetailsPage page) {
    actions_.bind(id, {[this, page] { settings_.details = settings_.details == page ? DetailsPage::none : page; },
                       {},
                       [this, page] { return settings_.details == page; }});
  };
  bind_page(ActionId::toggle_statistics, DetailsPage::statistics);
  bind_page(ActionId::toggle_parameters, DetailsPage::parameters);
  bind_page(ActionId::toggle_log, DetailsPage::log);
  bind_toggle(ActionId::toggle_legend, settings_.show_legend);
  bind_toggle(ActionId::projector_mode, settings_.for_projector);
  actions_.bind(ActionId::toggle_theme,
                {[this] { settings_.theme = settings_.theme == Theme::dark ? Theme::light : Theme::dark; },
                 {},
                 [this] { return settings_.theme == Theme::dark; }});
  actions_.bind(ActionId::cancel_computation,
                {[this] { engine_.cancel(); }, [this] { return engine_.status().busy; }});
  actions_.bind(ActionId::resume_computation,
                {[this] { engine_.resume(); }, [this] { return engine_.status().cancelled; }});
  for (const PrecisionDescriptor& descriptor : kPrecisionDescriptors) {
    const Precision precision = descriptor.precision;
    const auto id = static_cast<ActionId>(static_cast<std::size_t>(ActionId::precision_naive) +
                                          static_cast<std::size_t>(precision));
    actions_.bind(id, {[this, precision] { choose_precision(precision); },
                       {},
                       [this, precision] { return computation_.settings().precision == precision; }});
  }
  const auto bind_switch = [&](ActionId id, Parameter parameter) {
    actions_.bind(
        id, {[this, parameter] { computation_.set(parameter, computation_.settings().is_on(parameter) ? 0.0 : 1.0); },
             {},
             [this, parameter] { return computation_.settings().is_on(parameter); }});
  };
  bind_switch(ActionId::toggle_union_shortcut, Parameter::union_shortcut);
  bind_switch(ActionId::toggle_pole_propagation, Parameter::pole_propagation);
}

void App::bind_evolution_actions() {
  using Direction = EvolutionPlayer::Direction;
  // Whoever steps by a key wants to see where the slider is.
  const auto bind = [this](ActionId id, auto act) {
    actions_.bind(id, {[this, act] {
                         settings_.show_evolution = true;
                         act();
                       },
                       [this] { return !editor_.in_gesture() && editor_.document().sample_count() != 0; }});
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
  actions_.bind(ActionId::evolution_stop,
                {[this] { evolution_.cancel(); },
                 [this] { return evolution_.is_waiting() || evolution_.direction() != Direction::none; }});
}

void App::choose_precision(Precision precision) {
  ComputationSettings settings = computation_.settings();
  settings.precision = precision;
  computation_.set(settings);
}

void App::advance_animation() {
  if (engine_.status().busy || holds_input()) return;
  if (computation_.advance(ImGui::GetTime())) on_anything();
}

void App::nudge(double x_px, double y_px) {
  const double step = canvas_.view().camera().units_per_pixel();
  if (auto done = editor_.nudge_selection({x_px * step, y_px * step}); !done) report(done.error());
}

void App::report(const Error& error) {
  messages_.problem(error.message());
}

Box2 App::fit_box() const {
  return editor_.document().bounding_box();
}

bool App::wants_fit_again(const Room& room) const {
  if (!fitted_ || room == fitted_->room || !canvas_.view().is_as_fitted() || canvas_.has_pointer()) return false;
  constexpr double kAbout = 0.2;
  const double size = std::max(fitted_->box.width(), fitted_->box.height());
  const auto is_about = [size](Vec2 a, Vec2 b) { return distance(a, b) <= kAbout * size; };
  const Box2 box = fit_box();
  return is_about(box.low, fitted_->box.low) && is_about(box.high, fitted_->box.high);
}

void App::fit_if_wanted() {
  // Panels know their size when they have been drawn once.
  if (ImGui::GetFrameCount() < 3) return;
  ViewMotion& view = canvas_.view();
  const Room room{view.camera().width(), view.camera().height(), view.insets()};
  if (fit_wanted_ == Fit::none && wants_fit_again(room))
    fit_wanted_ =
        room.width == fitted_->room.width && room.height == fitted_->room.height ? Fit::glide : Fit::at_once;
  // Once is enough: the drawing may be large.
  if (fitted_ && room != fitted_->room && !canvas_.has_pointer()) fitted_.reset();
  if (fit_wanted_ == Fit::none) return;
  const Box2 box = fit_to_.value_or(fit_box());
  if (!box.is_empty())
    view.set_insets(clear_of_corner(room.panels, {static_cast<double>(room.width), static_cast<double>(room.height)},
                                    legend_size_, {box.width(), box.height()}));
  view.fit(box, fit_to_ ? 0.0 : kFitMargin * canvas_.content_scale(), fit_wanted_ == Fit::at_once);
  fitted_ = fit_to_ || box.is_empty() ? std::nullopt : std::optional(Fitted{box, room});
  fit_to_.reset();
  fit_wanted_ = Fit::none;
}

}  // namespace mes
