// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that follow their samples, if these are moved, turned or scaled as a whole.
//
// Smallest use:
//     if (auto source = source_after_move(document, delta.edits)) delta.source_after = source;
#pragma once

#include <memory>
#include <span>

#include "core/base/ids.h"
#include "core/document/curve_source.h"
#include "core/document/delta.h"

namespace mes {

class Document;

/// The document's curves after these edits, if they move samples and do nothing else: a curve whose samples have all
/// moved, by one affine map, is moved by the same map. Up to three samples of a curve have moved by one map only if all
/// have moved by the same vector. If a contour cannot be matched with its curve, all curves move or none. Null if no
/// curve moves. O(samples of the curves) if those of a curve have all moved, else O(edits, contours).
std::shared_ptr<const CurveSource> source_after_move(const Document& document, std::span<const SampleEdit> edits);

/// Whether the document has curves whose samples, as far as they are left, are all among these. O(samples named, and
/// samples of the curves that were removed earlier).
bool are_all_of_source(const Document& document, std::span<const SampleId> samples);

}  // namespace mes
