// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for numbers that count when they are left.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "app/model/typed_number.h"

namespace mes {

/// An expression such as 2/3 or sqrt(2) can be typed for the number, with the unit of the format or without.
///
/// Returns true, once, when the field was left with another number, which `value` then is. Enter, Tab and a click
/// elsewhere leave it; Esc restores the old number. What has no value is refused, and why is said at the field: if Enter
/// left it, it has the keyboard again (`stay_in_field`), and what is said is about the text as it is being corrected;
/// otherwise the old number is back, and it is said until something is pressed. Threads: the window's.
bool number_field(const char* label, double& value, const char* format);
/// The same, and refused is also what `fault` has words for.
bool number_field(const char* label, double& value, const char* format,
                  const std::function<std::optional<std::string>(double)>& fault);
/// The same, and refused is also what is not in the range.
bool number_field(const char* label, double& value, const char* format, const NumberRange& range);
/// For whole numbers from `low` to `high`, which is not below 0.
bool number_field(const char* label, std::uint64_t& value, std::uint64_t low = 0,
                  std::uint64_t high = std::numeric_limits<std::uint64_t>::max());
bool number_field(const char* label, int& value, int low = 0, int high = std::numeric_limits<int>::max());
/// What is said at a number field now; empty if nothing is.
const std::string& refused_number();
/// For a formula, which is text here; it is left as a number is.
bool formula_field(const char* label, const char* hint, std::string& text);
/// The same for a number that a formula can be typed for; `text` is what it shows, with all digits. Where these have no
/// room, a field that is neither edited nor pointed at shows as many as have, and the exponent.
bool exact_field(const char* label, double value, std::string& text);
/// Right after a field of text, when what was typed there is refused: if Enter left it, it has the keyboard again, and
/// shows `typed` for it to be corrected; Esc then restores what it had before.
void stay_in_field(const std::string& typed);

}  // namespace mes
