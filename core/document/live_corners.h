// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of a contour while samples on it come and go.
//
// Smallest use:
//     for (const SampleId id : live_corners(document, contour)) use(id);
#pragma once

#include <vector>

#include "core/document/document.h"

namespace mes {

/// The samples that a contour goes through now, in its order. Those that are not alive are passed over; where a sample
/// then follows itself, around the end of a closed contour too, it is one corner. It may come again later on, where the
/// contour crosses or touches itself. O(samples on the contour).
std::vector<SampleId> live_corners(const Document& document, const CurveOrder::Contour& contour);

}  // namespace mes
