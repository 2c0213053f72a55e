// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of computation and evolutions in the words of the window.
#pragma once

#include <string>
#include <string_view>

#include "core/document/parameter.h"

namespace mes {

/// "smooth-mu" -> "Way to the middle", "a-scale" -> "Inner balls: scale"; an unknown id with spaces for hyphens.
std::string title_of(const Parameter& descriptor);

/// "Scale axis: factor: 99 is above 3, which is taken instead", of a number outside [low, high].
std::string beyond_words(const std::string& title, double number, double low, double high);

/// The explanation as the window gives it: "On: ..., off: ..." of a switch, nothing of numbers that are not seen.
std::string spoken_explanation(const Parameter& descriptor);

}  // namespace mes
