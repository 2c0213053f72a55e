// SPDX-License-Identifier: GPL-3.0-or-later
// What happens is kept on the timeline; sessions and recovery bring it back.
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/window/app.h"
#include "core/io/temporary.h"

namespace mes {

namespace {

SessionEvolution evolution_now(const EvolutionPlayer& player) {
  SessionEvolution out{std::string(player.descriptor().id), player.choice().seed, player.position(), {}};
  for (const ParameterDescriptor& parameter : evolution_parameters())
    out.parameters.emplace_back(parameter.id, player.choice().values[parameter.id]);
  return out;
}

// What this version does not know is left at its default.
EvolutionChoice choice_of(const SessionEvolution& evolution) {
  EvolutionChoice out{.evolution = find_evolution(evolution.id).value_or(0), .seed = evolution.seed};
  for (const ParameterDescriptor& parameter : evolution_parameters())
    for (const auto& [id, value] : evolution.parameters)
      if (id == parameter.id) out.values.set(id, std::clamp(value, parameter.low, parameter.high));
  return out;
}

}  // namespace

Session App::session_now() const {
  const Timeline& timeline = editor_.timeline();
  return {.title = files_.title(),
          .data = timeline.data(),
          .entries = timeline.entries(),
          .layers = layers_.configuration(),
          .settings = computation_.settings(),
          .evolution = evolution_now(evolution_),
          .view = canvas_.view().free_box()};
}

void App::show_as_in(const Session& session) {
  if (!session.layers.layers.empty()) layers_.set_configuration(session.layers);
  computation_.set(session.settings);
  const bool is_known = find_evolution(session.evolution.id).has_value();
  evolution_.resume(choice_of(session.evolution), is_known ? session.evolution.step : 0);
  if (!session.view.is_empty()) fit_to_ = session.view;
  editor_.take_layers_as_noted();
  if (files_.has_session_file()) editor_.set_saved_layers(layers_.configuration());
  notes_.take_as_noted(editor_, {computation_.settings(), session.view});
}

// Surroundings are noted when they are at rest: a slider or a zoom under way is not yet what is meant.
void App::keep_timeline() {
  const bool at_rest = !ImGui::IsAnyItemActive() && !canvas_.has_pointer() && !canvas_.view().is_moving() &&
                       fit_wanted_ == Fit::none && !files_.is_reading();
  if (!ImGui::IsAnyItemActive()) editor_.note_layers();
  if (at_rest) notes_.follow(editor_, {computation_.settings(), canvas_.view().free_box()});
  autosave_.follow(editor_, [this] { return session_now(); });
  if (const std::string problem = autosave_.take_problem(); !problem.empty()) messages_.problem(problem);
}

void App::look_for_left_work() {
  left_work_ = std::async(std::launch::async, [folder = default_autosave_folder()] {
    remove_abandoned_scratch();
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
  end_demo(true);
  if (const auto done = files_.recover(work.session()); !done) {
    report(done.error());
    return;
  }
  messages_.remark("Recovered " + files_.title() + "; no file holds it yet");
  leave_document();
  show_as_in(work.session());
  fit_wanted_ = Fit::at_once;
  had_first_file_ = true;
  // What was left goes only when it is safe again.
  keep_timeline();
  autosave_.flush();
  work.remove();
}

}  // namespace mes
