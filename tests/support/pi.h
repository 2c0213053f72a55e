// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace mes::test {

constexpr double kPi = std::numbers::pi;

}  // namespace mes::test
