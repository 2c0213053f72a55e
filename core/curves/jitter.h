// SPDX-License-Identifier: GPL-3.0-or-later
// Samples off their curves, as measured ones are.
#pragma once

#include <cstdint>

#include "core/curves/sampling.h"

namespace mes {

/// Moves each sample by up to `amount` mean spacings, evenly over a disk. The mean spacing is that along the chains;
/// without chains that of as many points spread evenly over their extent. Equal seeds give equal results. O(n).
void jitter(SampledCurves& samples, double amount, std::uint64_t seed);

}  // namespace mes
