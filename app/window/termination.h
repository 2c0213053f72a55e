// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT, SIGTERM and SIGHUP ask the window to end in order.
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace mes {

/// What it guarantees: the first such signal is noted and `wake` is called; the second ends the process at once, with
/// exit code 128 + signal. Signals that are ignored when it is made stay ignored.
///
/// Make it before any other thread is started: they inherit that these signals are left to it.
class Termination {
 public:
  explicit Termination(std::function<void()> wake);
  ~Termination();
  Termination(const Termination&) = delete;
  Termination& operator=(const Termination&) = delete;

  /// The signal that asked for it, or 0.
  int signal() const { return signal_; }

 private:
  void watch();

  std::function<void()> wake_;
  std::atomic<int> signal_ = 0;
  std::atomic<bool> is_over_ = false;
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::thread thread_;
};

}  // namespace mes
