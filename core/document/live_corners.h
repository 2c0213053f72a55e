// SPDX-License-Identifier: GPL-3.0-or-later
// The live part of a contour, while samples on it are added and removed.
//
// Smallest use:
//     for (const SampleId id : live_corners(document, contour)) use(id);
#pragma once

#include <vector>

#include "core/document/document.h"

namespace mes {

/// The samples that a contour visits now, in its order. Dead samples are skipped; repeats that become adjacent, also
/// around the end of a closed contour, count as one corner. A sample may occur again later where the contour crosses or
/// touches itself. O(samples on the contour).
std::vector<SampleId> live_corners(const Document& document, const CurveOrder::Contour& contour);

}  // namespace mes
