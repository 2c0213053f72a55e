// SPDX-License-Identifier: GPL-3.0-or-later
// How dense samples by local feature size may become.
#pragma once

namespace mes {

/// Corners would ask for infinitely many samples. There are so many times as many as `SamplingRequest::count` gives, evenly
/// along the curves, and nowhere more.
inline constexpr double kFinestFeature = 1000.0;

}  // namespace mes
