// SPDX-License-Identifier: GPL-3.0-or-later
// Samples the curves of a file. Private to core/io.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/curves/sampling.h"
#include "core/io/format.h"
#include "core/io/text/read_job.h"

namespace mes {

/// Samples the curves, without cuts (core/curves/cuts.h) and with the regions that lines enclose
/// (core/curves/line_regions.h); each chain becomes a contour. Coordinates that are mere rounding errors beside the
/// largest become zero. The data keep the curves. Error: `bad_input` if there is nothing or too much to sample, or for
/// a coordinate out of range. Throws `Cancelled`. If the job keeps vertices, these are the samples, whatever is wanted.
Expected<LoadedFile> load_samples(CurveSet curves, const SamplingRequest& wanted, const std::string& name,
                                  ReadJob& job);
/// Samples the curves by `default_sampling`. A warning gives the number of samples added between vertices, if any.
/// Curves are also cut along pieces between positions for which `on_cut` holds. `added_vertices` are not in the file.
Expected<LoadedFile> load_samples(
    CurveSet curves, const std::string& name, ReadJob& job,
    const std::function<bool(Vec2)>& on_cut = [](Vec2) { return false; }, std::size_t added_vertices = 0);

}  // namespace mes
