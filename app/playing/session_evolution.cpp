// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/session_evolution.h"

#include <fmt/core.h>
#include <algorithm>
#include <map>
#include <string>

#include "core/base/counted.h"
#include "core/graph/registry.h"

namespace mes {

EvolutionChoice choice_of(const Registry& registry, const SessionEvolution& evolution) {
  const auto all = registry.evolutions().all();
  EvolutionChoice out{.evolution = registry.evolutions().find(evolution.id), .seed = evolution.seed};
  if (evolution.id.empty() && !all.empty()) out.evolution = all.front();
  if (!out.evolution) out.evolution = missing_evolution(evolution.id);
  for (const auto& [id, value] : evolution.parameters) out.values.keep(id, value);
  for (const Parameter& parameter : parameters_of(all))
    for (const auto& [id, value] : evolution.parameters)
      if (id == parameter.id) out.values[parameter] = std::clamp(value, parameter.low, parameter.high);
  return out;
}

SessionEvolution session_evolution(const Registry& registry, const EvolutionChoice& choice, std::uint64_t step) {
  SessionEvolution out{choice.evolution->descriptor.id, choice.seed, step, {}};
  std::map<std::string, double> parameters;
  for (const Parameter& parameter : parameters_of(registry.evolutions().all()))
    parameters[parameter.id] = choice.values[parameter];
  // Keeps to the maximum number of a session.
  for (const ParameterValues::Entry& entry : choice.values.changed())
    if (parameters.size() < kMostSessionParameters) parameters.try_emplace(entry.id, entry.value);
  out.parameters.assign(parameters.begin(), parameters.end());
  return out;
}

std::string name_of_state(const EvolutionDescriptor& evolution, std::uint64_t step) {
  return fmt::format("{}, {}", evolution.name, counted(step, "step"));
}

}  // namespace mes
