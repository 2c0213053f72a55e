// SPDX-License-Identifier: GPL-3.0-or-later
// `operator new` of this executable: counts what is in use, and fails when asked to.
#pragma once

#include <catch2/catch.hpp>
#include <cstddef>

namespace mes::test {

/// Bytes in use now, and the most since `watch_memory`.
std::size_t memory_in_use();
std::size_t peak_of_memory();
void watch_memory();

/// While it lives, the allocation number `call` (0: the first) of all threads fails, and with `and_later` all after
/// it.
class FailingMemory {
 public:
  explicit FailingMemory(long call, bool and_later = false);
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;
  /// Whether the call came.
  bool has_failed() const;
};

/// Calls `attempt` with the first allocation failing, the second, and so on until it gets by without; how many
/// failed.
template <class Attempt>
int with_each_allocation_failing(const Attempt& attempt) {
  for (int call = 0;; ++call) {
    REQUIRE(call < 100'000);
    INFO("allocation " << call);
    if (!attempt(call)) return call;
  }
}

}  // namespace mes::test
