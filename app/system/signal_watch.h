// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT, SIGTERM and SIGHUP as calls on a thread of their own, and the end of the process within a second.
#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace mes {

/// What it guarantees: the first such signal calls `heard`; the second, or the end of `patience` after the first,
/// ends the process by `end_process`, whatever its other threads are doing, with exit code 128 + signal. Signals that
/// are ignored when it is made stay ignored.
///
/// Make it before any other thread is started: they inherit that these signals are left to it. Make it the last
/// member: `heard` may be called at once, and until the destructor returns. Make it the first and destroy it the last
/// of what may take long to end.
class SignalWatch {
 public:
  /// With what `end_process` takes, less than a second.
  static constexpr std::chrono::milliseconds kPatience{650};

  /// Or what MESECINA_PATIENCE says, in milliseconds: for tests of what happens in order, however busy the machine is.
  static std::chrono::milliseconds usual_patience();

  explicit SignalWatch(std::function<void(int)> heard, std::chrono::milliseconds patience = usual_patience());
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  void watch();
  using Clock = std::chrono::steady_clock;
  /// The next signal; 0 when it does not come in time.
  int wait_until(Clock::time_point end) const;

  std::function<void(int)> heard_;
  std::chrono::milliseconds patience_;
  std::atomic<bool> is_over_ = false;
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::thread thread_;
};

}  // namespace mes
