// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of things in words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mes {

/// A whole number with its digits in groups of three: "12,345".
inline std::string grouped(std::size_t number) {
  std::string out = std::to_string(number);
  for (auto i = static_cast<std::ptrdiff_t>(out.size()) - 3; i > 0; i -= 3)
    out.insert(static_cast<std::size_t>(i), 1, ',');
  return out;
}

/// "1 sample", "3 samples", "1,551 samples". `many` is the plural of what takes no s: "2 vertices", "2 lines are".
inline std::string counted(std::size_t count, std::string_view one, std::string_view many = {}) {
  std::string out = grouped(count) + ' ';
  if (count == 1) return out.append(one);
  return many.empty() ? out.append(one) += 's' : out.append(many);
}

}  // namespace mes
