// SPDX-License-Identifier: GPL-3.0-or-later
// The evolution of the window as sessions have it.
#pragma once

#include <cstdint>

#include "core/evolutions/evolution.h"
#include "core/io/session.h"

namespace mes {

/// An evolution that is not known is the first one; a parameter that is not known is passed over, and others are brought
/// into their range.
EvolutionChoice choice_of(const SessionEvolution& evolution);

/// With the document in state `step`.
SessionEvolution session_evolution(const EvolutionChoice& choice, std::uint64_t step);

}  // namespace mes
