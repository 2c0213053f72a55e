// SPDX-License-Identifier: GPL-3.0-or-later
// From the curves of a file to its samples. Private to core/io.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/curves/sampling.h"
#include "core/io/format.h"
#include "core/io/read_job.h"

namespace mes {

/// The samples of the curves, without cuts (core/curves/cuts.h) and with the regions that lines enclose
/// (core/curves/line_regions.h), each with its chain as a contour. Coordinates that are nothing but rounding beside the
/// largest become zero. The curves stay with the data. Error: `bad_input` where there is nothing to sample or too much, or a coordinate out of range.
/// Throws `Cancelled`. Where the job keeps vertices, these are the samples, whatever is wanted.
Expected<LoadedFile> load_samples(CurveSet curves, const SamplingRequest& wanted, const std::string& name,
                                  ReadJob& job);
/// Samples the curves by `default_sampling`. A warning says how many samples were added between vertices, if any. Curves are
/// also cut along pieces between places for which `on_cut` holds.
Expected<LoadedFile> load_samples(
    CurveSet curves, const std::string& name, ReadJob& job,
    const std::function<bool(Vec2)>& on_cut = [](Vec2) { return false; });

}  // namespace mes
