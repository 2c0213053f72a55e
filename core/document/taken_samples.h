// SPDX-License-Identifier: GPL-3.0-or-later
// From samples of curves to data of a document, which keep the curves.
//
// Smallest use:
//     auto samples = sample(*curves, request);
//     auto data = taken_from(curves, *std::move(samples), request);
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/commands.h"
#include "core/document/curve_source.h"

namespace mes {

/// Makes coordinates zero that are nothing but rounding beside the largest. Empty, or why some coordinate is out of range.
std::string bring_into_range(std::vector<Vec2>& positions);

/// The samples, which were taken of these curves as the request says, with their chains as contours, and the curves as their source; without a source where a number of the
/// curves is not finite. Coordinates that are nothing but rounding beside the largest become zero. Error: `bad_input`
/// for a coordinate out of range. O(samples + pieces).
Expected<SampleData> taken_from(std::shared_ptr<const CurveSet> curves, SampledCurves samples,
                                const SamplingRequest& request);

}  // namespace mes
