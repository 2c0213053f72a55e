// SPDX-License-Identifier: GPL-3.0-or-later
// The messages for lack of memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "app/editing/selection.h"

namespace mes {

inline constexpr std::string_view kMemoryProblem = "Out of memory: ";

/// States the reason, and a remedy.
inline std::string memory_problem(std::size_t samples, std::size_t balls) {
  const std::string what = counted(samples, balls);
  return std::string(kMemoryProblem) + what + (samples + balls == 1 ? " needs" : " need") +
         " more than is free. Grey layers show the last picture. Undo, hide layers or open a smaller file";
}

/// The message for an edit that was dropped for lack of memory.
inline std::string refusal_for_memory() {
  return std::string(kMemoryProblem) + "that was not done, and nothing is lost. Hide layers or undo, and try again";
}

inline bool is_memory_problem(std::string_view text) {
  return text.starts_with(kMemoryProblem);
}

}  // namespace mes
