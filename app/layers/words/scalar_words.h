// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the numbers that colour layers, as the window shows them.
#pragma once

#include <string>
#include <string_view>

namespace mes {

/// Expands "lambda" to its symbol and meaning; other scalars are words already.
inline std::string spoken_scalar(std::string_view scalar) {
  return scalar == "lambda" ? "\u03BB, radius of the smallest circle around the nearest samples"
                            : std::string(scalar);
}

}  // namespace mes
