// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own registry with one more thing of each kind, as a caller may add them:
//   the structure `doubled-samples`, which reads the parameter `doubling-factor`,
//   the layer `doubled-points`, which shows each sample that many times as far from the origin,
//   the evolution `doubling`, with the parameter `doubling-times`,
//   the shape `test-square`, with the parameter `side`.
#pragma once

#include "core/graph/registry.h"

namespace mes::test {

/// 2 by default.
extern const Parameter kDoublingFactor;
/// How many times as far from the origin a step of the evolution moves each sample; 2 by default.
extern const Parameter kDoublingTimes;

/// Made at the first call.
const Registry& registry_with_additions();
/// Adds all of that to a registry that has the program's sources.
void add_additions(Registry& registry);
/// The same from a registry that has it.
void remove_additions(Registry& registry);

/// Sources and `doubled-points`, and nothing of the program beside them. Made at the first call.
const Registry& registry_of_one_layer();

}  // namespace mes::test
