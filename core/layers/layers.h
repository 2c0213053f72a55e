// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the program.
#pragma once

#include "core/graph/registry.h"

namespace mes {

/// Call after all structures are added.
void add_layers(Registry& registry);

}  // namespace mes
