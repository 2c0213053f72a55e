// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of things in words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mes {

/// "1 sample", "3 samples". `many` is the plural of what takes no s: "2 vertices", "2 lines are".
inline std::string counted(std::size_t count, std::string_view one, std::string_view many = {}) {
  std::string out = std::to_string(count) + ' ';
  if (count == 1) return out.append(one);
  return many.empty() ? out.append(one) += 's' : out.append(many);
}

}  // namespace mes
