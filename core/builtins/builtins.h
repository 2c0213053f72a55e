// SPDX-License-Identifier: GPL-3.0-or-later
// Registry of the program's own structures, layers, parameters, evolutions, shapes and file formats.
#pragma once

#include "core/graph/registry.h"

namespace mes {

/// Adds the built-in entries to an empty registry; others may be added afterwards.
void add_builtins(Registry& registry);

/// A registry with only these entries, created at the first call.
const Registry& builtins();

}  // namespace mes
