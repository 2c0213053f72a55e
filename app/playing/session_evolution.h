// SPDX-License-Identifier: GPL-3.0-or-later
// The evolution of the window as sessions have it.
#pragma once

#include <cstdint>
#include <string>

#include "core/evolutions/evolution.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

/// An evolution that the registry lacks is a `missing_evolution`; a parameter that it lacks is kept, and others are brought
/// into their range. Without an id: the first evolution.
EvolutionChoice choice_of(const Registry& registry, const SessionEvolution& evolution);

/// With the document in state `step`.
SessionEvolution session_evolution(const Registry& registry, const EvolutionChoice& choice, std::uint64_t step);

/// The name of the step of undo that brings the document into a state, as "Smooth, 12 steps".
std::string name_of_state(const EvolutionDescriptor& evolution, std::uint64_t step);

}  // namespace mes
