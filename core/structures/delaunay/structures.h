// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/delaunay/last_change.h"
#include "core/structures/inputs/samples.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_delaunay_structures(Registry& registry) {
  registry.add_structure<Delaunay, Samples>();
  registry.add_structure<LastChange, Delaunay>();
}

}  // namespace mes
