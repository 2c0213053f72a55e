// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for numbers that count when they are left.
#pragma once

#include <cstdint>
#include <string>

namespace mes {

/// Returns true, once, when the field was left with another finite number, which `value` then is. Enter, Tab and a
/// click elsewhere leave it; Esc restores the old number. Threads: the window's.
bool number_field(const char* label, double& value, const char* format);
bool number_field(const char* label, std::uint64_t& value);
/// The same, and an expression such as 2/3 or sqrt(2) can be typed for the number. `refusal` is why what was typed last
/// is refused, until such a field is left again; the field has the keyboard again if Enter left it (`stay_in_field`).
bool number_field(const char* label, double& value, const char* format, std::string& refusal);
/// The same for a formula, which is text here.
bool formula_field(const char* label, const char* hint, std::string& text);
/// The same for a number that a formula can be typed for; `text` is what it shows, with all digits. Where these have no
/// room, a field that is neither edited nor pointed at shows as many as have, and the exponent.
bool exact_field(const char* label, double value, std::string& text);
/// Right after a field of text, when what was typed there is refused: if Enter left it, it has the keyboard again, and
/// shows `typed` for it to be corrected; Esc then restores what it had before.
void stay_in_field(const std::string& typed);

}  // namespace mes
