// SPDX-License-Identifier: GPL-3.0-or-later
// The limit on the density of samples by local feature size.
#pragma once

namespace mes {

/// Corners would require infinitely many samples. So no part of the curves gets more than this many times the density
/// of `SamplingRequest::count` samples spread evenly along the curves.
inline constexpr double kFinestFeature = 1000.0;

}  // namespace mes
