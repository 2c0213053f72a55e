// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a ball in the regular triangulation of its family.
#pragma once

#include <cstdint>

namespace mes {

enum class BallState : std::uint8_t {
  none,       ///< not a ball
  visible,    ///< has a cell in the power diagram, and a neighbour in the dual complex
  isolated,   ///< has a cell, and no neighbour in the dual complex
  hidden,     ///< has no cell
  duplicate,  ///< duplicate of another ball
};

}  // namespace mes
