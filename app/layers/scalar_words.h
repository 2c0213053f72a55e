// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that layers are coloured by, in the words of the window.
#pragma once

#include <string>
#include <string_view>

namespace mes {

/// "lambda" is the symbol with its meaning; other scalars are words already.
inline std::string spoken_scalar(std::string_view scalar) {
  return scalar == "lambda" ? "\u03BB, radius of the smallest circle around the nearest samples"
                            : std::string(scalar);
}

}  // namespace mes
