// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace mes::test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace mes::test
