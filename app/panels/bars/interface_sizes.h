// SPDX-License-Identifier: GPL-3.0-or-later
// The sizes of panels and their text on offer, in percent of the desktop's.
#pragma once

#include <array>
#include <cmath>

#include "app/settings/settings.h"

namespace mes {

inline constexpr std::array<int, 6> kInterfacePercents{75, 100, 125, 150, 175, 200};

inline bool has_interface_size(const Settings& settings, int percent) {
  return std::abs(settings.interface_scale - percent / 100.0) < 0.01;
}

}  // namespace mes
