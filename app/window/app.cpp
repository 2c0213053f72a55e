// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/app.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "app/export/lessons/carried.h"
#include "app/ui/screen/reach.h"
#include "app/window/selection_actions.h"
#include "app/window/work/memory_problem.h"
#include "core/engine/sampling_verdict.h"

namespace mes {
namespace {

constexpr double kLongestStep = 0.05;  // seconds; limits the step of a motion after the computer slept

// Shows the problem with the settings before any other message.
Messages begun_with(const std::string& problem) {
  Messages out;
  if (!problem.empty()) out.problem(problem);
  return out;
}

}  // namespace

App::App(LiveRegistry registry, std::unique_ptr<GlfwWindow> window, const std::filesystem::path& assets,
         LoadedSettings loaded)
    : wake_(GlfwWindow::wake),
      settings_(default_settings_path(), std::move(loaded.settings)),
      messages_(begun_with(loaded.message)),
      screen_(std::move(window), assets),
      work_(std::move(registry), assets, messages_, wake_),
      board_(work_, settings_.settings(), messages_, screen_, assets, wake_),
      demo_(work_, board_.fitter(), messages_),
      lesson_(work_, board_, messages_),
      recording_({screen_, work_, board_, demo_, lesson_, settings_.settings(), messages_}, assets, wake_),
      documents_({work_, board_, demo_, lesson_, dialogs_, messages_, settings_.settings(), screen_}, assets, wake_),
      experiments_({work_, dialogs_, messages_, settings_.settings(), [this] { documents_.keep_on_disk(); }}, assets,
                   wake_),
      link_({work_, messages_, [this] { keys_.actions().run(ActionId::quit); }}, wake_),
      keys_(settings_.settings(), messages_),
      panels_({screen_, work_, board_, demo_, lesson_, recording_, documents_, experiments_, keys_.actions(),
               dialogs_.manual, settings_.settings(), messages_}),
      input_({screen_, board_.canvas(), work_.editor().selection(), work_.annotations(), dialogs_, documents_,
              experiments_, recording_, keys_.actions(), messages_, panels_.presenter(), panels_.mark_drag(),
              [this] { board_.open_menu(); }, [this](std::ptrdiff_t rows) { return panels_.step_in_list(rows); },
              [this] { follow_hold(); }}) {
  bind_actions();
  recording_.recorder().set_take_source([this] { return session_for_lesson(documents_.session_now()); });
  dialogs_.browser.use_formats(work_.live_registry());
  dialogs_.browser.use_desktop(screen_.window->desktop_handle(), GlfwWindow::wake,
                               [this] { screen_.clock.settle(); });
}

App::App(LiveRegistry registry, std::unique_ptr<GlfwWindow> window, const WindowOptions& options,
         LoadedSettings loaded)
    : App(std::move(registry), std::move(window), find_assets(options.executable), std::move(loaded)) {
  dialogs_.manual.set_source([write = options.manual, assets = find_assets(options.executable)](
                                 const Registry& present) { return write(present, assets); },
                             work_.live_registry());
  if (options.link >= 0) {
    documents_.leave_left_work();
    link_.open(options.link);
    board_.fitter().want(ViewFitter::How::at_once);
  } else {
    documents_.open_first(options.files, options.presents);
  }
  for (const std::string& name : options.experiments) experiments_.add(name);
}

void App::bind_actions() {
  ActionBindings& actions = keys_.actions();
  work_.bind(actions, settings_.settings());
  bind_selection(actions, {work_.editor(), work_.selection_commands(), messages_, settings_.settings(),
                           [] {
                             const char* const text = ImGui::GetClipboardText();
                             return std::string(text == nullptr ? "" : text);
                           },
                           [](const std::string& text) { ImGui::SetClipboardText(text.c_str()); },
                           [this] { return board_.canvas().pointer().units_per_px; },
                           [this] { return board_.view().free_box(); },
                           [this](std::string text) { documents_.open_text(std::move(text)); }});
  board_.bind(actions);
  lesson_.bind(actions);
  recording_.bind(actions);
  documents_.bind(actions);
  actions.bind(ActionId::add_experiment, {[this] { experiments_.ask_file(); }});
  panels_.bind(actions);
  keys_.bind();
  dialogs_.help.set_keys(actions.keymap(), KeyBindings::file().string());
  dialogs_.palette.set_source([this] { return panels_.palette_entries(); });
  actions.bind(ActionId::command_palette, {[this] { dialogs_.palette.toggle(); }});
  actions.bind(ActionId::help, {[this] { dialogs_.help.toggle(); }});
  dialogs_.manual.set_keys(actions.keymap());
  actions.bind(ActionId::manual, {[this] { dialogs_.manual.toggle(); }});
  actions.bind(ActionId::deselect, {[this] { deselect(); }});
  actions.when_out_of_memory([this] { refuse_for_memory(); });
}

bool App::clear_selection() {
  if (work_.editor().selection().is_empty()) return false;
  work_.editor().selection().clear();
  return true;
}

bool App::cancel_lesson_export() {
  LessonExport& lesson = documents_.figures().lesson();
  lesson.cancel();
  return lesson.is_under_way();
}

bool App::end_lesson() {
  const bool was_running = lesson_.is_running();
  lesson_.end();
  return was_running;
}

// Each press of Esc ends one thing.
void App::deselect() {
  if (demo_.is_running())
    demo_.finish();
  else if (!board_.canvas().cancel_gesture() && !panels_.close_large() && !cancel_lesson_export() &&
           !work_.annotations().close() && !panels_.close_messages() && !board_.canvas().clear_tool() &&
           !board_.provenance().clear() && !clear_selection() && !end_lesson() && !panels_.end_presentation())
    panels_.show_panels();
}

double App::next_wait() {
  const double now = ImGui::GetTime();
  const bool is_busy = work_.engine().status().busy || work_.evolution().is_waiting() || wake_.has_work() ||
                       link_.is_waiting() || screen_.gui.is_about_to_rest() || recording_.holds_input();
  return FrameClock::sleep({demo_.next_due(now), lesson_.next_due(now), work_.computation().next_due(now),
                            work_.evolution().next_due(now), panels_.next_due(now)},
                           is_busy);
}

void App::wait_for_event() {
  GlfwWindow& window = *screen_.window;
  // A notice takes seconds to fade, and the window rests only after that.
  if (window.is_asked_for_rest() && panels_.next_due(ImGui::GetTime())) {
    panels_.end_what_fades();
    screen_.clock.want(1);
    return window.poll();
  }
  const double limit = next_wait();
  const bool is_at_rest = limit == 0.0 && !recording_.holds_input() && !input_.has_waiting_events();
  turns_at_rest_ = is_at_rest ? turns_at_rest_ + 1 : 0;
  if (is_at_rest && window.is_asked_for_rest()) {
    // One more turn shows what another thread has finished since the last results were taken.
    if (turns_at_rest_ < 2) return window.poll();
    tell_parts_out_of_reach();
    window.answer_rest();
  }
  window.wait(limit);
}

bool App::wants_turn() const {
  return screen_.clock.wants_frame() || board_.canvas().views().is_moving();
}

bool App::is_on_panel(Vec2 at) const {
  return screen_.gui.wants_pointer(at * screen_.window->pixel_ratio());
}

bool App::step() {
  if (!screen_.gui.holds_release()) {
    if (wants_turn())
      screen_.window->poll();
    else
      wait_for_event();
  }
  screen_.times.begin();
  turn();
  return !documents_.is_left();
}

void App::run(const Termination& termination) {
  while (!documents_.is_left() && termination.signal() == 0) step();
  end();
}

void App::refuse_for_memory() noexcept try {
  messages_.problem(refusal_for_memory());
  screen_.clock.settle();
} catch (const std::bad_alloc&) {
  // The message does not fit into memory either.
}

// The editor drops an edit that lacks memory completely, so the window can continue.
void App::deliver_events() try {
  input_.deliver();
  work_.editor().catch_up();
} catch (const std::bad_alloc&) {
  refuse_for_memory();
}

// The key holds the update from its press over the canvas until its release. A recording that needs exact pictures
// shows every change with its structures, so it cannot be held.
void App::follow_hold() try {
  const Canvas& canvas = board_.canvas();
  const bool is_down = input_.is_update_held();
  is_held_by_key_ = is_down && (is_held_by_key_ || canvas.is_hovered() || canvas.has_pointer());
  work_.follow_hold(!recording_.recorder().wants_exact_picture(), is_held_by_key_);
} catch (const std::bad_alloc&) {
  refuse_for_memory();
}

// Each result is applied completely or not at all.
void App::take_results() try {
  experiments_.follow();
  link_.follow();
  board_.take_results();
  work_.follow_crust();
  work_.follow_curves(ImGui::IsAnyItemActive());
  work_.follow_resampling();
} catch (const std::bad_alloc&) {
  refuse_for_memory();
}

void App::turn() {
  follow_hold();
  deliver_events();
  documents_.take_results();
  recording_.note_if_complete(documents_.files().is_reading());
  take_results();
  work_.follow_evolution(board_.picture().document_revision(), ImGui::GetTime());
  const bool was_about_to_rest = screen_.gui.is_about_to_rest();
  frame();
  screen_.clock.frame_done();
  // A new tooltip is measured in its first frame and appears in its second.
  if (was_about_to_rest && !screen_.gui.is_about_to_rest()) screen_.clock.settle();
  // A message that no event caused is laid out in one frame and appears in the next.
  if (const std::uint64_t said = messages_.said(); said != said_) {
    said_ = said;
    screen_.clock.settle();
  }
  const auto fade = panels_.next_due(ImGui::GetTime());
  if (screen_.gui.is_fading() || screen_.gui.is_changing_menus() || (fade && *fade <= 0.0)) screen_.clock.want(1);
}

void App::frame() {
  const double before = ImGui::GetTime();
  const auto size = screen_.window->framebuffer_size();
  if (screen_.window->is_minimized() || size.width < 1 || size.height < 1) return;
  screen_.gui.begin_frame(settings_.settings());
  const double seconds = std::clamp(ImGui::GetTime() - before, 0.0, kLongestStep);
  board_.begin_frame(size.width, size.height);
  const Panels::Room room = panels_.draw();
  dialogs_.draw(screen_.gui);
  documents_.follow_dialogs();
  board_.canvas().views().set_insets(room.insets);
  board_.follow();
  take_steps();
  board_.fit(room.legend);
  // Marks are laid out before the view moves on, so they need one more frame after it has come to rest.
  if (board_.canvas().views().is_moving()) screen_.clock.want(1);
  if (!recording_.holds_motion()) board_.canvas().advance(seconds);
  draw();
  screen_.window->swap();
  update_title();
  recording_.follow();
}

// Demo, lesson and animations take their next step when the picture of the previous step is complete.
void App::take_steps() {
  const double now = ImGui::GetTime();
  const auto may_step = [this] {
    return !work_.engine().status().busy && !recording_.holds_input() && !board_.picture().is_painting();
  };
  if (may_step() && work_.computation().advance(now)) screen_.clock.settle();
  if (demo_.advance(now, may_step())) screen_.clock.settle();
  if (lesson_.advance(now, may_step())) screen_.clock.settle();
  work_.engine().set_want_findings(panels_.are_shown());
  const std::size_t unasked = panels_.are_shown() ? kMostSamplesMeasuredUnasked : 0;
  work_.measure_density(panels_.is_seen(PanelPage::sampling) ? std::numeric_limits<std::size_t>::max() : unasked);
  work_.engine().set_want_statistics(panels_.is_seen(PanelPage::statistics));
}

void App::draw() {
  board_.draw({.pointer_px = input_.pointer_px(),
               .hides_pointer = panels_.presenter().hides_pointer(ImGui::GetTime()),
               .is_kept = recording_.recorder().wants_exact_picture()});
  documents_.keep();
  // Reading pixels back waits for their drawing, so its time counts as drawing.
  screen_.times.begin_drawing();
  recording_.picture_drawn(panels_.mark_places());
  screen_.gui.end_frame();
  recording_.panels_drawn();
  screen_.times.end_drawing();
  screen_.times.end();
}

void App::update_title() {
  screen_.window->set_title((work_.editor().is_modified() ? "* " : "") + documents_.files().title() + " - Mesecina");
}

void App::keep_settings() {
  const GlfwWindow& window = *screen_.window;
  const double units = window.content_scale() / window.pixel_ratio();
  const GlfwWindow::Size size = window.windowed_size();
  settings_.settings().window_width = static_cast<int>(std::lround(size.width / units));
  settings_.settings().window_height = static_cast<int>(std::lround(size.height / units));
  // The window may be gone, so a failure cannot be shown.
  static_cast<void>(settings_.save());
}

void App::keep() {
  documents_.keep_on_disk();
  keep_settings();
}

void App::end() {
  documents_.end();
  keep_settings();
  recording_.end();
}

}  // namespace mes
