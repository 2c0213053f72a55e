// SPDX-License-Identifier: GPL-3.0-or-later
// Everything with a name in the window, as entries of the palette.
#pragma once

#include <span>
#include <vector>

#include "app/actions/palette.h"
#include "app/window/panels.h"

namespace mes {

/// Actions, bundles, layers, parameters, evolutions, shapes, formats of geometry, recent files and headings of the
/// manual, as they are now. Actions that open one of the panels are called so. The action of an entry uses the members
/// of `uses` when it runs. Cost: O(names).
std::vector<PaletteEntry> palette_entries(const Panels::Uses& uses, std::span<const SidePage> panels);

}  // namespace mes
