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

/// The document's curves after edits that only move samples. One affine map that has moved all live samples of a curve
/// moves the curve, too; for up to three samples it must be a translation. Where contours no longer correspond to the
/// curves, all curves move or none. Null if no curve moves, or for other edits. O(samples of the curves) if those of a curve have all moved, else O(edits, contours).
std::shared_ptr<const CurveSource> source_after_move(const Document& document, std::span<const SampleEdit> edits);

/// Whether the document has curves, and all their live samples are among these. O(samples named, and
/// samples of the curves that were removed earlier).
bool are_all_of_source(const Document& document, std::span<const SampleId> samples);

}  // namespace mes
