// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/typed_number.h"

#include <fmt/core.h>
#include <cmath>

#include "core/formula/formula.h"
#include "core/io/text/text_numbers.h"

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

Expected<std::uint64_t> typed_count(std::string_view text, std::uint64_t low, std::uint64_t high) {
  text = trimmed(text);
  const auto checked = [&](std::optional<std::uint64_t> count) -> Expected<std::uint64_t> {
    if (count && *count >= low && *count <= high) return *count;
    return std::unexpected(
        Error{ErrorCode::bad_input, fmt::format("a whole number from {} to {} is wanted", low, high)});
  };
  if (const auto count = parse_count(text)) return checked(*count);
  const auto number = number_of(text);
  if (!number) return std::unexpected(number.error());
  constexpr double kEnd = 0x1p64;
  if (*number < 0.0 || *number >= kEnd || std::trunc(*number) != *number) return checked(std::nullopt);
  return checked(static_cast<std::uint64_t>(*number));
}

std::optional<std::string> range_fault(double number, const NumberRange& range) {
  const bool is_whole = !range.is_whole || std::trunc(number) == number;
  if (is_whole && number >= range.low && number <= range.high) return std::nullopt;
  const std::string wanted = range.is_whole ? "a whole number" : "a number";
  if (std::isinf(range.low) && std::isinf(range.high)) return wanted + " is wanted";
  if (std::isinf(range.high)) return fmt::format("{} from {} on is wanted", wanted, range.low);
  if (std::isinf(range.low)) return fmt::format("{} up to {} is wanted", wanted, range.high);
  return fmt::format("{} from {} to {} is wanted", wanted, range.low, range.high);
}

}  // namespace mes
