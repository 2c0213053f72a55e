// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>

namespace mes::test {

/// Factor on the usual number of random cases of a test: the environment variable MESECINA_EFFORT, or 1.
inline std::uint64_t effort() {
  const char* const text = std::getenv("MESECINA_EFFORT");
  const std::uint64_t found = text != nullptr ? std::strtoull(text, nullptr, 10) : 0;
  return found > 0 ? found : 1;
}

}  // namespace mes::test
