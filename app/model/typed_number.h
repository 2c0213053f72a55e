// SPDX-License-Identifier: GPL-3.0-or-later
// What is typed into a field for a number.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// What a printf format for one number has after it: "%" of "%.0f%%", "px" of "%.1f px".
std::string unit_in(std::string_view format);

/// The number that an expression such as 2/3 or sqrt(2) stands for; `unit` may stand after it. Error: as for `number_of`
/// (core/formula/formula.h).
Expected<double> typed_number(std::string_view text, std::string_view unit = {});

/// The same for a whole number from `low` to `high`; one of digits alone is taken exactly. Error: also one that is not
/// whole, or is outside.
Expected<std::uint64_t> typed_count(std::string_view text, std::uint64_t low = 0,
                                    std::uint64_t high = std::numeric_limits<std::uint64_t>::max());

/// What a number may be.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool is_whole = false;
};
/// Why a finite number is refused that is outside of the range, one line; nothing for one that is in it.
std::optional<std::string> range_fault(double number, const NumberRange& range);

}  // namespace mes
