// SPDX-License-Identifier: GPL-3.0-or-later
// Turns SIGINT, SIGTERM and SIGHUP into calls on a thread of their own, and ends the process within a second.
#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace mes {

/// Guarantees: the first such signal calls `heard`; the second, or the end of `patience` after the first, ends the
/// process by `end_process`, whatever its other threads are doing, with exit code 128 + signal. Signals that are
/// ignored when the object is made stay ignored.
///
/// Make it before any other thread is started, since threads inherit the mask that leaves these signals to it. Make
/// it the last member, since `heard` may be called at once and until the destructor returns. Make it before, and
/// destroy it after, everything that may take long to end.
class SignalWatch {
 public:
  /// Together with the time of `end_process`, less than a second.
  static constexpr std::chrono::milliseconds kPatience{650};

  /// `kPatience`, or MESECINA_PATIENCE in milliseconds: for tests of an orderly end on a machine however busy.
  static std::chrono::milliseconds usual_patience();

  explicit SignalWatch(std::function<void(int)> heard, std::chrono::milliseconds patience = usual_patience());
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  void watch();
  using Clock = std::chrono::steady_clock;
  /// Waits for the next signal; 0 when none arrives in time.
  int wait_until(Clock::time_point end) const;

  std::function<void(int)> heard_;
  std::chrono::milliseconds patience_;
  std::atomic<bool> is_over_ = false;
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::thread thread_;
};

}  // namespace mes
