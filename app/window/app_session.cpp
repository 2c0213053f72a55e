// SPDX-License-Identifier: GPL-3.0-or-later
// What happens is kept on the timeline; sessions and recovery bring it back.
#include <chrono>
#include <utility>

#include "app/window/app.h"

namespace mes {

Session App::session_now() const {
  const Timeline& timeline = editor_.timeline();
  return {.title = files_.title(),
          .data = timeline.data(),
          .entries = {timeline.entries().begin(), timeline.entries().end()},
          .layers = layers_.configuration(),
          .settings = computation_,
          .view = canvas_.view().free_box()};
}

void App::show_as_in(const Session& session) {
  if (!session.layers.layers.empty()) layers_.set_configuration(session.layers);
  set_computation(session.settings);
  if (!session.view.is_empty()) fit_to_ = session.view;
  notes_.take_as_noted(editor_, {layers_, computation_, session.view});
}

// Surroundings are noted when they are at rest: a slider or a zoom under way is not yet what is meant.
void App::keep_timeline() {
  const bool at_rest = !ImGui::IsAnyItemActive() && !canvas_.has_pointer() && !canvas_.view().is_moving() &&
                       fit_wanted_ == Fit::none && !files_.is_reading();
  if (at_rest) notes_.follow(editor_, {layers_, computation_, canvas_.view().free_box()});
  autosave_.follow(editor_, [this] { return session_now(); });
  if (const std::string problem = autosave_.take_problem(); !problem.empty()) messages_.problem(problem);
}

void App::look_for_left_work() {
  left_work_ = std::async(std::launch::async, [folder = default_autosave_folder()] {
    FoundWork found = find_left_work(folder);
    GlfwWindow::wake();
    return found;
  });
}

void App::offer_left_work() {
  if (!left_work_.valid() || left_work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  FoundWork found = left_work_.get();
  if (!found.message.empty()) messages_.problem(found.message);
  ask_recover_.offer(std::move(found.works));
  on_anything();
}

void App::recover(LeftWork work) {
  if (const auto done = files_.recover(work.session()); !done) {
    report(done.error());
    return;
  }
  messages_.remark("Recovered " + files_.title() + "; no file holds it yet");
  show_as_in(work.session());
  fit_wanted_ = Fit::at_once;
  had_first_file_ = true;
  // What was left goes only when it is safe again.
  keep_timeline();
  autosave_.flush();
  work.remove();
}

}  // namespace mes
