// SPDX-License-Identifier: GPL-3.0-or-later
// Which fault is on, in the copy of the tree that scripts/faults.sh makes.
#pragma once

#include <cstdlib>

namespace mes::faults {

/// The number that the environment gives; 0: none is on.
inline const unsigned long chosen = [] {
  const char* const text = std::getenv("MESECINA_FAULT");
  return text == nullptr ? 0UL : std::strtoul(text, nullptr, 10);
}();

}  // namespace mes::faults
