// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text/round_numbers.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace mes {
namespace {

// Logarithms of powers of ten may be computed just below whole numbers.
constexpr double kRounding = 1e-9;

double power_of_ten_up_to(double value) {
  return std::pow(10.0, std::floor(std::log10(value) + kRounding));
}

}  // namespace

std::string shortest_text(double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

std::string number_text(double value, double step) {
  if (std::abs(value) < 0.5 * step || value == 0.0) return "0";
  constexpr double kMostDigits = 17.0;
  constexpr double kMostPlain = 6.0;
  const double before_point = std::floor(std::log10(std::abs(value)) + kRounding) + 1.0;
  const double after_point = step > 0.0 ? -std::floor(std::log10(step) + kRounding) : 0.0;
  const double least = before_point <= kMostPlain ? before_point : 1.0;
  const double digits = std::clamp(before_point + after_point, std::max(least, 1.0), kMostDigits);
  return shortest_text(value, static_cast<int>(digits));
}

double round_number_from(double least) {
  const double power = power_of_ten_up_to(least);
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= (1.0 - kRounding) * least) return factor * power;
  return 10.0 * power;
}

double round_number_up_to(double most) {
  const double power = power_of_ten_up_to(most);
  for (const double factor : {5.0, 2.0})
    if (factor * power <= (1.0 + kRounding) * most) return factor * power;
  return power;
}

}  // namespace mes
