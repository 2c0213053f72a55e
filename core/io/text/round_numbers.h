// SPDX-License-Identifier: GPL-3.0-or-later
// Round numbers for scales, and numbers as text with just enough digits to distinguish them.
#pragma once

#include <string>

namespace mes {

std::string shortest_text(double value, int digits);

/// Uses as many digits as distinguish steps of that size, and no exponent if that is short.
std::string number_text(double value, double step);

/// The least of 1, 2 and 5 times a power of ten that is at least `least`, which must be positive.
double round_number_from(double least);
/// The largest one that is at most `most`, which must be positive.
double round_number_up_to(double most);

}  // namespace mes
