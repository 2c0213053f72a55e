// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace mes {

/// A full turn, in radians.
inline constexpr double kTurn = 2.0 * std::numbers::pi;

}  // namespace mes
