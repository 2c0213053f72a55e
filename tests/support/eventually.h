// SPDX-License-Identifier: GPL-3.0-or-later
// Waits for events without a bell: files, other processes, counters.
#pragma once

#include <chrono>
#include <concepts>
#include <thread>

namespace mes::test {

/// Tests the condition every 5 ms until it holds; returns false after five minutes.
bool eventually(std::predicate auto condition) {
  using namespace std::chrono_literals;
  for (const auto end = std::chrono::steady_clock::now() + 300s; std::chrono::steady_clock::now() < end;) {
    if (condition()) return true;
    std::this_thread::sleep_for(5ms);
  }
  return condition();
}

}  // namespace mes::test
