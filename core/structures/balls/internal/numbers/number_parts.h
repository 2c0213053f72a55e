// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over rows whose work is done in numbers of a kernel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "core/base/jobs/parallel.h"

namespace mes {

/// Splits loops into parts that run in parallel if all numbers are doubles. Numbers of other kinds belong to one
/// thread, so there is one part for these.
template <class... Numbers>
struct NumberParts {
  static constexpr bool kIsDouble = (std::is_same_v<Numbers, double> && ...);

  static std::size_t part_count(std::size_t count) {
    return kIsDouble ? std::clamp<std::size_t>(count >> 12U, 1, 8) : 1;
  }
  /// Calls `body(begin, end, part)` for the parts of [0, count). The split depends on `count` alone.
  template <class Body>
  static void in_parts(std::size_t count, Body body) {
    const std::size_t parts = part_count(count);
    run_tasks(parts, [&](std::size_t part) { body(count * part / parts, count * (part + 1) / parts, part); });
  }
  /// Calls both, in parallel if `count` rows are worth it.
  template <class First, class Second>
  static void both(std::size_t count, First first, Second second) {
    if (part_count(count) > 1) {
      run_tasks(2, [&](std::size_t task) { task == 0 ? first() : second(); });
    } else {
      first();
      second();
    }
  }
};

}  // namespace mes
