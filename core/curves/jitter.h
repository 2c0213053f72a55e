// SPDX-License-Identifier: GPL-3.0-or-later
// Moves samples off their curves, like measured data.
#pragma once

#include <cstdint>

#include "core/curves/sampling.h"

namespace mes {

/// Moves each sample by up to `amount` mean spacings, uniformly over a disk. The mean spacing is measured along the
/// chains; without chains it is that of as many points spread evenly over their extent. Equal seeds give equal results.
/// O(n).
void jitter(SampledCurves& samples, double amount, std::uint64_t seed);

}  // namespace mes
