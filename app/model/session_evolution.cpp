// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/session_evolution.h"

#include <algorithm>
#include <string>

namespace mes {

EvolutionChoice choice_of(const SessionEvolution& evolution) {
  EvolutionChoice out{.evolution = find_evolution(evolution.id).value_or(0), .seed = evolution.seed};
  for (const ParameterDescriptor& parameter : evolution_parameters())
    for (const auto& [id, value] : evolution.parameters)
      if (id == parameter.id) out.values.set(id, std::clamp(value, parameter.low, parameter.high));
  return out;
}

SessionEvolution session_evolution(const EvolutionChoice& choice, std::uint64_t step) {
  SessionEvolution out{std::string(evolutions()[choice.evolution].descriptor.id), choice.seed, step, {}};
  for (const ParameterDescriptor& parameter : evolution_parameters())
    out.parameters.emplace_back(parameter.id, choice.values[parameter.id]);
  return out;
}

}  // namespace mes
