// SPDX-License-Identifier: GPL-3.0-or-later
// Round numbers for scales, and numbers as text with no more digits than tell them apart.
#pragma once

#include <string>

namespace mes {

std::string shortest_text(double value, int digits);

/// With as many digits as distinguish steps of that size; without an exponent if that is short.
std::string number_text(double value, double step);

/// The least of 1, 2 and 5 times a power of ten that is not below `least`, which is positive.
double round_number_from(double least);
/// The largest that is not above `most`, which is positive.
double round_number_up_to(double most);

}  // namespace mes
