// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own registry with one more entry of each kind, added as a caller may add it:
//   the structure `doubled-samples`, which reads the parameter `doubling-factor`,
//   the layer `doubled-points`, which shows each sample that many times as far from the origin,
//   the evolution `doubling`, with the parameter `doubling-times`,
//   the shape `test-square`, with the parameter `side`.
#pragma once

#include "core/graph/registry.h"

namespace mes::test {

/// Default: 2.
extern const Parameter kDoublingFactor;
/// Factor by which a step of the evolution scales the distance of each sample from the origin; default: 2.
extern const Parameter kDoublingTimes;

/// Created at the first call.
const Registry& registry_with_additions();
/// Adds all of the above to a registry that has the program's sources.
void add_additions(Registry& registry);
/// Removes the same from a registry.
void remove_additions(Registry& registry);

/// A registry with only the sources and `doubled-points`. Created at the first call.
const Registry& registry_of_one_layer();

}  // namespace mes::test
