// SPDX-License-Identifier: GPL-3.0-or-later
// Waiting for what no bell rings for: files, other processes, counters.
#pragma once

#include <chrono>
#include <concepts>
#include <thread>

namespace mes::test {

/// Asks every 5 ms until the condition holds; returns false after five minutes without it.
bool eventually(std::predicate auto condition) {
  using namespace std::chrono_literals;
  for (const auto end = std::chrono::steady_clock::now() + 300s; std::chrono::steady_clock::now() < end;) {
    if (condition()) return true;
    std::this_thread::sleep_for(5ms);
  }
  return condition();
}

}  // namespace mes::test
