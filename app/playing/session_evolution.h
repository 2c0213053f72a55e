// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the evolution of the window from and to sessions.
#pragma once

#include <cstdint>
#include <string>

#include "core/evolutions/evolution.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

/// Reads an evolution. If the registry lacks it, the result is a `missing_evolution`; unknown parameters are kept,
/// and others clamped to their range. Without an id: the first evolution.
EvolutionChoice choice_of(const Registry& registry, const SessionEvolution& evolution);

/// Writes the evolution with the document in state `step`.
SessionEvolution session_evolution(const Registry& registry, const EvolutionChoice& choice, std::uint64_t step);

/// The name of the step of undo that leads to a state, such as "Smooth, 12 steps".
std::string name_of_state(const EvolutionDescriptor& evolution, std::uint64_t step);

}  // namespace mes
