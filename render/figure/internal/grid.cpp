// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/internal/grid.h"

#include <array>
#include <charconv>

namespace mes::figure {

void append_decimal(std::string& out, double value, int decimals) {
  constexpr double kMost = 1e9;
  const auto steps = static_cast<std::int64_t>(power_of_ten(decimals));
  std::int64_t number = std::llround(std::clamp(value, -kMost, kMost) * static_cast<double>(steps));
  if (number < 0) {
    out += '-';
    number = -number;
  }
  std::array<char, 24> digits{};
  const auto whole = std::to_chars(digits.data(), digits.data() + digits.size(), number / steps);
  out.append(digits.data(), whole.ptr);
  std::int64_t rest = number % steps;
  if (rest == 0) return;
  out += '.';
  for (std::int64_t digit = steps / 10; rest != 0; digit /= 10) {
    out += static_cast<char>('0' + rest / digit);
    rest %= digit;
  }
}

}  // namespace mes::figure
