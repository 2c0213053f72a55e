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

/// The text with the ids of the program's parameters replaced by their titles in quotes: "twice lambda-limit" ->
/// "twice \"Lambda: limit\"". An id of one word stays, since the word may mean something else.
std::string with_titles(std::string text);

/// The explanation for the window: "On: ..., off: ..." for a switch, without references to invisible
/// numbers, with titles instead of ids.
std::string spoken_explanation(const Parameter& descriptor);

}  // namespace mes
