// SPDX-License-Identifier: GPL-3.0-or-later
// Samples inserted on the curves that others were taken from.
#pragma once

#include <optional>

#include "core/resampling/repair.h"

namespace mes {

/// Where the data know the curves of their samples, and at least half of these lie on them: what `repair` gives. Nothing
/// otherwise. The same errors.
Expected<std::optional<Repair>> repair_on_curves(const Registry& registry, const SampleData& data, double epsilon,
                                                 JobControl& job);

}  // namespace mes
