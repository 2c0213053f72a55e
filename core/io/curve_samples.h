// SPDX-License-Identifier: GPL-3.0-or-later
// Samples the curves of a file. Private to core/io.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>

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
/// Places on curves of a map.
struct MapPlaces {
  std::set<std::pair<double, double>> on_cut{};  ///< curves are also cut along pieces between two of these
  std::set<std::pair<double, double>> added{};   ///< vertices that are not in the file, since a line is bent there
};

/// Samples the curves by `default_sampling`. A warning gives the number of samples added between vertices, if any. The
/// curves that are kept have no corners at added vertices.
Expected<LoadedFile> load_samples(CurveSet curves, const std::string& name, ReadJob& job,
                                  const MapPlaces& places = {});

}  // namespace mes
