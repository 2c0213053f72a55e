// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own structures, layers, parameters, evolutions, shapes and file formats, as a registry.
#pragma once

#include "core/graph/registry.h"

namespace mes {

/// Adds them to an empty registry, which may take others afterwards.
void add_builtins(Registry& registry);

/// A registry of these alone, made at the first call.
const Registry& builtins();

}  // namespace mes
