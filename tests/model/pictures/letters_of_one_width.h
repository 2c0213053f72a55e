// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of texts that need no font.
#pragma once

#include <string>

#include "app/picture/paper/paper_drawing.h"

namespace mes::test {

/// Half a size a byte.
inline double half_size_a_byte(const std::string& text, double size, Face /*face*/) {
  return 0.5 * size * static_cast<double>(text.size());
}

/// Six logical pixels a byte.
inline double six_px_a_byte(const std::string& text, double /*size*/, Face /*face*/) {
  return 6.0 * static_cast<double>(text.size());
}

}  // namespace mes::test
