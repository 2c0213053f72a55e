// SPDX-License-Identifier: GPL-3.0-or-later
// From the curves of a file to its samples. Private to core/io.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/curves/sampling.h"
#include "core/io/format.h"
#include "core/io/read_job.h"

namespace mes {

/// The samples of the curves, each with its chain as a contour. Coordinates that are nothing but rounding beside the
/// largest become zero. The curves stay with the data. Error: `bad_input` where there is nothing to sample or too much, or a coordinate out of range.
/// Throws `Cancelled`.
Expected<LoadedFile> load_samples(CurveSet curves, const SamplingRequest& request, const std::string& name,
                                  ReadJob& job);

}  // namespace mes
