// SPDX-License-Identifier: GPL-3.0-or-later
// Counters that a structure reports, in a fixed order.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace mes {

/// A finite double, an integer, a list of integers, or text. A double that is not finite means "none" (JSON null).
using StatValue = std::variant<std::int64_t, double, std::vector<std::int64_t>, std::string>;

struct Stat {
  std::string key;  ///< snake_case, unit as suffix
  StatValue value;
};

using StatList = std::vector<Stat>;

}  // namespace mes
