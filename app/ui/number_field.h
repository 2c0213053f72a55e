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
/// The same for a formula, which is text here.
bool formula_field(const char* label, const char* hint, std::string& text);

}  // namespace mes
