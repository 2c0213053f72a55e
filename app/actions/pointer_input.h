// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons of the mouse and shapes of its pointer, in the program's own terms.
#pragma once

#include <cstdint>

namespace mes {

enum class PointerButton : std::uint8_t { left, middle, right };
enum class PointerShape : std::uint8_t { arrow, crosshair, hand };

}  // namespace mes
