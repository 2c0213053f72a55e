// SPDX-License-Identifier: GPL-3.0-or-later
// What an element of the picture is, what it comes from and what it made.
#pragma once

#include <functional>
#include <vector>

#include "core/draw/provenance.h"
#include "core/graph/structure.h"

namespace mes {

/// Defined beside the structures, which only it knows by name.
///
/// Reads only structures for which `is_current` holds; the others are passed over in silence. Empty when the row is
/// dead. O(size of the neighbourhood), O(n) where rows are found by looking at all.
std::vector<ProvenanceLine> explain(const StructureSet& set, const std::function<bool(const Structure&)>& is_current,
                                    const Element& element);

}  // namespace mes
