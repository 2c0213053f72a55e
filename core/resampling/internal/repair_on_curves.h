// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts samples on the curves from which the others were taken.
#pragma once

#include <optional>

#include "core/resampling/repair.h"

namespace mes {

/// The result of `repair`, if the data know the curves of their samples and at least half of the samples lie on them;
/// otherwise nothing. Error: as `repair`.
Expected<std::optional<Repair>> repair_on_curves(const Registry& registry, const SampleData& data, double epsilon,
                                                 JobControl& job);

}  // namespace mes
