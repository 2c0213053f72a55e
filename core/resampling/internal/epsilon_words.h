// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the change of an epsilon in words.
#pragma once

#include <cmath>
#include <string>

#include "core/graph/explain.h"

namespace mes {

/// "epsilon 0.9 before, 0.2 now"; if both are infinite, one word with the reason.
inline std::string epsilon_words(double before, double now) {
  constexpr const char* kInfinite = "infinite (curve edges are missing)";
  const auto text = [](double epsilon) { return std::isfinite(epsilon) ? number_text(epsilon) : kInfinite; };
  if (!std::isfinite(before) && !std::isfinite(now)) return "epsilon infinite as before (curve edges are missing)";
  return "epsilon " + text(before) + " before, " + text(now) + " now";
}

}  // namespace mes
