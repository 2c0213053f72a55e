// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/typed_number.h"

#include <cmath>

#include "core/formula/formula.h"
#include "core/io/text_numbers.h"

namespace mes {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t") + 1 - from);
}

}  // namespace

std::string unit_in(std::string_view format) {
  std::string out;
  bool is_after = false;
  for (std::size_t i = 0; i < format.size(); ++i) {
    if (format[i] != '%') {
      if (is_after) out += format[i];
    } else if (format.substr(i + 1).starts_with('%')) {
      if (is_after) out += '%';
      ++i;
    } else {
      // The conversion ends with its letter.
      i = format.find_first_of("efgEFG", i);
      if (i == std::string_view::npos) break;
      is_after = true;
    }
  }
  return std::string(trimmed(out));
}

Expected<double> typed_number(std::string_view text, std::string_view unit) {
  text = trimmed(text);
  if (!unit.empty() && text.ends_with(unit)) text = trimmed(text.substr(0, text.size() - unit.size()));
  return number_of(text);
}

Expected<std::uint64_t> typed_count(std::string_view text) {
  text = trimmed(text);
  if (const auto count = parse_count(text)) return *count;
  const auto number = number_of(text);
  if (!number) return std::unexpected(number.error());
  constexpr double kEnd = 0x1p64;
  if (*number < 0.0 || *number >= kEnd || std::trunc(*number) != *number)
    return std::unexpected(Error{ErrorCode::bad_input, "a whole number from 0 to 18446744073709551615 is wanted"});
  return static_cast<std::uint64_t>(*number);
}

}  // namespace mes
