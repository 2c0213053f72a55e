// SPDX-License-Identifier: GPL-3.0-or-later
// Converts samples of curves to document data, which keep the curves.
//
// Smallest use:
//     auto samples = sample(*curves, request);
//     auto data = taken_from(curves, *std::move(samples), request);
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/curve_source.h"
#include "core/document/sample_data.h"

namespace mes {

/// Zeroes coordinates that are only rounding noise beside the largest. Empty, or why a coordinate is out of range.
std::string bring_into_range(std::vector<Vec2>& positions);

/// Document data with the given samples, their chains as contours, and the curves as their source (no source if a
/// number of the curves is not finite). `request` is how the samples were taken. Coordinates that are only rounding
/// noise compared with the largest become zero. Error: `bad_input` for a coordinate out of range. O(samples + pieces).
Expected<SampleData> taken_from(std::shared_ptr<const CurveSet> curves, SampledCurves samples,
                                const SamplingRequest& request);

}  // namespace mes
