// SPDX-License-Identifier: GPL-3.0-or-later
// The names of parameters of computation and evolutions in the window.
#pragma once

#include <string>
#include <string_view>

#include "core/document/settings/parameter.h"

namespace mes {

/// "smooth-mu" -> "Move to the middle", "a-scale" -> "Inner balls: scale"; an unknown id gets spaces for hyphens.
std::string title_of(const Parameter& descriptor);

/// The message for a number outside [low, high]: "Scale axis: factor: 99 is above 3, which is taken instead".
std::string beyond_words(const std::string& title, double number, double low, double high);

/// The explanation for the window: "On: ..., off: ..." for a switch, without references to invisible numbers.
std::string spoken_explanation(const Parameter& descriptor);

}  // namespace mes
