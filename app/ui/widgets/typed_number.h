// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the text typed into a field for a number.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// The text after the conversion in a printf format for one number: "%" of "%.0f%%", "px" of "%.1f px".
std::string unit_in(std::string_view format);

/// The number that an expression such as 2/3 or sqrt(2) stands for; `unit` may follow it. Error: as for `number_of`
/// (core/formula/formula.h).
Expected<double> typed_number(std::string_view text, std::string_view unit = {});

/// The same for a whole number from `low` to `high`; one that consists of digits is read exactly. Error: also for a
/// number that is not whole, or out of range.
Expected<std::uint64_t> typed_count(std::string_view text, std::uint64_t low = 0,
                                    std::uint64_t high = std::numeric_limits<std::uint64_t>::max());

/// The permitted range of a number.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool is_whole = false;
};
/// The reason, in one line, why a finite number is out of the range; nothing if it is within.
std::optional<std::string> range_fault(double number, const NumberRange& range);

}  // namespace mes
