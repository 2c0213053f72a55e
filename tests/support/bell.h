// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

namespace mes::test {

/// Jobs of other threads wake the test through it, instead of the window.
class Bell {
 public:
  /// The function that jobs call. The bell must outlive them.
  std::function<void()> ring() {
    return [this] {
      ++rings_;
      rings_.notify_all();
    };
  }
  /// Waits until the condition holds; tests it first at once, then after each ring.
  template <class Condition>
  void wait_until(Condition condition) {
    for (std::uint64_t heard = rings_; !condition(); heard = rings_) rings_.wait(heard);
  }

 private:
  std::atomic<std::uint64_t> rings_ = 0;
};

}  // namespace mes::test
