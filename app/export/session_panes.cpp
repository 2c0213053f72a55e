// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/session_panes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/model/session_evolution.h"
#include "core/base/job_control.h"
#include "core/evolutions/evolution_states.h"

namespace mes {
namespace {

SampleData before_last_edit(const SessionPanes::Moment& now) {
  Document before = now.document;
  for (const DocumentDelta& back : now.history.way_before_last_edit()) before.apply(back);
  return data_of(before);
}

}  // namespace

SessionPanes::SessionPanes(const Session& session)
    : evolution_(choice_of(session.evolution)), views_(session.pane_views) {
  list_.set(session.panes);
  // What a session in memory lacks is everything.
  if (!views_.empty()) views_.resize(list_.panes().size());
}

Expected<std::vector<PaneRequest>> SessionPanes::requests(const Moment& now) const {
  PaneEvolution evolution{.choice = evolution_};
  if (const ParameterMove* const move = evolutions()[evolution_.evolution].moved_parameter(); move != nullptr)
    evolution.first = now.settings[move->parameter];
  const ShownPanes shown = shown_panes(list_, now.layers, now.settings, evolution);
  const auto data = std::make_shared<const SampleData>(data_of(now.document));
  EvolutionStates states(state_of(now.document), evolution_);
  std::vector<std::shared_ptr<const SampleData>> versions;
  for (const std::optional<VersionChoice>& version : shown.versions) {
    if (!version) {
      versions.push_back(nullptr);
    } else if (const auto* const evolved = std::get_if<EvolvedChoice>(&*version); evolved != nullptr) {
      JobControl job;
      const auto state = states.at(evolved->step, job);
      if (!state) return std::unexpected(state.error());
      versions.push_back(std::make_shared<const SampleData>(version_of(*data, **state)));
    } else {
      versions.push_back(std::make_shared<const SampleData>(before_last_edit(now)));
    }
  }
  const FamilyKind family = family_of(now.layers.configuration()).value_or(FamilyKind::inner);
  return pane_requests({shown, now.layers, now.settings, words_of(list_, {now.settings, family})}, data,
                       [&](std::size_t pane) -> std::shared_ptr<const SampleData> {
                         const VariantIndex variant = shown.variant[pane];
                         return variant == kMainVariant ? nullptr : versions[variant - 1];
                       });
}

}  // namespace mes
