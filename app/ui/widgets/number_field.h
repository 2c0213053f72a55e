// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for numbers that take effect when the user leaves them.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "app/ui/widgets/typed_number.h"

namespace mes {

/// The user can also type an expression such as 2/3 or sqrt(2), with or without the unit of the format.
///
/// Returns true once when the user has left the field with another number, and sets `value` to it. Enter, Tab and a
/// click elsewhere leave the field; Esc restores the old number. A text without a value is refused, with the reason
/// at the field: after Enter the field gets the keyboard again (`stay_in_field`), and the message follows the text as
/// it is corrected; otherwise the old number is restored, and the message stays until any press. Threads: the
/// window's.
bool number_field(const char* label, double& value, const char* format);
/// The same, but also refuses numbers for which `fault` returns a reason.
bool number_field(const char* label, double& value, const char* format,
                  const std::function<std::optional<std::string>(double)>& fault);
/// The same, but also refuses numbers out of the range.
bool number_field(const char* label, double& value, const char* format, const NumberRange& range);
/// For whole numbers from `low` to `high`, where `low` is not negative.
bool number_field(const char* label, std::uint64_t& value, std::uint64_t low = 0,
                  std::uint64_t high = std::numeric_limits<std::uint64_t>::max());
bool number_field(const char* label, int& value, int low = 0, int high = std::numeric_limits<int>::max());
/// The present message at a number field; empty if there is none.
const std::string& refused_number();
/// A field for a formula, which is kept as text; it is left as a number field is.
bool formula_field(const char* label, const char* hint, std::string& text);
/// The same for a number that can be typed as a formula; `text` receives all its digits. Without room for these, a
/// field that is neither edited nor pointed at shows as many as fit, and the exponent.
bool exact_field(const char* label, double value, std::string& text);
/// Call it right after a text field whose text is refused: if Enter left it, it gets the keyboard again, and shows
/// `typed` for correction; Esc then restores the text it had before.
void stay_in_field(const std::string& typed);

}  // namespace mes
