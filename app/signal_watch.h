// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT, SIGTERM and SIGHUP as calls on a thread of their own.
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace mes {

/// While it lives, `heard` is called with each such signal, one after the other. Signals that are ignored when it is
/// made stay ignored.
///
/// Make it before any other thread is started: they inherit that these signals are left to it. Make it the last
/// member: `heard` may be called at once, and until the destructor returns.
class SignalWatch {
 public:
  explicit SignalWatch(std::function<void(int)> heard);
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  void watch();

  std::function<void(int)> heard_;
  std::atomic<bool> is_over_ = false;
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::thread thread_;
};

}  // namespace mes
