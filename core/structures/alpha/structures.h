// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/alpha/alpha_complex.h"
#include "core/structures/alpha/alpha_filtration.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_alpha_structures(Registry& registry) {
  registry.add_structure<AlphaFiltration, Delaunay>();
  registry.add_structure<AlphaComplex, SettingsSource, Delaunay, AlphaFiltration>();
}

}  // namespace mes
