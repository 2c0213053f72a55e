// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/session_panes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/playing/session_evolution.h"
#include "core/base/jobs/job_control.h"
#include "core/evolutions/evolution_states.h"

namespace mes {
namespace {

// for a parameter, whose range contains no more steps
constexpr std::uint64_t kMostPaneSteps = 100'000;

Document before_last_edit(const SessionPanes::Moment& now) {
  Document before = now.document;
  for (const DocumentDelta& back : now.history.way_before_last_edit()) before.apply(back);
  return before;
}

/// The state from which the steps of an evolution are counted.
EvolutionState state_0(const SessionPanes::Moment& now) {
  return state_of(now.history.last_edit_is_state() ? before_last_edit(now) : now.document);
}

/// State 0 of a parameter: its default, if steps from there lead to the value, as in a window that opens the session.
double first_value(const ParameterMove& move, double value, const EvolutionChoice& choice, std::uint64_t steps) {
  const double first = move.parameter.default_value;
  for (std::uint64_t k = 1; k <= steps; ++k) {
    const auto moved = moved_value(move, first, k, choice.values);
    if (!moved) break;
    if (*moved == value) return first;
  }
  return value;
}

}  // namespace

SessionPanes::SessionPanes(const Registry& registry, const Session& session)
    : registry_(registry),
      evolution_(choice_of(registry, session.evolution)),
      steps_(std::min(session.evolution.step, kMostPaneSteps)),
      views_(session.pane_views) {
  list_.set(session.panes);
  list_.resolve(registry);
  // Missing views of a session in memory mean everything.
  if (!views_.empty()) views_.resize(list_.panes().size());
}

std::vector<PaneRequest> SessionPanes::requests(const Moment& now) const {
  PaneEvolution evolution{.choice = evolution_};
  if (const ParameterMove* const move = evolution_.moved_parameter(); move != nullptr)
    evolution.first = first_value(*move, now.settings[move->parameter], evolution_, steps_);
  const ShownPanes shown = shown_panes(registry_, list_, now.layers, now.settings, evolution);
  const auto data = std::make_shared<const SampleData>(data_of(now.document));
  EvolutionStates states(state_0(now), evolution_);
  std::vector<std::shared_ptr<const SampleData>> versions;
  std::vector<std::string> problems(shown.versions.size());
  for (const std::optional<VersionChoice>& version : shown.versions) {
    if (!version) {
      versions.push_back(nullptr);
    } else if (const auto* const evolved = std::get_if<EvolvedChoice>(&*version); evolved != nullptr) {
      JobControl job;
      const auto state = states.at(evolved->step, job);
      if (!state) problems[versions.size()] = state.error().text;
      versions.push_back(std::make_shared<const SampleData>(state ? version_of(*data, **state) : SampleData{}));
    } else {
      versions.push_back(std::make_shared<const SampleData>(data_of(before_last_edit(now))));
    }
  }
  const FamilyKind family =
      family_of(now.layers.descriptors(), now.layers.configuration()).value_or(FamilyKind::inner);
  auto out = pane_requests({shown, now.layers, now.settings, words_of(list_, {now.settings, family})}, data,
                           [&](std::size_t pane) -> std::shared_ptr<const SampleData> {
                             const VariantIndex variant = shown.variant[pane];
                             return variant == kMainVariant ? nullptr : versions[variant - 1];
                           });
  for (std::size_t i = 1; i < out.size(); ++i)
    if (const VariantIndex variant = shown.variant[i - 1]; variant != kMainVariant && !problems[variant - 1].empty())
      out[i].words += ": " + problems[variant - 1];
  return out;
}

}  // namespace mes
