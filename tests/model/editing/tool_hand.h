// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that works the tools, in a view in which a pixel is half a unit.
#pragma once

#include "app/canvas/tools/tool.h"

namespace mes::test {

constexpr Modifiers kShift{.shift = true};
constexpr Modifiers kCtrlShift{.ctrl = true, .shift = true};

inline Pointer at_pixel(double x, double y, Modifiers modifiers = {}) {
  return {{x, y}, {0.5 * x, -0.5 * y}, 0.5, modifiers};
}

inline void click(Tool& tool, const Pointer& pointer) {
  tool.hover(pointer);
  tool.press(pointer);
  tool.release(pointer);
}

inline void drag(Tool& tool, const Pointer& from, const Pointer& to) {
  tool.hover(from);
  tool.press(from);
  tool.drag({0.5 * (from.px + to.px), 0.5 * (from.world + to.world), from.units_per_px, from.modifiers});
  tool.drag(to);
  tool.release(to);
}

}  // namespace mes::test
